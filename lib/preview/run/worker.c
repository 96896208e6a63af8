#define _GNU_SOURCE // RLIMIT_…
#include "preview/run/worker.h"
#include "preview/record/fault.h"
#include "base/parallel.h"
#include "base/process.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__)
#define SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SANITIZED 1
#endif
#endif

#define BEAT 0.1 // s between signs of life, when nothing else is sent

#ifndef CLOCK_MONOTONIC_COARSE
#define CLOCK_MONOTONIC_COARSE CLOCK_MONOTONIC
#endif

static int window = -1; // the pipe to it
static double last_sent, progress;
static volatile sig_atomic_t sending; // a message is on its way, and no other may begin

static char student[4096];             // the folder that their objects come from, with its slash
static bool over;                      // what comes now is no longer the student's doing
static unsigned long long peak_before; // kB
static WireCrash crash;

// It is looked at for every path: right to some milliseconds, and cheap.
static double coarse_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void worker_send_both(WireKind kind, const void *first, size_t first_size, const void *rest, size_t rest_size)
{
    WireHead head = {(uint32_t)kind, (uint32_t)(first_size + rest_size), progress, getpid()};
    sending = true;
    if (!write_all(window, &head, sizeof head) || !write_all(window, first, first_size) ||
        !write_all(window, rest, rest_size))
        _exit(1); // the window no longer listens
    sending = false;
    last_sent = coarse_seconds();
}

void worker_beat(double fraction)
{
    progress = fraction;
    if (coarse_seconds() - last_sent > BEAT)
        worker_send(WIRE_ALIVE, NULL, 0);
}

// The first in the student's code is where it was, and goes out at once.
static void take_place(const CrashPlace *place)
{
    if (crash_take_inner(&crash.inner, place, student))
        worker_send(WIRE_CRASH, &crash, sizeof crash);
}

static void tell_crash(const char *place)
{
    if (sending)
        return;
    worker_send(WIRE_CRASH, &crash, sizeof crash); // over a broken stack the way up may not be found
    crash_walk(place, take_place);
    worker_send(WIRE_CRASH, &crash, sizeof crash);
}

static void on_signal(const Crash *at)
{
    crash.at = *at;
    crash.grown_kb = at->peak_kb > peak_before ? at->peak_kb - peak_before : 0;
    tell_crash(at->place);
}

static void on_exit_call(void)
{
    if (over)
        return;
    tell_crash(NULL);
    fflush(stdout);
    _exit(1);
}

// From now on a fatal signal, an exit() and SIGUSR1 tell the window where they came from.
static void watch(const WireOrder *order)
{
    if (order->code[0])
        snprintf(student, sizeof student, "%.4094s/", order->code);
    peak_before = crash_peak_kb();
    const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGTRAP, SIGUSR1};
    crash_watch(on_signal, signals, sizeof signals / sizeof *signals);
    atexit(on_exit_call);
}

static void set_limit(int what, rlim_t most)
{
    struct rlimit limit;
    if (getrlimit(what, &limit) != 0)
        return;
    limit.rlim_cur = limit.rlim_max == RLIM_INFINITY || most < limit.rlim_max ? most : limit.rlim_max;
    setrlimit(what, &limit);
}

// Pictures keep their own photons; students' code has WORKER_MEMORY_GB beside them.
static void set_limits(const Worker *worker)
{
    set_limit(RLIMIT_CORE, 0);
    set_limit(RLIMIT_STACK, 8u << 20);
#if !defined(SANITIZED) // its shadow of the memory is larger than any limit
    rlim_t own = (64u << 20) + (rlim_t)crash_peak_kb() * 1024;
    if (worker->order->request.kind >= RUN_ESTIMATES)
        own += (rlim_t)worker->order->request.photons * 256;
#if defined(__linux__)
    set_limit(RLIMIT_DATA, ((rlim_t)WORKER_MEMORY_GB << 30) + own);
#else
    set_limit(RLIMIT_AS, ((rlim_t)WORKER_MEMORY_GB << 30) + own + ((rlim_t)1 << 30));
#endif
#else
    (void)worker;
#endif
}

void worker_run(Worker *worker, int pipe)
{
    window = pipe;
    parallel_limit(1); // the threads of a process do not live on in a fork
    set_limits(worker);
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ); // what a step prints is out before it crashes
    watch(worker->order);
    worker_send(WIRE_ALIVE, NULL, 0); // by that it is known to the window
    Error error = {""};
    errno = 0;
    bool ok = worker_work(worker, &error);
    over = true;
    if (!ok)
        worker_send(WIRE_FAILED, error.message, strlen(error.message));
    fflush(stdout);
    _exit(ok ? 0 : 1);
}
