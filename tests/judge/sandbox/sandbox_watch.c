// From the start to the end of what runs: reads what it prints, ends it when its time is up, takes its state.
#define _GNU_SOURCE // wait4
#include "judge/sandbox/sandbox_parts.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#define GRACE 1.0 // s from the probe's own alarm to the end by force

#define KEPT (sizeof((SandboxResult *)NULL)->text - 1)
#define HEAD (KEPT / 2) // of it, for the beginning

// Keeps beginning and end of what is printed, however much that is; of what a compiler says, the beginning.
static void keep(SandboxResult *result, size_t *used, const char *bytes, size_t count)
{
    size_t room = KEPT - *used;
    if (result->keeps_beginning && count > room) {
        result->left_out += count - room;
        count = room;
    }
    if (count > room) { // a chunk is no longer than the room for the end
        size_t surplus = count - room;
        memmove(result->text + HEAD, result->text + HEAD + surplus, *used - HEAD - surplus);
        *used -= surplus;
        result->left_out += surplus;
    }
    memcpy(result->text + *used, bytes, count);
    *used += count;
    result->text[*used] = '\0';
}

// A line in the place of what was left out, and of the parts of lines beside it.
static void mark_gap(SandboxResult *result)
{
    if (result->left_out == 0 || result->keeps_beginning)
        return;
    char *end = result->text + HEAD, *rest = strchr(end, '\n'), line[80];
    while (end > result->text && end[-1] != '\n')
        end--;
    rest = rest ? rest + 1 : result->text + HEAD;
    int length = snprintf(line, sizeof line, "%s… %.3g MB of what was printed are left out …\n",
                          end == result->text ? "\n" : "", 1e-6 * (double)(result->left_out + (size_t)(rest - end)));
    if (end + length > rest)
        end = rest - length;
    memcpy(end, line, (size_t)length);
    memmove(end + length, rest, strlen(rest) + 1);
}

// True while there may be more to come.
static bool read_some(int out, SandboxResult *result, size_t *used)
{
    char bytes[KEPT - HEAD];
    ssize_t got = read(out, bytes, sizeof bytes);
    if (got > 0)
        keep(result, used, bytes, (size_t)got);
    return got > 0 || (got < 0 && errno == EINTR);
}

// bubblewrap tells of a signal as a shell does, and so does the probe.
static void read_state(SandboxResult *result)
{
    if (result->exit_code > 128 && result->exit_code <= 128 + 64) {
        result->signal = result->exit_code - 128;
        result->exit_code = -1;
    }
    result->timed_out = result->timed_out || result->signal == SIGALRM;
}

void sandbox_watch(pid_t child, int out, const SandboxRun *run, SandboxResult *result)
{
    double begin = sandbox_now();
    Waiting waiting = {begin, begin + run->wall_seconds + GRACE, 0.0, 0.0};
    size_t used = 0;
    bool more = true, ended = false;
    int state = 0;
    struct rusage usage;
    while (!ended && !result->timed_out && !sandbox_asked_to_end()) {
        struct pollfd wait = {more ? out : -1, POLLIN, 0};
        if (poll(&wait, 1, more ? 20 : 2) > 0)
            more = read_some(out, result, &used);
        sandbox_end_spent(child, run, &waiting);
        siginfo_t info = {.si_pid = 0};
        // WNOWAIT: not reaped yet. Until then its number, which is its group's, too, is given to nobody else, and the kill
        // below ends no stranger.
        ended = waitid(P_PID, (id_t)child, &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == child;
        result->timed_out = !ended && sandbox_waits_too_long(child, run, &waiting);
    }
    sandbox_group_ends(child);
    while (wait4(child, &state, 0, &usage) < 0 && errno == EINTR)
        continue;
    // Reads what is still in the pipe. It ends when the last process that holds it does; a process that left the group may
    // hold it for ever, so not for long.
    for (double deadline = sandbox_now() + GRACE; more && sandbox_now() < deadline;) {
        struct pollfd wait = {out, POLLIN, 0};
        if (poll(&wait, 1, 50) > 0)
            more = read_some(out, result, &used);
    }
    mark_gap(result);
    result->wall_seconds = sandbox_now() - begin;
    result->cpu_seconds = (double)usage.ru_utime.tv_sec + (double)usage.ru_stime.tv_sec +
                          1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
    result->exit_code = WIFEXITED(state) ? WEXITSTATUS(state) : -1;
    result->signal = WIFSIGNALED(state) ? WTERMSIG(state) : 0;
    read_state(result);
}
