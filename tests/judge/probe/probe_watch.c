// What a crash leaves behind: one line that says which signal, in which case, and where in the step's object.
#include "judge/probe/probe.h"
#include "base/crash_report.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#if defined(__linux__)
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

#if defined(__GLIBC__)
#include <stdio_ext.h>
#endif

#define MOST_PLACES 16

volatile int probe_case = -1;
static char watched[4096]; // the object whose places are told; "" until one below `folder` is met
static char folder[4096];  // with its slash; "": there is none

static void send(const char *from, const char *to)
{
    ssize_t ignored = write(STDERR_FILENO, from, (size_t)(to - from));
    (void)ignored;
}

// snprintf is not safe in a handler; these are. They return the end of what they wrote.
static char *put_text(char *to, const char *text)
{
    while (*text)
        *to++ = *text++;
    return to;
}

static char *put_number(char *to, unsigned long long value, unsigned base)
{
    char digits[24];
    int count = 0;
    do {
        digits[count++] = "0123456789abcdef"[value % base];
        value /= base;
    } while (value);
    while (count > 0)
        *to++ = digits[--count];
    return to;
}

// Of several objects it is the first one met, the innermost, that is watched from then on.
static bool is_watched(const char *file)
{
    size_t length = strlen(folder);
    if (!watched[0] && length > 0 && strncmp(file, folder, length) == 0 && strlen(file) < sizeof watched)
        memcpy(watched, file, strlen(file) + 1);
    return strcmp(file, watched) == 0;
}

// " step=1.3", by the name of the directory that a watched object below `folder` lies in.
static char *put_step(char *to)
{
    if (!folder[0])
        return to;
    to = put_text(to, " step=");
    for (const char *id = watched + strlen(folder); *id && *id != '/'; id++)
        *to++ = *id;
    return to;
}

static void send_place(const CrashPlace *place)
{
    static int sent;
    char text[512], *to = text; // with the name of a step's directory
    if (sent >= MOST_PLACES || !is_watched(place->object))
        return;
    if (sent == 0)
        to = put_text(put_step(to), " frames=");
    to = put_text(to, sent++ ? ",0x" : "0x");
    send(text, put_number(to, place->offset, 16));
}

#if defined(__GLIBC__)
static char printed[1 << 16]; // not yet on its way
#endif

// A step may print a line in each of a million calls: many go out together, and the last ones before a crash.
static void buffer_output(void)
{
#if defined(__GLIBC__)
    setvbuf(stdout, printed, _IOFBF, sizeof printed);
#else
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
#endif
}

static void send_printed(void)
{
#if defined(__GLIBC__)
    ssize_t ignored = write(STDOUT_FILENO, printed, __fpending(stdout));
    (void)ignored;
#endif
}

static void report_crash(const Crash *crash)
{
    send_printed();
    char line[512];
    char *to = put_text(line, "\nphotonlab-crash signal=");
    to = put_number(to, (unsigned long long)crash->signal, 10);
    to = put_text(to, " case=");
    to = put_number(to, probe_case < 0 ? 0 : (unsigned long long)probe_case, 10);
    to = put_text(to, " address=0x");
    to = put_number(to, crash->address, 16);
    to = put_text(to, crash->stack_far ? " stack=far" : " stack=near");
    if (crash->syscall >= 0) {
        to = put_text(to, " syscall=");
        to = put_number(to, (unsigned long long)crash->syscall, 10);
    }
    to = put_text(to, " peak_kb=");
    to = put_number(to, crash->peak_kb, 10);
    send(line, to);
    crash_walk(crash->place, send_place);
    *line = '\n';
    send(line, line + 1);
}

// The judge's filter must allow exec, since it holds before this program is started by one. From now on exec is forbidden.
static void forbid_exec(void)
{
#if defined(__linux__) && defined(SYS_execve) && defined(SECCOMP_MODE_FILTER)
    struct sock_filter code[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_execve, 1, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_execveat, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    struct sock_fprog program = {sizeof code / sizeof *code, code};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0)
        prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
#endif
}

static struct sigaction crashed; // what an alarm that counts leads to
static double worked;            // processor time at the last alarm, s

static double processor_seconds(void)
{
    struct timespec t = {0, 0};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// The judge says how long this may wait, by the clock. A step that waits too long is told by the probe's own alarm, whose handler
// knows where; a signal from the judge would not reach a process in a namespace of its own.
static double patience(void)
{
    const char *text = getenv("PHOTONLAB_PROBE_SECONDS");
    double seconds = text ? strtod(text, NULL) : 0.0;
    return seconds > 0.0 && seconds < 1e6 ? seconds : 0.0;
}

static void set_alarm(double seconds)
{
    struct itimerval timer = {{0, 0}, {(time_t)seconds, (suseconds_t)(1e6 * (seconds - (double)(time_t)seconds)) + 1}};
    timer.it_value.tv_usec = timer.it_value.tv_usec > 999999 ? 999999 : timer.it_value.tv_usec;
    setitimer(ITIMER_REAL, &timer, NULL);
}

// What got a processor meanwhile, however rarely on a busy machine, does not wait: the limit of processor time ends that.
static void on_alarm(int number, siginfo_t *info, void *context)
{
    double before = worked, seconds = patience();
    worked = processor_seconds();
    if (worked - before > 2e-3 * seconds)
        set_alarm(seconds);
    else
        crashed.sa_sigaction(number, info, context);
}

static void watch_clock(void)
{
    struct sigaction action;
    sigaction(SIGALRM, NULL, &crashed);
    action = crashed;
    action.sa_sigaction = on_alarm;
    action.sa_flags |= SA_RESTART;
    sigaction(SIGALRM, &action, NULL);
    worked = processor_seconds();
    if (patience() > 0.0)
        set_alarm(patience());
}

void probe_watch(const char *object, const char *objects)
{
    buffer_output();
    snprintf(watched, sizeof watched, "%s", object ? object : "");
    if (objects)
        snprintf(folder, sizeof folder, "%s/", objects);
    const int signals[] = {SIGSEGV, SIGBUS,  SIGFPE, SIGILL,  SIGABRT, SIGXCPU,
                           SIGTRAP, SIGXFSZ, SIGSYS, SIGALRM, SIGTERM, SIGPIPE};
    crash_watch(report_crash, signals, sizeof signals / sizeof *signals);
    if (getenv("PHOTONLAB_PROBE_SECONDS"))
        forbid_exec();
    watch_clock();
}
