#define _GNU_SOURCE // dladdr
#include "preview/run/worker.h"
#include "base/crash_report.h"

#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char student[4096]; // the folder that their objects come from, with its slash
static bool over;
static unsigned long long peak_before; // kB

static void copy_text(char *to, const char *from, size_t size)
{
    size_t length = from ? strlen(from) : 0;
    length = length < size ? length : size - 1;
    memcpy(to, from ? from : "", length);
    to[length] = '\0';
}

// Fills in the place if it lies in the student's code. `exact`: the very instruction; otherwise a return address, which
// is one behind the call.
static bool find_place(WireCrash *crash, char *place, bool exact, void **function)
{
    Dl_info info;
    if (!student[0] || !dladdr(place, &info) || !info.dli_fname ||
        strncmp(info.dli_fname, student, strlen(student)) != 0)
        return false;
    *function = info.dli_saddr;
    if (crash->object[0])
        return true; // a place farther in was found before
    crash->offset = (unsigned long long)(place - (char *)info.dli_fbase - !exact);
    copy_text(crash->object, info.dli_fname, sizeof crash->object);
    copy_text(crash->symbol, info.dli_sname, sizeof crash->symbol);
    return true;
}

static void find_frames(WireCrash *crash, char *place, void *inner)
{
    void *frames[CRASH_FRAMES], *function = NULL;
    int count = crash_frames(place, frames);
    for (int i = 0; i < count; i++) {
        if (!find_place(crash, frames[i], false, &function))
            continue;
        crash->calls_itself = crash->calls_itself || (inner && function == inner);
        inner = inner ? inner : function;
    }
}

static void tell(WireCrash *crash, char *place)
{
    if (worker_is_sending())
        return;
    void *inner = NULL;
    if (place)
        find_place(crash, place, true, &inner);
    worker_send(WIRE_CRASH, crash, sizeof *crash); // over a broken stack the way up may not be found
    find_frames(crash, place, inner);
    worker_send(WIRE_CRASH, crash, sizeof *crash);
}

static void tell_signal(const Crash *at)
{
    static WireCrash crash;
    crash.signal = at->signal;
    crash.stack_far = at->stack_far;
    crash.refused = at->reason == ENOMEM;
    crash.grown_kb = at->peak_kb > peak_before ? at->peak_kb - peak_before : 0;
    crash.address = at->address;
    tell(&crash, at->place);
}

static void on_exit_call(void)
{
    static WireCrash crash;
    if (over)
        return;
    tell(&crash, NULL);
    fflush(stdout);
    _exit(1);
}

void worker_watch(const char *code)
{
    if (code[0])
        snprintf(student, sizeof student, "%s/", code);
    peak_before = crash_peak_kb();
    const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGTRAP, SIGUSR1};
    crash_watch(tell_signal, signals, sizeof signals / sizeof *signals);
    atexit(on_exit_call);
}

void worker_watch_end(void)
{
    over = true;
}
