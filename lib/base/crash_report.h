// Where a fatal signal found the program: what the handlers of the judge's probe and of the preview's workers share.
// All but crash_watch may be called from a signal handler.
#ifndef PHOTONLAB_BASE_CRASH_REPORT_H
#define PHOTONLAB_BASE_CRASH_REPORT_H

#include <stdbool.h>
#include <stddef.h>

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

#define CRASH_FRAMES 64
// The return addresses that lead to `place`, innermost first, without the handler's own. How many; 0 where the system
// cannot tell. Over a broken stack it may crash: say first what is known.
int crash_frames(const char *place, void *frames[CRASH_FRAMES]);

#endif
