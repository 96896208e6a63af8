// What the guarded process tells of its end goes down a pipe, as one Fall; a later one knows more than an earlier.
#include "cli/cli.h"
#include "base/crash_report.h"
#include "base/parallel.h"
#include "base/process.h"
#include "base/text.h"

#include <errno.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__linux__)
#include <sys/prctl.h>
#endif

#define TICK     1  // s of processor time, of all threads together, between looks
#define PATIENCE 10 // ticks a thread without a part of the work done

typedef struct {
    Crash crash;      // signal SIGPROF: it never ends
    InnerPlace inner; // in their code
} Fall;

static int out = -1; // to the one who waits
static char student[PATH_MAX];
static volatile sig_atomic_t ticks, most_ticks;
static Fall fall;

void guard_alive(void)
{
    ticks = 0;
}

static void take_place(const CrashPlace *place)
{
    crash_take_inner(&fall.inner, place, student);
}

static void on_crash(const Crash *crash)
{
    fall.crash = *crash;
    write_all(out, &fall, sizeof fall); // over a broken stack the way up may not be found
    crash_walk(crash->place, take_place);
    write_all(out, &fall, sizeof fall);
}

// It strikes the thread that works. One that stands in the library's own code may just have much to do.
static void on_tick(int number)
{
    int reason = errno;
    if (++ticks > most_ticks) {
        fall.inner.object[0] = '\0';
        crash_walk(NULL, take_place);
        fall.crash.signal = number;
        if (fall.inner.object[0] && write_all(out, &fall, sizeof fall))
            _exit(EXIT_INPUT);
    }
    errno = reason;
}

static void watch(void)
{
    const int fatal[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP};
    crash_watch(on_crash, fatal, sizeof fatal / sizeof *fatal);
    signal(SIGPROF, on_tick);
    const struct itimerval every = {{TICK, 0}, {TICK, 0}};
    setitimer(ITIMER_PROF, &every, NULL);
#if defined(__linux__)
    prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
}

// "step 1.3, 1.3_scatter_diffuse.c:14: scatter_diffuse"
static void name_place(char *text, size_t size)
{
    char offset[32], caller[32], id[8], answer[4096] = "";
    size_t used = 0;
    const char *slash = strrchr(fall.inner.object, '/'), *name = slash ? slash + 1 : fall.inner.object;
    const char *const arguments[] = {"addr2line", "-f", "-i", "-e", fall.inner.object, offset, caller, NULL};
    SourcePlace place;
    Process process;
    snprintf(id, sizeof id, "%.*s", (int)strcspn(name, "_"), name);
    snprintf(offset, sizeof offset, "0x%llx", fall.inner.offset);
    snprintf(caller, sizeof caller, "0x%llx", fall.inner.caller);
    int count = 0;
    if (process_start(&process, arguments, PRINTS_OUTPUT)) {
        int status;
        while (process.output >= 0 || !process_has_ended(&process, &status))
            process_read(&process, answer, sizeof answer, &used);
        count = crash_places(answer, &place, 1);
    }
    const StepInfo *step = step_find(id);
    snprintf(text, size, "step %s", id);
    if (count > 0)
        text_append(text, size, ", %s:%d", place.file, place.line);
    text_append(text, size, ": %s", step ? step->symbol : "?");
}

static void explain(void)
{
    char place[600] = "while none of your steps ran", what[256];
    if (fall.inner.object[0])
        name_place(place, sizeof place);
    if (fall.crash.signal == SIGPROF)
        snprintf(what, sizeof what,
                 "it ran on for %d s of processor time without a part of the work done: a loop that never ends?",
                 PATIENCE * TICK);
    else if (fall.crash.stack_far)
        crash_describe_stack(NULL, fall.inner.calls_itself ? "it" : NULL, what, sizeof what);
    else
        crash_describe_signal(fall.crash.signal, fall.crash.address, "", what, sizeof what);
    fprintf(stderr, "\n%s: %s\n", place, what);
}

static void wait_for(pid_t child, int in)
{
    Fall next;
    int status = 0;
    signal(SIGINT, SIG_IGN); // the one who works knows what to do
    FILE *falls = fdopen(in, "rb");
    if (!falls)
        perror("photonlab: no word of a crash will come");
    while (falls && fread(&next, sizeof next, 1, falls) == 1)
        fall = next;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    if (fall.crash.signal)
        explain();
    else if (WIFSIGNALED(status))
        fprintf(stderr, "\nended by signal %d (%s)\n", WTERMSIG(status), strsignal(WTERMSIG(status)));
    _exit(fall.crash.signal || !WIFEXITED(status) ? EXIT_INPUT : WEXITSTATUS(status));
}

void guard_begin(const char *code, int threads)
{
    int ends[2];
    if (!code || pipe(ends) != 0)
        return;
    snprintf(student, sizeof student, "%.*s/", PATH_MAX - 2, code);
    most_ticks = PATIENCE * parallel_threads(threads);
    pid_t child = fork();
    if (child > 0) {
        close(ends[1]);
        wait_for(child, ends[0]);
    }
    close(ends[0]);
    out = ends[1];
    if (child == 0)
        watch();
}
