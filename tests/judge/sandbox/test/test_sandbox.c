// The sandbox, from both sides: this program runs itself in it, as `test_sandbox --inside WHAT`, and looks what comes of it.
//   test_sandbox [bubblewrap|uid|landlock|none]     the kind to try; all that there are. As root, Landlock is tried as nobody.
#define _GNU_SOURCE // memfd_create
#include "judge/sandbox/sandbox_parts.h"
#include "judge/sandbox/test/inside.h"

#include <fcntl.h>
#include <grp.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

static char self[300], folder[256], secret[300], open_file[300], public_file[300];

#define RESULTS 64 // more than any test starts at once: a result must stand until it has been looked at

static SandboxKind kind;

// False, with the error: it could not be run.
static bool try_run(const char *what, const char *path, SandboxRun limits, SandboxResult *result, Error *error)
{
    const char *const arguments[] = {self, "--inside", what, path, NULL};
    limits.arguments = arguments;
    limits.visible[0] = self;
    limits.visible[1] = open_file;
    limits.hidden[0] = secret;
    limits.result_fd = limits.result_fd ? limits.result_fd : -1;
    limits.cpu_seconds = limits.cpu_seconds > 0 ? limits.cpu_seconds : 5;
    limits.wall_seconds = limits.wall_seconds > 0 ? limits.wall_seconds : 20;
    limits.memory_mb = limits.memory_mb ? limits.memory_mb : 256;
    limits.file_mb = 1;
    return sandbox_run(kind, &limits, result, error);
}

static SandboxResult *run(const char *what, const char *path, SandboxRun limits)
{
    static SandboxResult results[RESULTS];
    static int next;
    int mine;
#pragma omp atomic capture
    mine = next++;
    Error error = {""};
    SandboxResult *result = &results[mine % RESULTS];
    if (!try_run(what, path, limits, result, &error))
        printf("  %s: %s\n", what, error.message);
    return result;
}

static bool keeps_both_ends(const SandboxResult *r)
{
    return r->left_out > 1000000 && strstr(r->text, "MB of what was printed are left out …\n") &&
           strstr(r->text, "the end\n");
}

static bool takes_its_second(const SandboxResult *r)
{
    return !r->timed_out && r->cpu_seconds > 0.9 && r->cpu_seconds < 3.0 &&
           (r->signal == SIGXCPU || r->signal == SIGKILL);
}

static bool times_out(const SandboxResult *r)
{
    return r->timed_out && r->wall_seconds < 3.0;
}

static bool is_waited_for(const SandboxResult *r)
{
    return r->wall_seconds > 0.9;
}

// One run, and what has to come of it: a code, a signal where one is named, and what `more` asks for. −1: it was ended.
typedef struct {
    const char *name, *what, *path;
    int exit_code, signal;
    bool (*more)(const SandboxResult *result);
    SandboxRun limits;
} Case;

static void one_case(void **state)
{
    const Case *c = *state;
    const SandboxResult *r = run(c->what, c->path ? c->path : "", c->limits);
    if (r->exit_code != c->exit_code || (c->signal && r->signal != c->signal) || (c->more && !c->more(r)))
        fail_msg("exit code %d, signal %d, %.2f s, %.2f s of processor time: %.500s", r->exit_code, r->signal,
                 r->wall_seconds, r->cpu_seconds, r->text);
}

static void descriptors(void **state)
{
    (void)state;
    char text[16] = "";
    int fd = memfd_create("result", MFD_CLOEXEC),
        other = open("/dev/null", O_RDONLY); // without O_CLOEXEC, as fopen does
    SandboxResult *r = run("result", "", (SandboxRun){.result_fd = fd});
    assert_true(r->exit_code == 0 && pread(fd, text, 15, 0) == 6);
    close(fd);
    close(other);
}

static void eight_at_once(void **state)
{
    (void)state;
    int right = 0;
#pragma omp parallel for num_threads(8) reduction(+ : right)
    for (int i = 0; i < 32; i++)
        right += run("read", open_file, (SandboxRun){.result_fd = 0})->exit_code == 1;
    assert_int_equal(right, 32);
}

static void nothing_left_behind(void **state)
{
    (void)state;
    SandboxResult *r = run("behind", "", (SandboxRun){.compiler = true});
    assert_true(r->exit_code == 0 && r->wall_seconds < 10);
    assert_int_not_equal(system("pgrep -f 'test_sandbox --inside behin[d]' >/dev/null"), 0);
}

static void nothing_outlives_a_kill(void **state)
{
    (void)state;
    kill_judges(self, kind);
}

// An exposed secret is no reason for bubblewrap, which does not show it; the user of its own would read it.
static void exposed_secret(void **state)
{
    (void)state;
    static SandboxResult result;
    Error error = {""};
    chmod(secret, 0644);
    bool ran = try_run("read", secret, (SandboxRun){.wall_seconds = 5}, &result, &error);
    chmod(secret, 0600);
    if (kind == SANDBOX_UID)
        assert_true(!ran && strstr(error.message, "chmod -R go-rwx"));
    else
        assert_true(ran && result.exit_code == 0);
}

#define ONE_SECOND {.cpu_seconds = 1, .wall_seconds = 3600} // which may take minutes of a busy machine's

static const Case everywhere[] = {
    {"keeps both ends of what is printed", "print", NULL, 0, 0, keeps_both_ends, {0}},
    {"drains what is printed without end", "flood", NULL, -1, 0, takes_its_second, ONE_SECOND},
    {"ends an endless loop", "spin", NULL, -1, 0, takes_its_second, ONE_SECOND},
    {"ends one that waits for ever", "sleep", NULL, -1, 0, times_out, {.wall_seconds = 0.5}},
    {"lets one go on that gets a processor now and then, and takes less than its second",
     "now and then",
     NULL,
     0,
     0,
     NULL,
     {.cpu_seconds = 1, .wall_seconds = 1}},
    {"waits for one that closed its output", "closed", NULL, 0, 0, is_waited_for, {0}},
    {"refuses memory beyond the limit", "memory", NULL, 77, 0, NULL, {0}},
    {"tells of a signal", "abort", NULL, -1, 0, NULL, {0}},
    {"gives an environment of its own", "environment", NULL, 0, 0, NULL, {0}},
    {"shows what is visible", "read", open_file, 1, 0, NULL, {0}},
};

static const Case confined[] = {
    {"hides what is not", "read", secret, 0, 0, NULL, {0}},
    {"runs as nobody", "root", NULL, -1, SIGSYS, NULL, {0}},
    {"ends a probe at: socket", "socket", NULL, -1, SIGSYS, NULL, {0}},
    {"ends a probe at: fork", "fork", NULL, -1, SIGSYS, NULL, {0}},
    {"ends a probe at: write", "write", NULL, -1, SIGSYS, NULL, {0}},
    {"ends a probe at: huge", "huge", NULL, -1, SIGSYS, NULL, {0}},
    {"lets nobody else be signalled", "signal", NULL, 0, 0, NULL, {0}},
    {"gives a compiler no socket, but lets it live", "socket", NULL, 0, 0, NULL, {.compiler = true}},
    {"lets a compiler fork", "fork", NULL, 1, 0, NULL, {.compiler = true}},
    // A user of its own sees these where the kernel has no Landlock.
    {"hides what all others may read", "read", public_file, 0, 0, NULL, {0}},
    {"hides it from a compiler", "read", public_file, 0, 0, NULL, {.compiler = true}},
    {"hides others' command lines", "command line", NULL, 0, 0, NULL, {0}},
};
#define BY_LANDLOCK 3

#define COUNT(array) (sizeof(array) / sizeof *(array))

static int test_kind(void)
{
    char reason[2048];
    setenv("PHOTONLAB_SANDBOX", sandbox_name(kind), 1);
    if (sandbox_open(reason, sizeof reason) != kind) {
        printf("○ %s: not here: %s\n", sandbox_name(kind), reason);
        return 0;
    }
    struct CMUnitTest tests[COUNT(everywhere) + COUNT(confined) + 5] = {
        {.name = "gives descriptor 3 and no other", .test_func = descriptors},
        {.name = "runs 8 at once", .test_func = eight_at_once},
        {.name = "takes with it what it started when it is killed", .test_func = nothing_outlives_a_kill},
        {.name = "leaves no process behind", .test_func = nothing_left_behind},
        {.name = "minds a secret that others can read, or hides it", .test_func = exposed_secret},
    };
    bool none = kind == SANDBOX_NONE;
    size_t count = none ? 3 : 5; // the last two are about a sandbox
    size_t without = kind == SANDBOX_UID && !sandbox_landlock_is_there(false) ? BY_LANDLOCK : 0;
    for (size_t i = 0; i < COUNT(everywhere) + (none ? 0 : COUNT(confined) - without); i++) {
        const Case *c = i < COUNT(everywhere) ? &everywhere[i] : &confined[i - COUNT(everywhere)];
        tests[count++] = (struct CMUnitTest){.name = c->name, .test_func = one_case, .initial_state = (void *)c};
    }
    return _cmocka_run_group_tests(sandbox_name(kind), tests, count, NULL, NULL);
}

#define NOBODY 65534

// From its beginning, as threads do not go on in a child.
static int test_as_nobody(void)
{
    int state = 1;
    fflush(stdout);
    pid_t child = fork();
    if (child == 0) {
        if (setgroups(0, NULL) == 0 && setgid(NOBODY) == 0 && setuid(NOBODY) == 0)
            execl(self, self, sandbox_name(SANDBOX_LANDLOCK), (char *)NULL);
        _exit(3);
    }
    waitpid(child, &state, 0);
    return state != 0;
}

static void write_file(const char *path, mode_t mode)
{
    int fd = open(path, O_CREAT | O_WRONLY, 0600);
    if (fd < 0 || write(fd, "here\n", 5) != 5 || fchmod(fd, mode) != 0 || close(fd) != 0)
        exit(3);
}

int main(int count, char **arguments)
{
    if (count == 4 && strcmp(arguments[1], "--inside") == 0)
        return inside(arguments[2], arguments[3]);
    snprintf(self, sizeof self, "%s", arguments[0]);
    if (count == 4 && strcmp(arguments[1], "--sleep") == 0)
        return killed_judge(self, arguments[2], strcmp(arguments[3], "compiler") == 0);
    if (count > 4)
        return 2;
    char copy[1024];
    snprintf(folder, sizeof folder, "/tmp/photonlab-test-XXXXXX");
    if (!mkdtemp(folder) || chmod(folder, 0755) != 0)
        return 3;
    // Where every user can start it, wherever the checkout lies.
    snprintf(self, sizeof self, "%s/test_sandbox", folder);
    snprintf(copy, sizeof copy, "cp /proc/%d/exe %s && chmod 755 %s", (int)getpid(), self, self);
    if (system(copy) != 0)
        return 3;
    snprintf(secret, sizeof secret, "%s/secret", folder);
    snprintf(open_file, sizeof open_file, "%s/open", folder);
    write_file(secret, 0600);
    snprintf(public_file, sizeof public_file, "%s/public", folder);
    write_file(open_file, 0644);
    write_file(public_file, 0644);
    setenv("PHOTONLAB_TEST_LEAK", "1", 1);
    int failed = 0;
    for (kind = SANDBOX_BUBBLEWRAP; kind <= SANDBOX_NONE; kind++)
        if (count == 1 || strcmp(arguments[1], sandbox_name(kind)) == 0)
            failed += kind == SANDBOX_LANDLOCK && geteuid() == 0 ? test_as_nobody() : test_kind();
    const char *const made[] = {self, secret, open_file, public_file};
    for (size_t i = 0; i < COUNT(made); i++)
        unlink(made[i]);
    rmdir(folder);
    return failed > 0;
}
