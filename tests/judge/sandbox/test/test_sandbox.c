// The sandbox, from both sides: this program runs itself in it, as `test_sandbox --inside WHAT`, and looks what comes of it.
//   test_sandbox [bubblewrap|uid|none]…     the kinds to try; all that there are
#define _GNU_SOURCE // memfd_create, syscall
#include "judge/sandbox/sandbox.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static int passed, failed;
static char self[4096], room[256], secret[300], open_file[300];

static void check(SandboxKind kind, bool holds, const char *what)
{
    passed += holds;
    failed += !holds;
    printf("%s %s: %s\n", holds ? "✓" : "✗", sandbox_name(kind), what);
}

// ---- inside ----

static int print_much(size_t bytes)
{
    for (size_t i = 0; i < bytes; i += 64)
        if (write(1, "012345678901234567890123456789012345678901234567890123456789abc\n", 64) != 64)
            return 1;
    printf("the end\n");
    return 0;
}

static int eat_memory(void)
{
    for (int i = 0; i < 100; i++) {
        char *part = malloc(16u << 20);
        if (!part)
            return 77;
        memset(part, 1, 16u << 20);
    }
    return 0;
}

static int can_read(const char *path)
{
    int fd = open(path, O_RDONLY);
    return fd >= 0 ? 1 : 0;
}

static int go_on_behind(void)
{
    signal(SIGHUP, SIG_IGN);
    if (fork() == 0) {
        setsid();
        sleep(300);
    }
    return 0;
}

static int inside(const char *what, const char *path)
{
    if (strcmp(what, "print") == 0)
        return print_much(1u << 20);
    if (strcmp(what, "flood") == 0)
        return print_much((size_t)1 << 34);
    if (strcmp(what, "spin") == 0)
        for (volatile long i = 0;; i++)
            continue;
    if (strcmp(what, "sleep") == 0)
        return (int)sleep(300);
    if (strcmp(what, "closed") == 0)
        return close(1), close(2), (int)sleep(1);
    if (strcmp(what, "memory") == 0)
        return eat_memory();
    if (strcmp(what, "result") == 0)
        return write(3, "result", 6) == 6 && fcntl(4, F_GETFD) < 0 && fcntl(5, F_GETFD) < 0 && fcntl(6, F_GETFD) < 0
                   ? 0
                   : 1;
    if (strcmp(what, "read") == 0)
        return can_read(path);
    if (strcmp(what, "environment") == 0)
        return getenv("PHOTONLAB_TEST_LEAK") ? 1 : 0;
    if (strcmp(what, "root") == 0)
        return getuid() == 0 || setuid(0) == 0;
    if (strcmp(what, "socket") == 0)
        return socket(AF_INET, SOCK_STREAM, 0) >= 0 ? 1 : 0;
    if (strcmp(what, "fork") == 0)
        return fork() < 0 ? 0 : 1;
    if (strcmp(what, "write") == 0)
        return open("/tmp/photonlab-test-left-behind", O_CREAT | O_WRONLY, 0600) >= 0 ? 1 : 0;
    if (strcmp(what, "huge") == 0)
        return mmap(NULL, (size_t)1 << 40, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED ? 0 : 1;
    if (strcmp(what, "abort") == 0)
        signal(SIGABRT, SIG_DFL), abort();
    if (strcmp(what, "behind") == 0)
        return go_on_behind();
    return 99;
}

// ---- outside ----

#define RESULTS 64 // more than any test starts at once: a result must stand until it has been looked at

static SandboxResult *run(SandboxKind kind, const char *what, const char *path, SandboxRun limits)
{
    static SandboxResult result[RESULTS];
    static int next;
    int mine;
#pragma omp atomic capture
    mine = next++;
    const char *const arguments[] = {self, "--inside", what, path, NULL};
    Error error = {""};
    limits.arguments = arguments;
    limits.visible[0] = self;
    limits.visible[1] = open_file;
    limits.hidden[0] = secret;
    limits.result_fd = limits.result_fd ? limits.result_fd : -1;
    limits.cpu_seconds = limits.cpu_seconds > 0 ? limits.cpu_seconds : 5;
    limits.wall_seconds = limits.wall_seconds > 0 ? limits.wall_seconds : 20;
    limits.memory_mb = limits.memory_mb ? limits.memory_mb : 256;
    limits.file_mb = 1;
    SandboxResult *mine_result = &result[mine % RESULTS];
    if (!sandbox_run(kind, &limits, mine_result, &error))
        printf("  %s: %s\n", what, error.message);
    return mine_result;
}

#define PLAIN ((SandboxRun){.result_fd = 0})

static void test_limits(SandboxKind kind)
{
    SandboxResult *r = run(kind, "print", "", PLAIN);
    check(kind, r->exit_code == 0 && r->printed == (1u << 20) + 8 && strstr(r->text, "the end\n"),
          "keeps the end of what is printed");
    r = run(kind, "flood", "", PLAIN);
    check(kind, r->flooded && r->exit_code != 0, "ends a program that prints without end");
    r = run(kind, "spin", "", (SandboxRun){.cpu_seconds = 1, .wall_seconds = 60});
    check(kind, r->signal == SIGXCPU || r->signal == SIGKILL, "ends an endless loop");
    check(kind, r->cpu_seconds > 0.9 && r->cpu_seconds < 3.0, "after the processor time it was given");
    r = run(kind, "sleep", "", (SandboxRun){.wall_seconds = 0.5});
    check(kind, r->timed_out && r->wall_seconds < 3.0, "ends one that waits for ever");
    r = run(kind, "closed", "", PLAIN);
    check(kind, r->exit_code == 0 && r->wall_seconds > 0.9, "waits for one that closed its output");
    r = run(kind, "memory", "", PLAIN);
    check(kind, r->exit_code == 77, "refuses memory beyond the limit");
    r = run(kind, "abort", "", PLAIN);
    check(kind, r->signal != 0 && r->exit_code == -1, "tells of a signal");
}

static void test_files(SandboxKind kind)
{
    char text[16] = "";
    int fd = memfd_create("result", MFD_CLOEXEC),
        other = open("/dev/null", O_RDONLY); // without O_CLOEXEC, as fopen does
    SandboxResult *r = run(kind, "result", "", (SandboxRun){.result_fd = fd});
    check(kind, r->exit_code == 0 && pread(fd, text, 15, 0) == 6, "gives descriptor 3 and no other");
    close(fd);
    close(other);
    setenv("PHOTONLAB_TEST_LEAK", "1", 1);
    check(kind, run(kind, "environment", "", PLAIN)->exit_code == 0, "gives an environment of its own");
    check(kind, run(kind, "read", open_file, PLAIN)->exit_code == 1, "shows what is visible");
    if (kind == SANDBOX_NONE)
        return;
    check(kind, run(kind, "read", secret, PLAIN)->exit_code == 0, "hides what is not");
    check(kind, run(kind, "root", "", PLAIN)->exit_code != 1, "runs as nobody");
}

static void test_calls(SandboxKind kind)
{
    static const char *const calls[] = {"socket", "fork", "write", "huge"};
    for (size_t i = 0; i < sizeof calls / sizeof *calls; i++) {
        char what[80];
        SandboxResult *r = run(kind, calls[i], "", PLAIN);
        snprintf(what, sizeof what, "ends a probe at: %s", calls[i]);
        check(kind, r->signal == SIGSYS, what);
    }
    SandboxResult *r = run(kind, "socket", "", (SandboxRun){.compiler = true});
    check(kind, r->exit_code == 0, "gives a compiler no socket, but lets it live");
    r = run(kind, "fork", "", (SandboxRun){.compiler = true});
    check(kind, r->exit_code == 1, "lets a compiler fork");
    r = run(kind, "behind", "", (SandboxRun){.compiler = true});
    check(kind,
          r->exit_code == 0 && r->wall_seconds < 10 &&
              system("pgrep -f 'test_sandbox --inside behin[d]' >/dev/null") != 0,
          "leaves no process behind");
}

static void test_together(SandboxKind kind)
{
    int right = 0;
#pragma omp parallel for num_threads(8) reduction(+ : right)
    for (int i = 0; i < 32; i++)
        right += run(kind, "read", open_file, PLAIN)->exit_code == 1;
    check(kind, right == 32, "runs 8 at once");
}

// An exposed secret is no reason for bubblewrap, which does not show it; the user of its own would read it.
static void test_exposed(SandboxKind kind)
{
    const char *const arguments[] = {self, "--inside", "read", secret, NULL};
    static SandboxResult result;
    Error error = {""};
    SandboxRun exposed = {.arguments = arguments,
                          .visible = {self},
                          .hidden = {secret},
                          .result_fd = -1,
                          .cpu_seconds = 2,
                          .wall_seconds = 5,
                          .memory_mb = 256,
                          .file_mb = 1};
    chmod(secret, 0644);
    bool ran = sandbox_run(kind, &exposed, &result, &error);
    chmod(secret, 0600);
    if (kind == SANDBOX_UID)
        check(kind, !ran && strstr(error.message, "chmod -R go-rwx"),
              "refuses to run when others can read what is hidden");
    else
        check(kind, ran && result.exit_code == 0, "hides what others can read");
}

static void test_kind(SandboxKind kind)
{
    char reason[2048];
    setenv("PHOTONLAB_SANDBOX", sandbox_name(kind), 1);
    SandboxKind got = sandbox_open(reason, sizeof reason);
    if (got != kind) {
        printf("○ %s: not here: %s\n", sandbox_name(kind), reason);
        return;
    }
    test_limits(kind);
    test_files(kind);
    test_together(kind);
    if (kind == SANDBOX_NONE)
        return;
    test_calls(kind);
    test_exposed(kind);
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
    if (count > 4)
        return 2;
    ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    snprintf(room, sizeof room, "/tmp/photonlab-test-XXXXXX");
    if (length <= 0 || !mkdtemp(room) || chmod(room, 0755) != 0)
        return 3;
    snprintf(secret, sizeof secret, "%s/secret", room);
    snprintf(open_file, sizeof open_file, "%s/open", room);
    write_file(secret, 0600);
    write_file(open_file, 0644);
    for (int kind = SANDBOX_BUBBLEWRAP; kind <= SANDBOX_NONE; kind++)
        if (count == 1 || strcmp(arguments[1], sandbox_name((SandboxKind)kind)) == 0)
            test_kind((SandboxKind)kind);
    unlink(secret);
    unlink(open_file);
    rmdir(room);
    printf("%d passed, %d failed\n", passed, failed);
    return failed > 0;
}
