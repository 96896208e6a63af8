// However the judge ends, what it started ends with it, by its group. Asked to end, by ctrl-C, a newer save, a limit of
// time, the judge does that itself. For when it is killed a small process of ours waits at a pipe into which the judge
// alone can write. The kernel's signal at a parent's death is not enough: it reaches nobody who has not yet asked for it,
// and bubblewrap's second process asks last.
#include "judge/sandbox/sandbox_parts.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

static volatile sig_atomic_t asked; // the signal
static int running;                 // runs, by all threads
static pthread_once_t once = PTHREAD_ONCE_INIT;

static int witness = -1; // writes: pid of what begins, -pid of what ended
static pid_t who_waits;

#define MOST_AT_ONCE 1024

// What the pipe said is running ends when the pipe's last writer has.
static void wait_for_the_end(int from)
{
    static pid_t groups[MOST_AT_ONCE];
    pid_t told;
    for (int number = 1; number < 32; number++)
        signal(number, SIG_IGN);
    while (read(from, &told, sizeof told) == sizeof told)
        for (int i = 0; i < MOST_AT_ONCE; i++)
            if (groups[i] == (told > 0 ? 0 : -told)) {
                groups[i] = told > 0 ? told : 0;
                break;
            }
    for (int i = 0; i < MOST_AT_ONCE; i++)
        if (groups[i])
            kill(-groups[i], SIGKILL);
    _exit(0);
}

// In a session, and under a name, of its own: what ends the judge's group, or all of its name, spares it.
static void call_witness(void)
{
    int ends[2];
    if (pipe(ends) != 0)
        return;
    pid_t child = fork();
    if (child == 0) {
        setsid();
        int name = open("/proc/self/comm", O_WRONLY);
        ssize_t ignored = write(name, "sandbox's end", 13);
        (void)ignored;
        dup2(ends[0], 0);
        for (int fd = 1; fd < 4096; fd++)
            close(fd);
        wait_for_the_end(0);
    }
    // The end to read from stays open here, too, and nothing waits for room: a witness that somebody kills harms no judge.
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFL, O_NONBLOCK);
    who_waits = child;
    witness = child > 0 && fcntl(ends[1], F_SETFD, FD_CLOEXEC) == 0 ? ends[1] : -1;
}

// A judge that ends by itself takes it along: in a container nobody else may.
static void dismiss_witness(void)
{
    int writes = witness;
    witness = -1;
    if (writes < 0)
        return;
    close(writes);
    waitpid(who_waits, NULL, 0);
}

static void tell(pid_t what)
{
    ssize_t ignored = witness >= 0 ? write(witness, &what, sizeof what) : 0;
    (void)ignored;
}

void sandbox_group_begins(void)
{
    tell(getpid());
}

void sandbox_group_ends(pid_t group)
{
    kill(-group, SIGKILL);
    kill(group, SIGKILL);
    siginfo_t info;
    while (waitid(P_PID, (id_t)group, &info, WEXITED | WNOWAIT) < 0 && errno == EINTR)
        continue; // it may be telling that it begins
    tell(-group);
}

static void end_by(int number)
{
    dismiss_witness();
    signal(number, SIG_DFL);
    raise(number);
}

static void on_signal(int number)
{
    asked = number;
    __sync_synchronize();
    if (__sync_fetch_and_add(&running, 0) == 0)
        end_by(number);
}

static void take_signals(void)
{
    static const int numbers[] = {SIGHUP, SIGINT, SIGTERM};
    struct sigaction before, action = {.sa_handler = on_signal};
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        if (sigaction(numbers[i], NULL, &before) == 0 && before.sa_handler == SIG_DFL) // nohup's stays
            sigaction(numbers[i], &action, NULL);
}

static void prepare(void)
{
    call_witness();
    atexit(dismiss_witness);
    take_signals();
}

bool sandbox_asked_to_end(void)
{
    return asked != 0;
}

void sandbox_run_begins(void)
{
    pthread_once(&once, prepare);
    __sync_add_and_fetch(&running, 1);
    if (asked)
        sandbox_run_ends();
}

void sandbox_run_ends(void)
{
    int left = __sync_sub_and_fetch(&running, 1);
    if (!asked)
        return;
    if (left == 0)
        end_by(asked);
    for (;;) // what was ended has no verdict, and nothing new begins
        pause();
}
