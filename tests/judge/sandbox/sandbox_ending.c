// The judge is asked to end, by ctrl-C, a newer save, a limit of time: what it started ends first, by its group. Killed with the judge,
// bubblewrap may leave its second process for ever: until that one is told who it is it knows of no parent whose end is its own.
#include "judge/sandbox/sandbox_parts.h"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

static volatile sig_atomic_t asked; // the signal
static int running;                 // runs, by all threads
static pthread_once_t once = PTHREAD_ONCE_INIT;

static void end_by(int number)
{
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

bool sandbox_asked_to_end(void)
{
    return asked != 0;
}

void sandbox_run_begins(void)
{
    pthread_once(&once, take_signals);
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
