#define _GNU_SOURCE // environ
#include "base/process.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

extern char **environ;

bool pipe_open(int ends[2])
{
    if (pipe(ends) != 0)
        return false;
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    return true;
}

bool write_all(int file, const void *bytes, size_t size)
{
    const char *rest = bytes;
    while (size > 0) {
        ssize_t written = write(file, rest, size);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        rest += written;
        size -= (size_t)written;
    }
    return true;
}

bool process_start(Process *process, const char *const *arguments, ProcessPrints prints)
{
    int ends[2];
    *process = (Process){0, -1};
    if (!pipe_open(ends))
        return false;
    setenv("LC_ALL", "C", true);
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; stream++)
        if (prints & 1 << stream)
            posix_spawn_file_actions_adddup2(&actions, ends[1], stream);
        else
            posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    pid_t pid = 0;
    int failed = posix_spawnp(&pid, arguments[0], &actions, &attributes, (char *const *)arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    close(ends[1]);
    if (failed)
        close(ends[0]);
    else
        *process = (Process){pid, ends[0]};
    errno = failed;
    return !failed;
}

static void close_output(Process *process)
{
    if (process->output >= 0)
        close(process->output);
    process->output = -1;
}

void process_read(Process *process, char *text, size_t size, size_t *used)
{
    char bytes[4096];
    while (process->output >= 0) {
        ssize_t got = read(process->output, bytes, sizeof bytes);
        if (got <= 0) {
            if (got == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR))
                close_output(process);
            return;
        }
        size_t left = size - 1 - *used, kept = (size_t)got < left ? (size_t)got : left;
        memcpy(text + *used, bytes, kept);
        *used += kept;
        text[*used] = '\0';
    }
}

bool process_has_ended(Process *process, int *status)
{
    if (process->pid <= 0 || waitpid(process->pid, status, WNOHANG) != process->pid)
        return false;
    process->pid = 0;
    return true;
}

void process_kill(Process *process)
{
    if (process->pid > 0) {
        kill(-process->pid, SIGKILL);
        while (waitpid(process->pid, NULL, 0) < 0 && errno == EINTR)
            continue;
        process->pid = 0;
    }
    close_output(process);
}

void process_end(Process *process)
{
    bool there = process->pid > 0 && kill(-process->pid, SIGTERM) == 0;
    pid_t group = process->pid;
    int status;
    // Its first process may end before the rest of its group, which keeps the number from being given to others.
    for (int waited = 0; there && waited < 300; waited++) { // ms
        process_has_ended(process, &status);
        there = kill(-group, 0) == 0;
        if (there)
            nanosleep(&(struct timespec){0, 1000000}, NULL);
    }
    if (there)
        kill(-group, SIGKILL);
    process_kill(process);
}
