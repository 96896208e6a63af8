// What a crash leaves behind: one line that says which signal, in which case, and where in the step's object.
#define _GNU_SOURCE // dladdr
#include "cli/probe.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if defined(__GLIBC__) || defined(__APPLE__)
#include <execinfo.h>
#define HAS_BACKTRACE 1
#endif

#define MOST_FRAMES 64

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

static char *put_frames(char *to)
{
#ifdef HAS_BACKTRACE
    void *frames[MOST_FRAMES];
    int count = backtrace(frames, MOST_FRAMES);
    int written = 0;
    for (int i = 0; i < count && written < 16; i++) {
        Dl_info info;
        if (!dladdr(frames[i], &info) || !info.dli_fname || strcmp(info.dli_fname, watched) != 0)
            continue;
        to = put_text(to, written++ ? "," : "");
        to = put_text(to, "0x");
        to = put_number(to, (unsigned long long)((char *)frames[i] - (char *)info.dli_fbase), 16);
    }
#endif
    return to;
}

static void report_crash(int number, siginfo_t *info, void *context)
{
    (void)context;
    char line[2048];
    char *to = put_text(line, "\nphotonlab-crash signal=");
    to = put_number(to, (unsigned long long)number, 10);
    to = put_text(to, " case=");
    to = put_number(to, probe_case < 0 ? 0 : (unsigned long long)probe_case, 10);
    to = put_text(to, " address=0x");
    to = put_number(to, (unsigned long long)(size_t)info->si_addr, 16);
    // A recursion without end dies on an address far below where the stack began.
    ptrdiff_t depth = stack_top - (char *)info->si_addr;
    to = put_text(to, number == SIGSEGV && depth > (4 << 20) && depth < (64 << 20) ? " stack=far" : " stack=near");
    to = put_text(to, " peak_kb=");
    to = put_number(to, peak_memory(), 10);
    to = put_text(to, " frames=");
    to = put_frames(to);
    *to++ = '\n';
    ssize_t ignored = write(STDERR_FILENO, line, (size_t)(to - line));
    (void)ignored;
    signal(number, SIG_DFL);
    raise(number);
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
    const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGTRAP, SIGSYS, SIGALRM};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++)
        sigaction(signals[i], &action, NULL);
}
