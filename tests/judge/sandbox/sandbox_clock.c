// The limits of time. That by the clock is for what waits: what got a processor since the last look waits for its turn on a busy
// machine. That of processor time is looked after from outside, where the kernel tells it exactly: its own limit counts whole ticks,
// which on a busy machine may be nine tenths of what they seem.
#define _GNU_SOURCE // clock_getcpuclockid
#include "judge/sandbox/sandbox_parts.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#define PATIENCE   10   // times the limit that a busy machine may take
#define LOOK_EACH  0.01 // s
#define LEAST_WORK 0.01 // s of a processor's time between two looks, or it waits

double sandbox_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// s that a process has had of the processors; 0 where the system does not tell.
static double spent_by(pid_t process)
{
#ifdef __linux__
    clockid_t clock;
    struct timespec t;
    if (clock_getcpuclockid(process, &clock) == 0 && clock_gettime(clock, &t) == 0)
        return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
#endif
    (void)process;
    return 0.0;
}

// Calls for a process and for all that it and they started.
static void each_below(pid_t process, void (*call)(pid_t process, void *user), void *user)
{
    char path[64];
    int child;
    call(process, user);
    snprintf(path, sizeof path, "/proc/%d/task/%d/children", process, process);
    FILE *file = fopen(path, "re");
    while (file && fscanf(file, "%d", &child) == 1)
        each_below(child, call, user);
    if (file)
        fclose(file);
}

// The first signal can be caught, and tells where; the second cannot.
static void end_if_spent(pid_t process, void *user)
{
    double over = spent_by(process) - *(const double *)user;
    if (over >= 0.0)
        kill(process, over < 1.0 ? SIGXCPU : SIGKILL);
}

void sandbox_end_spent(pid_t child, const SandboxRun *run, Waiting *waiting)
{
    double now = sandbox_now(), seconds = sandbox_seconds(run);
    if (now < waiting->begin + seconds || now < waiting->looked + LOOK_EACH)
        return;
    waiting->looked = now;
    each_below(child, end_if_spent, &seconds);
}

static void add_spent(pid_t process, void *sum)
{
    *(double *)sum += spent_by(process);
}

bool sandbox_waits_too_long(pid_t child, const SandboxRun *run, Waiting *waiting)
{
    if (sandbox_now() <= waiting->deadline)
        return false;
    double before = waiting->spent;
    waiting->spent = 0.0;
    each_below(child, add_spent, &waiting->spent);
    waiting->deadline += run->wall_seconds;
    return waiting->spent < before + LEAST_WORK || sandbox_now() > waiting->begin + PATIENCE * run->wall_seconds;
}
