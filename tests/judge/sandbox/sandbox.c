#include "judge/sandbox/sandbox.h"
#include "judge/sandbox/sandbox_parts.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

// The environment is ours alone; the probe sets itself an alarm, as no signal from outside reaches it in its namespace.
static void fill_environment(const SandboxRun *run, Words *words)
{
    words_add(words, "LC_ALL=C");
    words_add(words, "PATH=" SANDBOX_PATH);
    words_add(words, "HOME=/");
    words_add(words, "OMP_NUM_THREADS=1");
    words_add(words, "ASAN_OPTIONS=detect_leaks=0");
    if (!run->compiler)
        words_add(words, "PHOTONLAB_PROBE_SECONDS=%.3f", run->wall_seconds);
}

// For a sandbox that shows files where they are: the program's own path, its arguments unchanged, and what it may read.
static bool add_arguments(const SandboxRun *run, Launch *launch, Error *error)
{
    char *program = sandbox_find_program(run->arguments[0]);
    if (!program)
        return error_set(error, "%s: no such program", run->arguments[0]);
    words_add(&launch->arguments, "%s", program);
    free(program);
    words_add_each(&launch->arguments, run->arguments + 1);
    for (int i = 0; i < MOST_VISIBLE && run->visible[i]; i++)
        words_add(&launch->readable, "%s", run->visible[i]);
    if (run->writable)
        words_add(&launch->environment, "TMPDIR=%s", run->writable);
    return true;
}

static bool prepare(SandboxKind kind, const SandboxRun *run, Launch *launch, Error *error)
{
    *launch = (Launch){.filter_fd = -1, .ruleset_fd = -1, .uid_lock = -1};
    fill_environment(run, &launch->environment);
    if (kind != SANDBOX_NONE && !sandbox_filter(kind, run, launch, error))
        return false;
    if (kind == SANDBOX_BUBBLEWRAP && !sandbox_bubblewrap(run, launch, error))
        return false;
    if (kind == SANDBOX_UID && !sandbox_uid_prepare(run, launch, error))
        return false;
    if (kind >= SANDBOX_LANDLOCK && !add_arguments(run, launch, error))
        return false;
    if (kind == SANDBOX_LANDLOCK && !sandbox_landlock_prepare(run, launch, "", error))
        return false;
    if (launch->arguments.out_of_memory || launch->environment.out_of_memory || launch->readable.out_of_memory)
        return error_set(error, "not enough memory");
    return true;
}

static void clear(SandboxKind kind, const SandboxRun *run, Launch *launch)
{
    if (kind == SANDBOX_UID)
        sandbox_uid_finish(run, launch);
    if (launch->filter_fd >= 0)
        close(launch->filter_fd);
    if (launch->ruleset_fd >= 0)
        close(launch->ruleset_fd);
    free(launch->filter);
    words_free(&launch->arguments);
    words_free(&launch->environment);
    words_free(&launch->readable);
}

// Closed by exec. Between the two calls a child of another thread may get the ends; it closes them before its own exec.
static bool open_pipe(int ends[2])
{
    return pipe(ends) == 0 && fcntl(ends[0], F_SETFD, FD_CLOEXEC) == 0 && fcntl(ends[1], F_SETFD, FD_CLOEXEC) == 0;
}

// Forks. *out is where what it prints can be read. −1: it could not be started.
static pid_t start(SandboxKind kind, const SandboxRun *run, const Launch *launch, int *out, Error *error)
{
    int printed[2], complaints[2];
    if (!open_pipe(printed)) {
        error_set(error, "pipe: %s", strerror(errno));
        return -1;
    }
    if (!open_pipe(complaints)) {
        error_set(error, "pipe: %s", strerror(errno));
        close(printed[0]);
        close(printed[1]);
        return -1;
    }
    pid_t child = fork();
    int reason = errno;
    if (child == 0)
        sandbox_become(kind, run, launch, printed[1], complaints[1]);
    close(printed[1]);
    close(complaints[1]);
    Complaint complaint;
    ssize_t got;
    while ((got = read(complaints[0], &complaint, sizeof complaint)) < 0 && errno == EINTR)
        continue;
    close(complaints[0]);
    *out = printed[0];
    if (child > 0 && got <= 0)
        return child;
    if (child > 0) {
        waitpid(child, NULL, 0);
        error_set(error, "%s %s%s%s", complaint.path, complaint.what, complaint.reason ? ": " : "",
                  complaint.reason ? strerror(complaint.reason) : "");
    } else {
        error_set(error, "fork: %s", strerror(reason));
    }
    close(printed[0]);
    return -1;
}

bool sandbox_run(SandboxKind kind, const SandboxRun *run, SandboxResult *result, Error *error)
{
    memset(result, 0, sizeof *result);
    result->exit_code = -1;
    result->keeps_beginning = run->compiler;
    result->cpu_limit = run->cpu_seconds;
    result->wall_limit = run->wall_seconds;
    result->memory_mb = run->memory_mb;
    Launch launch;
    int out;
    sandbox_run_begins();
    bool ok = prepare(kind, run, &launch, error);
    pid_t child = ok ? start(kind, run, &launch, &out, error) : -1;
    if (child > 0) {
        sandbox_watch(child, out, run, result);
        close(out);
    }
    clear(kind, run, &launch);
    sandbox_run_ends();
    if (child > 0 && kind == SANDBOX_BUBBLEWRAP && result->exit_code == 1 && strncmp(result->text, "bwrap: ", 7) == 0)
        return error_set(error, "%.*s", (int)strcspn(result->text, "\n"), result->text);
    return child > 0;
}

const char *sandbox_name(SandboxKind kind)
{
    static const char *const names[] = {"bubblewrap", "uid", "landlock", "none"};
    return names[kind];
}

// Does it hold here? Containers often forbid namespaces, and root may be root in name alone.
static bool works(SandboxKind kind, Error *error)
{
    static SandboxResult result;
    const char *const arguments[] = {"true", NULL};
    SandboxRun run = {
        .arguments = arguments, .result_fd = -1, .cpu_seconds = 2, .wall_seconds = 10, .memory_mb = 512, .file_mb = 1};
    if (!sandbox_run(kind, &run, &result, error))
        return false;
    return result.exit_code == 0 || error_set(error, "a trial run failed: %.200s", result.text);
}

static bool may_work(SandboxKind kind, Error *error)
{
    if (kind == SANDBOX_UID && geteuid() != 0)
        return error_set(error, "only root can run code as another user");
    if (kind == SANDBOX_LANDLOCK && geteuid() == 0)
        return error_set(error, "Landlock alone is not for root");
    if (kind == SANDBOX_LANDLOCK && !sandbox_landlock_is_there(true))
        return error_set(error, "Landlock that holds signals needs Linux 6.12");
    return true;
}

SandboxKind sandbox_open(char *reason, size_t size)
{
    const char *wanted = getenv("PHOTONLAB_SANDBOX");
    bool any = !wanted || !*wanted;
    reason[0] = '\0';
    for (SandboxKind kind = SANDBOX_BUBBLEWRAP; kind < SANDBOX_NONE; kind++) {
        Error why = {""};
        if (!any && strcmp(wanted, sandbox_name(kind)) != 0)
            continue;
        if (may_work(kind, &why) && works(kind, &why))
            return kind;
        size_t used = strlen(reason);
        snprintf(reason + used, size - used, "%s%s", used ? "; " : "", why.message);
    }
    if (!any && strcmp(wanted, "none") == 0)
        snprintf(reason, size, "PHOTONLAB_SANDBOX=none asks for it");
    else if (!any && !reason[0])
        snprintf(reason, size, "PHOTONLAB_SANDBOX=%.60s: expected bubblewrap, uid, landlock or none", wanted);
    return SANDBOX_NONE;
}
