#include "judge/sandbox/test/inside.h"

#include <poll.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmocka.h>

// What runs for it holds descriptor 3.
int killed_judge(const char *self, const char *name, bool compiler)
{
    static SandboxResult result;
    SandboxKind kind;
    const char *const arguments[] = {self, "--inside", "sleep", "", NULL};
    Error error = {""};
    for (kind = SANDBOX_BUBBLEWRAP; strcmp(name, sandbox_name(kind)) != 0;)
        kind++;
    SandboxRun run = {.arguments = arguments,
                      .visible = {self},
                      .result_fd = 3,
                      .compiler = compiler,
                      .cpu_seconds = 5,
                      .wall_seconds = 300,
                      .memory_mb = 256,
                      .file_mb = 1};
    return !sandbox_run(kind, &run, &result, &error);
}

// At any moment: while one of bubblewrap's two processes does not know the other, too.
void kill_judges(const char *self, SandboxKind kind)
{
    int in_time = 0; // killed before it could end by itself
    // Dead ones count against the user's limit until somebody asks for them, and not everybody's init makes haste.
    assert_int_equal(prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0), 0);
    for (int i = 0; i < 100; i++) {
        int ends[2];
        assert_int_equal(pipe(ends), 0);
        pid_t judge = fork();
        if (judge == 0) {
            dup2(ends[1], 3);
            for (int fd = 4; fd < 16; fd++)
                close(fd);
            execl(self, self, "--sleep", sandbox_name(kind), i % 2 ? "compiler" : "probe", (char *)NULL);
            _exit(3);
        }
        close(ends[1]);
        usleep((useconds_t)i * 250); // all it has to do until then takes some 10 ms
        int status;
        kill(judge, SIGKILL);
        waitpid(judge, &status, 0);
        in_time += WIFSIGNALED(status);
        struct pollfd last = {.fd = ends[0]};
        assert_int_equal(poll(&last, 1, 20000), 1);
        close(ends[0]);
        while (waitpid(-1, NULL, WNOHANG) > 0)
            continue;
    }
    prctl(PR_SET_CHILD_SUBREAPER, 0, 0, 0, 0);
    assert_int_equal(in_time, 100);
}
