// A crash in words for the person who wrote the code: what happened, and in which line.
#ifndef PHOTONLAB_BASE_CRASH_WORDS_H
#define PHOTONLAB_BASE_CRASH_WORDS_H

#include <stddef.h>

typedef struct {
    char function[128];
    char file[256]; // without its folder
    int line;       // 0: unknown
} SourcePlace;

// Takes apart what `addr2line -f -i` says: two lines a place, the function and FILE:LINE, innermost first. Leaves out
// what has no name, and places in headers: those are the library's, built into the step. How many places.
int crash_places(const char *text, SourcePlace *places, int most);

// What a fatal signal says. `place`: " in reflect, line 7", or "".
void crash_describe_signal(int number, unsigned long long address, const char *place, char *text, size_t size);

// The stack overflowed, in this function; `caller`: who calls itself. Either may be NULL.
void crash_describe_stack(const char *function, const char *caller, char *text, size_t size);

#endif
