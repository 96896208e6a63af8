// What a crash leaves behind: one line that says which signal, in which case, and where in the step's object.
#define _GNU_SOURCE // dladdr, REG_RIP
#include "cli/probe.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

#if defined(__GLIBC__) || defined(__APPLE__)
#include <execinfo.h>
#define HAS_BACKTRACE 1
#endif

#if defined(__linux__)
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#endif

#define MOST_FRAMES 64
#define MOST_PLACES 16

volatile int probe_case = -1;
static char watched[4096];
static char *stack_top; // somewhere near the stack's beginning

// snprintf is not safe in a signal handler; these are.
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

static void send(const char *from, const char *to)
{
    ssize_t ignored = write(STDERR_FILENO, from, (size_t)(to - from));
    (void)ignored;
}

// The most memory that the process has asked for, kB; 0 where the system does not tell.
static unsigned long long peak_memory(void)
{
    char text[4096];
    int fd = open("/proc/self/status", O_RDONLY);
    ssize_t size = fd >= 0 ? read(fd, text, sizeof text - 1) : 0;
    if (fd >= 0)
        close(fd);
    text[size > 0 ? size : 0] = '\0';
    const char *line = strstr(text, "VmPeak:");
    unsigned long long value = 0;
    for (const char *c = line ? line + 7 : ""; *c && *c != '\n'; c++)
        if (*c >= '0' && *c <= '9')
            value = 10 * value + (unsigned long long)(*c - '0');
    return value;
}

// Where the program was, and its stack's lower end; NULL where this system's way to tell is not known.
static void read_context(void *context, char **place, char **stack)
{
    *place = *stack = NULL;
#if defined(__linux__) && defined(__x86_64__)
    ucontext_t *state = context;
    *place = (char *)(size_t)state->uc_mcontext.gregs[REG_RIP];
    *stack = (char *)(size_t)state->uc_mcontext.gregs[REG_RSP];
#elif defined(__linux__) && defined(__aarch64__)
    ucontext_t *state = context;
    *place = (char *)(size_t)state->uc_mcontext.pc;
    *stack = (char *)(size_t)state->uc_mcontext.sp;
#else
    (void)context;
#endif
}

// A recursion without end, and an array too large for the stack, touch what lies below it.
static bool is_below_stack(int number, const char *address, const char *stack)
{
    ptrdiff_t depth = stack_top - address;
    if (number != SIGSEGV || depth < (7 << 20))
        return false;
    return stack ? address >= stack - (64 << 10) : depth < (64 << 20);
}

// `exact`: the very instruction; otherwise a return address, which is one behind the call.
static char *put_place(char *to, char *place, bool exact, int *written)
{
    Dl_info info;
    if (!dladdr(place, &info) || !info.dli_fname || strcmp(info.dli_fname, watched) != 0)
        return to;
    to = put_text(to, (*written)++ ? ",0x" : "0x");
    return put_number(to, (unsigned long long)(place - (char *)info.dli_fbase - !exact), 16);
}

// The instruction is known at once and goes out at once: over a broken stack the way up may not be found.
static void send_frames(char *place)
{
    char line[64 + 20 * MOST_PLACES];
    int written = 0;
    char *to = place ? put_place(line, place, true, &written) : line;
#ifdef HAS_BACKTRACE
    send(line, to);
    void *frames[MOST_FRAMES];
    int count = backtrace(frames, MOST_FRAMES), first = 0;
    for (int i = 0; i < count; i++)
        if (frames[i] == (void *)place)
            first = i + 1; // what lies before is this handler
    to = line;
    for (int i = first; i < count && written < MOST_PLACES; i++)
        to = put_place(to, frames[i], false, &written);
#endif
    *to++ = '\n';
    send(line, to);
}

static void report_crash(int number, siginfo_t *info, void *context)
{
    char line[512], *place, *stack;
    // A second fault in here, or an alarm, ends it at once.
    for (int other = 1; other < 32; other++)
        signal(other, SIG_DFL);
    read_context(context, &place, &stack);
    char *to = put_text(line, "\nphotonlab-crash signal=");
    to = put_number(to, (unsigned long long)number, 10);
    to = put_text(to, " case=");
    to = put_number(to, probe_case < 0 ? 0 : (unsigned long long)probe_case, 10);
    to = put_text(to, " address=0x");
    to = put_number(to, (unsigned long long)(size_t)info->si_addr, 16);
    to = put_text(to, is_below_stack(number, info->si_addr, stack) ? " stack=far" : " stack=near");
#if defined(__linux__) && defined(si_syscall)
    if (number == SIGSYS && info->si_code == 1) { // SYS_SECCOMP, which not every header has
        to = put_text(to, " syscall=");
        to = put_number(to, (unsigned long long)info->si_syscall, 10);
    }
#endif
    to = put_text(to, " peak_kb=");
    to = put_number(to, peak_memory(), 10);
    to = put_text(to, " frames=");
    send(line, to);
    send_frames(place);
    // Not by the signal itself, which the first process of a namespace does not die of.
    _exit(128 + number);
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

void probe_watch(const char *object)
{
    static char room[64 << 10]; // a stack for the handler: the usual one may be what ran out
    char here;
    stack_top = &here;
    snprintf(watched, sizeof watched, "%s", object);
#ifdef HAS_BACKTRACE
    void *first[1];
    backtrace(first, 1); // the first call loads a library, which a handler must not
#endif
    stack_t stack = {.ss_sp = room, .ss_size = sizeof room};
    sigaltstack(&stack, NULL);
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_sigaction = report_crash;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    const int signals[] = {SIGSEGV, SIGBUS,  SIGFPE, SIGILL,  SIGABRT, SIGXCPU,
                           SIGTRAP, SIGXFSZ, SIGSYS, SIGALRM, SIGTERM, SIGPIPE};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
        sigaction(signals[i], &action, NULL);
    if (getenv("PHOTONLAB_PROBE_SECONDS"))
        forbid_exec();
    set_alarm();
}
