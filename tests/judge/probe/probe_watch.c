// What a crash leaves behind: one line that says which signal, in which case, and where in the step's object.
#define _GNU_SOURCE // dladdr
#include "judge/probe/probe.h"
#include "base/crash_report.h"

#include <dlfcn.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

#if defined(__linux__)
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
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

// `exact`: the very instruction; otherwise a return address, which is one behind the call.
static char *put_place(char *to, char *place, bool exact, int *written)
{
    Dl_info info;
    if (!dladdr(place, &info) || !info.dli_fname || !is_watched(info.dli_fname))
        return to;
    if (*written == 0)
        to = put_text(put_step(to), " frames=");
    to = put_text(to, (*written)++ ? ",0x" : "0x");
    return put_number(to, (unsigned long long)(place - (char *)info.dli_fbase - !exact), 16);
}

// The instruction is known at once and goes out at once: over a broken stack the way up may not be found.
static void send_frames(char *place)
{
    char line[512 + 20 * MOST_PLACES]; // with the name of a step's directory
    int written = 0;
    char *to = place ? put_place(line, place, true, &written) : line;
    send(line, to);
    void *frames[CRASH_FRAMES];
    int count = crash_frames(place, frames);
    to = line;
    for (int i = 0; i < count && written < MOST_PLACES; i++)
        to = put_place(to, frames[i], false, &written);
    *to++ = '\n';
    send(line, to);
}

static void report_crash(const Crash *crash)
{
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
    send_frames(crash->place);
}

// The judge's filter cannot forbid exec, as it holds before this very program is started. From now on it can.
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

// The judge says how long this may take by the clock. A signal of its own tells where it waits, one from outside would not
// reach it.
static void set_alarm(void)
{
    const char *text = getenv("PHOTONLAB_PROBE_SECONDS");
    double seconds = text ? strtod(text, NULL) : 0.0;
    if (!(seconds > 0.0 && seconds < 1e6))
        return;
    struct itimerval timer = {{0, 0}, {(time_t)seconds, (suseconds_t)(1e6 * (seconds - (double)(time_t)seconds)) + 1}};
    timer.it_value.tv_usec = timer.it_value.tv_usec > 999999 ? 999999 : timer.it_value.tv_usec;
    setitimer(ITIMER_REAL, &timer, NULL);
}

void probe_watch(const char *object, const char *objects)
{
    snprintf(watched, sizeof watched, "%s", object ? object : "");
    if (objects)
        snprintf(folder, sizeof folder, "%s/", objects);
    const int signals[] = {SIGSEGV, SIGBUS,  SIGFPE, SIGILL,  SIGABRT, SIGXCPU,
                           SIGTRAP, SIGXFSZ, SIGSYS, SIGALRM, SIGTERM, SIGPIPE};
    crash_watch(report_crash, signals, sizeof signals / sizeof *signals);
    if (getenv("PHOTONLAB_PROBE_SECONDS"))
        forbid_exec();
    set_alarm();
}
