// From fork to exec: descriptors, limits, user, filter.
#define _GNU_SOURCE // F_DUPFD beyond POSIX headers, syscall, vasprintf
#include "judge/sandbox/sandbox_parts.h"

#include "base/array.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/syscall.h>
#endif

// Descriptors of the child, before it becomes the program.
enum { RESULT_FD = 3, RULES_FD = 4, COMPLAINT_FD = 5, FIRST_OTHER_FD = 6 };

void words_add(Words *words, const char *format, ...)
{
    if (!array_reserve(&words->list, words->count + 2, &words->capacity, sizeof *words->list)) {
        words->out_of_memory = true;
        return;
    }
    va_list arguments;
    va_start(arguments, format);
    if (vasprintf(&words->list[words->count], format, arguments) >= 0)
        words->count++;
    else
        words->out_of_memory = true;
    va_end(arguments);
    words->list[words->count] = NULL;
}

void words_add_each(Words *words, const char *const *each)
{
    for (; *each; each++)
        words_add(words, "%s", *each);
}

void words_free(Words *words)
{
    for (size_t i = 0; i < words->count; i++)
        free(words->list[i]);
    free(words->list);
}

char *sandbox_find_program(const char *name)
{
    if (strchr(name, '/'))
        return access(name, X_OK) == 0 ? strdup(name) : NULL;
    for (const char *from = SANDBOX_PATH; *from;) {
        char path[512];
        size_t length = strcspn(from, ":");
        snprintf(path, sizeof path, "%.*s/%s", (int)length, from, name);
        if (access(path, X_OK) == 0)
            return strdup(path);
        from += length + (from[length] == ':');
    }
    return NULL;
}

#if defined(__GLIBC__)
typedef __rlimit_resource_t Resource;
#else
typedef int Resource;
#endif

static void limit(Resource what, double soft, double hard)
{
    struct rlimit wanted = {(rlim_t)soft, (rlim_t)hard}, there;
    if (getrlimit(what, &there) == 0 && there.rlim_max < wanted.rlim_max)
        wanted.rlim_max = there.rlim_max;
    wanted.rlim_cur = wanted.rlim_cur < wanted.rlim_max ? wanted.rlim_cur : wanted.rlim_max;
    setrlimit(what, &wanted);
}

static void set_limits(SandboxKind kind, const SandboxRun *run)
{
    double megabyte = 1024.0 * 1024.0, seconds = sandbox_seconds(run);
    limit(RLIMIT_CPU, seconds + 1.5, seconds + 2.5); // sandbox_end_spent is earlier, where it can
    limit(RLIMIT_CORE, 0, 0);
    limit(RLIMIT_STACK, 8 * megabyte, 8 * megabyte);
    limit(RLIMIT_NOFILE, 256, 256);
    limit(RLIMIT_FSIZE, (double)run->file_mb * megabyte, (double)run->file_mb * megabyte);
    if (run->memory_mb > 0)
        limit(RLIMIT_AS, (double)run->memory_mb * megabyte, (double)run->memory_mb * megabyte);
    if (kind == SANDBOX_UID)
        limit(RLIMIT_NPROC, 64, 64); // elsewhere it would count the judge's own user's processes
}

static void complain(const char *what, const char *path)
{
    Complaint complaint = {.reason = errno};
    strncpy(complaint.what, what, sizeof complaint.what - 1);
    strncpy(complaint.path, path, sizeof complaint.path - 1);
    ssize_t ignored = write(COMPLAINT_FD, &complaint, sizeof complaint);
    (void)ignored;
    _exit(126);
}

// Puts descriptors in their places. Moved out of the way first, since they may stand in each other's.
static void place_descriptors(int out, int result, int rules, int complaint)
{
    const int wanted[] = {-1, out, out, result, rules, complaint};
    int moved[FIRST_OTHER_FD];
    for (int i = 0; i < FIRST_OTHER_FD; i++)
        moved[i] = wanted[i] < 0 ? -1 : fcntl(wanted[i], F_DUPFD, 16);
    moved[0] = open("/dev/null", O_RDONLY);
    for (int i = 0; i < FIRST_OTHER_FD; i++) {
        if (moved[i] < 0)
            close(i);
        else if (moved[i] != i)
            dup2(moved[i], i);
    }
    fcntl(COMPLAINT_FD, F_SETFD, FD_CLOEXEC);
    // The program must not inherit what other threads of the judge have open.
#ifdef SYS_close_range
    if (syscall(SYS_close_range, FIRST_OTHER_FD, ~0u, 0) == 0)
        return;
#endif
    for (int fd = FIRST_OTHER_FD; fd < 4096; fd++)
        close(fd);
}

// Runs between fork and exec. The judge has threads, so that only system calls are safe here.
void sandbox_become(SandboxKind kind, const SandboxRun *run, const Launch *launch, int out, int complaint)
{
    const char *path = launch->arguments.list[0], *problem;
    sigset_t none;
    setsid();
    sandbox_group_begins();
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    for (int number = 1; number < 32; number++)
        signal(number, SIG_DFL);
    // bubblewrap reads its filter there; otherwise it is Landlock's, and gone after it.
    place_descriptors(out, run->result_fd, kind == SANDBOX_BUBBLEWRAP ? launch->filter_fd : launch->ruleset_fd,
                      complaint);
    set_limits(kind, run);
    if (chdir("/") != 0)
        complain("cannot enter /", "");
    umask(022);
    if (kind == SANDBOX_UID) {
        problem = sandbox_uid_enter(launch, &path);
        if (problem)
            complain(problem, path);
        path = launch->arguments.list[0];
    }
    sandbox_end_with_parent();
    if (launch->ruleset_fd >= 0 && !sandbox_landlock_enter(RULES_FD))
        complain("Landlock's rules are refused", "");
    if ((kind == SANDBOX_UID || kind == SANDBOX_LANDLOCK) && !sandbox_filter_enter(launch))
        complain("the filter of system calls is refused", "");
    // "Text file busy": another thread's child holds the copy open for writing until its own exec, a moment later.
    for (int attempt = 0; attempt < 500; attempt++) {
        execve(path, launch->arguments.list, launch->environment.list);
        if (errno != ETXTBSY)
            break;
        nanosleep(&(struct timespec){0, 10000000}, NULL);
    }
    complain("cannot be started", path);
}
