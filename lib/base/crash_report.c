#define _GNU_SOURCE // REG_RIP, dladdr
#include "base/crash_report.h"
#include "base/file.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if defined(__GLIBC__) || defined(__APPLE__)
#include <execinfo.h>
#define HAS_BACKTRACE 1
#endif

#if defined(__linux__)
#include <ucontext.h>
#endif

static char *stack_top; // somewhere near the stack's beginning
static void (*tell_crash)(const Crash *crash);

unsigned long long crash_peak_kb(void)
{
    char text[4096];
    int fd = open("/proc/self/status", O_RDONLY);
    ssize_t size = fd >= 0 ? read(fd, text, sizeof text - 1) : 0;
    if (fd >= 0)
        close(fd);
    text[size > 0 ? size : 0] = '\0';
    const char *line = strstr(text, "VmPeak:");
    return line ? strtoull(line + 7, NULL, 10) : 0;
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

// Did it touch what lies just below the stack, more than 7 MB from its beginning? The usual limit is 8 MB.
static bool is_below_stack(int number, const char *address, const char *stack)
{
    ptrdiff_t depth = stack_top - address;
    if (number != SIGSEGV || depth < (7 << 20))
        return false;
    return stack ? address >= stack - (64 << 10) : depth < (64 << 20);
}

static void on_signal(int number, siginfo_t *info, void *context)
{
    Crash crash = {
        .signal = number, .reason = errno, .address = (unsigned long long)(size_t)info->si_addr, .syscall = -1};
    for (int other = 1; other < 32; other++)
        signal(other, SIG_DFL);
    char *stack;
    read_context(context, &crash.place, &stack);
    crash.stack_far = is_below_stack(number, info->si_addr, stack);
    crash.peak_kb = crash_peak_kb();
#if defined(__linux__) && defined(si_syscall)
    if (number == SIGSYS && info->si_code == 1) // SYS_SECCOMP, which not every header has
        crash.syscall = info->si_syscall;
#endif
    tell_crash(&crash);
    _exit(128 + number); // not by the signal itself, which the first process of a namespace does not die of
}

static void take_address(const char *address, bool returns, void (*take)(const CrashPlace *place))
{
    Dl_info info;
    if (!dladdr((void *)(size_t)address, &info) || !info.dli_fname)
        return;
    ptrdiff_t offset = address - (const char *)info.dli_fbase - returns;
    CrashPlace place = {info.dli_fname, info.dli_sname, info.dli_saddr, (unsigned long long)offset};
    take(&place);
}

void crash_walk(const char *place, void (*take)(const CrashPlace *place))
{
    if (place)
        take_address(place, false, take);
#ifdef HAS_BACKTRACE
    void *frames[64];
    int count = backtrace(frames, 64), first = 0;
    for (int i = 0; i < count; i++)
        if (frames[i] == (const void *)place)
            first = i + 1; // what lies before is the handler
    for (int i = first; i < count; i++)
        take_address(frames[i], true, take);
#endif
}

bool crash_take_inner(InnerPlace *inner, const CrashPlace *place, const char *folder)
{
    if (!folder[0] || strncmp(place->object, folder, strlen(folder)) != 0)
        return false;
    inner->calls_itself = inner->calls_itself || (inner->function && place->function == inner->function);
    inner->function = inner->function ? inner->function : place->function;
    if (inner->object[0]) {
        if (!inner->caller && strcmp(place->object, inner->object) == 0)
            inner->caller = place->offset;
        return false;
    }
    inner->offset = place->offset;
    inner->caller = 0;
    strncpy(inner->object, place->object, sizeof inner->object - 1);
    strncpy(inner->symbol, place->symbol ? place->symbol : "", sizeof inner->symbol - 1);
    return true;
}

void crash_watch(void (*tell)(const Crash *crash), const int *signals, size_t count)
{
    static char own_stack[64 << 10];
    char here;
    stack_top = &here;
    tell_crash = tell;
#ifdef HAS_BACKTRACE
    void *first[1];
    backtrace(first, 1); // the first call loads a library, which a handler must not
#endif
    stack_t stack = {.ss_sp = own_stack, .ss_size = sizeof own_stack};
    sigaltstack(&stack, NULL);
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_sigaction = on_signal;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    for (size_t i = 0; i < count; i++)
        sigaction(signals[i], &action, NULL);
}

int crash_places(const char *text, SourcePlace *places, int most)
{
    int count = 0, used;
    char function[1024], path[4096];
    for (; count < most && sscanf(text, "%1023[^\n] %4095[^\n] %n", function, path, &used) == 2; text += used) {
        SourcePlace *place = &places[count];
        char *colon = strrchr(path, ':'), *slash;
        place->line = colon ? atoi(colon + 1) : 0;
        if (colon)
            *colon = '\0';
        slash = strrchr(path, '/');
        // What the compiler made of a function has a point in its name: reflect.part.0.
        snprintf(place->function, sizeof place->function, "%.*s", (int)strcspn(function, "."), function);
        snprintf(place->file, sizeof place->file, "%.200s", slash ? slash + 1 : path);
        count += function[0] != '?' && !file_ends_in(place->file, ".h");
    }
    return count;
}

void crash_describe_signal(int number, unsigned long long address, const char *place, char *text, size_t size)
{
    if (number == SIGSEGV || number == SIGBUS)
        snprintf(text, size, "segmentation fault%s: an address that is not yours%s", place,
                 address < 4096 ? " (a null pointer, or an index far beyond an array?)"
                                : " (beyond the end of an array?)");
    else if (number == SIGFPE)
        snprintf(text, size, "an integer was divided by 0%s", place);
    else
        snprintf(text, size, "it came to a place that right code never reaches%s (signal %d)", place, number);
}

void crash_describe_stack(const char *function, const char *caller, char *text, size_t size)
{
    if (caller)
        snprintf(text, size, "the stack overflowed: %s calls itself without end", caller);
    else // compilers make room for arrays on different lines
        snprintf(text, size, "the stack overflowed%s%s: a very large array, or calls without end?",
                 function ? " in " : "", function ? function : "");
}
