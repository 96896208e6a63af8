#include "base/crash_report.h"
#include "judge/grade/grade.h"
#include "judge/probe/probe.h"

#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_PLACES 16

// The probe's last words; tests/judge/probe/probe_watch.c writes them.
typedef struct {
    int signal;
    long long syscall, peak_kb;
    unsigned long long address;
    bool stack_overflow;
    char frames[MOST_PLACES][24];
    int frame_count;
    char step[8]; // of several; ""
} LastWords;

static const char *find_last(const char *text, const char *word)
{
    const char *last = NULL;
    for (const char *found = text; (found = strstr(found, word)); found++)
        last = found;
    return last;
}

static unsigned long long number_after(const char *line, const char *name, int base)
{
    const char *found = strstr(line, name);
    return found ? strtoull(found + strlen(name), NULL, base) : 0;
}

// A student's code can print such a line too; it gains nothing but the wrong words.
static void read_last_words(const char *text, LastWords *words)
{
    char line[1024];
    *words = (LastWords){.syscall = -1};
    const char *found = find_last(text, "photonlab-crash signal=");
    snprintf(line, sizeof line, "%.*s", found ? (int)strcspn(found, "\n") : 0, found ? found : "");
    const char *step = strstr(line, " step="), *frame = strstr(line, "frames=");
    words->signal = (int)number_after(line, "signal=", 10);
    words->address = number_after(line, "address=", 16);
    words->peak_kb = (long long)number_after(line, "peak_kb=", 10);
    words->stack_overflow = strstr(line, "stack=far");
    if (strstr(line, "syscall="))
        words->syscall = (long long)number_after(line, "syscall=", 10);
    if (step)
        snprintf(words->step, sizeof words->step, "%.*s", (int)strspn(step + 6, "0123456789."), step + 6);
    for (frame = frame ? frame + 7 : ""; words->frame_count < MOST_PLACES && strncmp(frame, "0x", 2) == 0;) {
        size_t digits = 2 + strspn(frame + 2, "0123456789abcdef");
        snprintf(words->frames[words->frame_count++], sizeof words->frames[0], "%.*s", (int)(digits < 20 ? digits : 20),
                 frame);
        frame += digits;
        frame += *frame == ',';
    }
}

static int find_places(const GradeOptions *options, const LastWords *words, const char *object, SourcePlace *places)
{
    const char *arguments[7 + MOST_PLACES] = {"addr2line", "-f", "-i", "-e", object};
    SandboxRun run = {.arguments = arguments,
                      .visible = {object},
                      .result_fd = -1,
                      .compiler = true,
                      .cpu_seconds = 10,
                      .wall_seconds = 30,
                      .memory_mb = 1024,
                      .file_mb = 1};
    SandboxResult *ran = calloc(1, sizeof *ran);
    for (int i = 0; i < words->frame_count; i++)
        arguments[5 + i] = words->frames[i];
    int count = 0;
    if (ran && words->frame_count > 0 && sandbox_run(options->sandbox, &run, ran, NULL) && ran->exit_code == 0)
        count = crash_places(ran->text, places, MOST_PLACES);
    free(ran);
    return count;
}

// By its name; NULL: it has none.
static const char *describe_call(const char *name)
{
    static const struct {
        const char *names, *words;
    } calls[] = {
        {" socket socketpair ", "opening a network connection"},
        {" fork vfork clone clone3 ", "starting another process or thread"},
        {" execve execveat ", "starting another program"},
        {" ptrace process_vm_readv process_vm_writev pidfd_open pidfd_getfd kcmp ", "looking into another process"},
        {" kill tkill rt_sigqueueinfo rt_tgsigqueueinfo pidfd_send_signal ", "sending a signal to another process"},
        {" open openat creat mkdir mkdirat mknod mknodat link linkat symlink symlinkat rename renameat renameat2 unlink "
         "unlinkat rmdir truncate chmod fchmod fchmodat chown fchown fchownat lchown memfd_create ",
         "writing, making or removing a file"},
        {" setuid setgid setreuid setregid setresuid setresgid setgroups capset unshare setns chroot mount umount2 ",
         "becoming another user"},
    };
    char spaced[80];
    const char *words = "a system call that a step has no need of";
    snprintf(spaced, sizeof spaced, " %s ", name ? name : "?");
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++)
        if (strstr(calls[i].names, spaced))
            words = calls[i].words;
    return words;
}

static void describe_abort(const char *text, const char *place, char *message, size_t size)
{
    const char *assertion = find_last(text, ": Assertion `");
    if (assertion && strstr(assertion, "' failed"))
        snprintf(message, size, "the assertion `%.*s` does not hold%s",
                 (int)(strstr(assertion, "' failed") - assertion - 13), assertion + 13, place);
    else if (strstr(text, "a step was called that is not there"))
        snprintf(message, size, "it calls a step%s that it has no need of", place);
    else if (strstr(text, "stack smashing detected"))
        snprintf(message, size, "it wrote beyond the end of an array%s", place);
    else if (strstr(text, "free(): ") || strstr(text, "malloc(): ") || strstr(text, "corrupted"))
        snprintf(message, size, "it wrote beyond the end of memory that it asked for, or freed some twice%s", place);
    else
        snprintf(message, size, "abort() was called%s", place);
}

static void describe_overflow(const SourcePlace *places, int count, char *message, size_t size)
{
    const char *caller = NULL;
    for (int i = 1; i < count; i++)
        if (strcmp(places[i].function, places[0].function) == 0)
            caller = places[0].function;
    crash_describe_stack(count > 0 ? places[0].function : NULL, caller, message, size);
}

// The step that these words begin with, by its symbol. NULL: none.
static const char *step_named(const char *words)
{
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (strcspn(words, "\n (") == strlen(step_table[i].symbol) &&
            strncmp(words, step_table[i].symbol, strlen(step_table[i].symbol)) == 0)
            return step_table[i].symbol;
    return NULL;
}

// It ended by itself, but too early.
static void describe_exit(const SandboxResult *ran, char *message, size_t size)
{
    const char *symbol = find_last(ran->text, "undefined symbol: "), *sanitizer = find_last(ran->text, "Sanitizer: ");
    const char *own = find_last(ran->text, ": case "); // as the probe says that it could not go on
    const char *step = symbol ? step_named(symbol + 18) : NULL;
    if (step && ran->exit_code != 0)
        snprintf(message, size, "it calls `%s` by its name; steps are called by their table: write steps.%s(…)", step,
                 step);
    else if (symbol && ran->exit_code != 0)
        snprintf(message, size, "it calls `%.*s`, and there is no such function", (int)strcspn(symbol + 18, "\n ("),
                 symbol + 18);
    else if (sanitizer && ran->exit_code != 0)
        snprintf(message, size, "the sanitizer found: %.*s", (int)strcspn(sanitizer + 11, "\n "), sanitizer + 11);
    else if (strstr(ran->text, PROBE_NOT_AGAIN) && ran->exit_code == 1)
        snprintf(message, size, "it " PROBE_NOT_AGAIN ": random numbers of its own, or memory that it never set?");
    else if (own && ran->exit_code == 1)
        snprintf(message, size, "the probe could not go on: %.*s", (int)strcspn(own + 2, "\n"), own + 2);
    else
        snprintf(message, size, "it called exit(%d) before it was done", ran->exit_code);
}

// Code that compilers make of no line, as of a loop around nothing, has line 0.
static void write_line(int line, char *text, size_t size)
{
    text[0] = '\0';
    if (line > 0)
        snprintf(text, size, ", line %d", line);
}

// Limits as they are for the usual machine, so that the words are the same on a slow one.
static void describe_signal(const GradeOptions *options, const SandboxResult *ran, const LastWords *words,
                            const SourcePlace *places, int count, char *message, size_t size)
{
    int number = words->signal ? words->signal : ran->signal;
    char place[256] = "", in[160] = "", line[32];
    if (count > 0) {
        const char *of = words->step[0] ? " of step " : "";
        write_line(places[0].line, line, sizeof line);
        snprintf(place, sizeof place, " in %s%s%s%s", places[0].function, of, words->step, line);
        snprintf(in, sizeof in, ": it was in %s%s%s;", places[0].function, of, words->step);
    }
    bool out_of_memory = ran->memory_mb > 0 && words->peak_kb > ran->memory_mb * 1024 / 4 * 3;
    char *call = number == SIGSYS ? sandbox_call_name(words->syscall) : NULL;
    bool huge = call && strcmp(call, "mmap") == 0;
    bool ended_by_clock = ran->timed_out || number == SIGALRM;
    if (number == SIGXCPU || (ran->signal == SIGKILL && !ended_by_clock && ran->cpu_seconds >= ran->cpu_limit))
        snprintf(message, size,
                 "it did not end within %.0f s of processor time%s a loop or a recursion that never ends?",
                 ran->cpu_limit / options->speed, count > 0 ? in : ":");
    else if (ended_by_clock)
        snprintf(message, size, "it did not end within %.0f s%s waiting for something that never comes?",
                 ran->wall_limit / options->speed, count > 0 ? in : ":");
    else if (huge || (out_of_memory && number != SIGSYS))
        snprintf(message, size, "it asked for more memory than the %ld MB there are%s", ran->memory_mb, place);
    else if (number == SIGSYS)
        snprintf(message, size, "it tried something that is not allowed here%s: %s", place, describe_call(call));
    else if ((number == SIGSEGV || number == SIGBUS) && words->stack_overflow)
        describe_overflow(places, count, message, size);
    else if (number == SIGABRT)
        describe_abort(ran->text, place, message, size);
    else if (number == SIGXFSZ)
        snprintf(message, size, "it wrote more than there is room for%s", place);
    else
        crash_describe_signal(number, words->address, place, message, size);
    free(call);
}

void crash_describe(const GradeOptions *options, const SandboxResult *ran, const StepInfo *step, StepWords *told)
{
    LastWords words;
    SourcePlace places[MOST_PLACES];
    char object[4096], line[32];
    read_last_words(ran->text, &words);
    const StepInfo *crashed = step ? step : step_find(words.step);
    snprintf(object, sizeof object, "%s/%s/step.so", options->work, crashed ? crashed->id : "none");
    int count = find_places(options, &words, object, places);
    if (ran->exit_code >= 0)
        describe_exit(ran, told->message, sizeof told->message);
    else
        describe_signal(options, ran, &words, places, count, told->message, sizeof told->message);
    write_line(count > 0 && !words.stack_overflow ? places[0].line : 0, line, sizeof line);
    snprintf(told->where, sizeof told->where, "%s%s", count > 0 ? places[0].function : step ? step->symbol : "", line);
}
