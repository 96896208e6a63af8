// Where a fatal signal found the program, and in words for the person who wrote the code.
#pragma once

#include <stdbool.h>
#include <stddef.h>

// ---- in the process that dies: all but crash_watch may be called from a signal handler ----

typedef struct {
    int signal, reason;         // reason: errno, from before
    unsigned long long address; // that was touched, where the signal has one
    long long syscall;          // that was forbidden, −1: none
    char *place;                // the instruction; NULL where this system's way to tell is not known
    bool stack_far;             // it touched what lies below the stack: a recursion without end, too large an array
    unsigned long long peak_kb; // crash_peak_kb
} Crash;

// Each of these signals is told, on a stack of its own, as the usual one may be what ran out; then the process ends with
// 128 + signal. A second one ends it at once. To be called not far from where the stack begins.
void crash_watch(void (*tell)(const Crash *crash), const int *signals, size_t count);

// The most memory that the process has had, kB; 0 where the system does not tell.
unsigned long long crash_peak_kb(void);

// A place on the way to a crash.
typedef struct {
    const char *object, *symbol; // the file that the code was loaded from; the function's name, NULL: unknown
    const void *function;        // where it begins; NULL: unknown
    unsigned long long offset;   // in the object: of the instruction, or, one less than where it returns to, of a call
} CrashPlace;

// Tells of the instruction at `place` (NULL: unknown) and of the calls that led to it, innermost first, without the
// handler's own. Over a broken stack finding these may crash: what is known should be said as it comes.
void crash_walk(const char *place, void (*take)(const CrashPlace *place));

// The innermost of these places that lies in objects of one folder: in a student's steps.
typedef struct {
    char object[1024], symbol[128]; // object "": there is none
    const void *function;
    // Of the place, and of the next one in that object, 0: none. Where the first is a stub by which it calls the library, that
    // has no line, the next one has.
    unsigned long long offset, caller;
    bool calls_itself; // further out its function stands again
} InnerPlace;
// Takes a place of crash_walk. True: it is the innermost. `folder` ends with a slash.
bool crash_take_inner(InnerPlace *inner, const CrashPlace *place, const char *folder);

// ---- in words, by another process ----

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
