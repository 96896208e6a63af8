// What test_sandbox does in the sandbox: what may be done there, and what an attacker would try.
#define _GNU_SOURCE // syscall
#include "judge/sandbox/test/inside.h"
#include "judge/sandbox/sandbox_parts.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

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

static int can_read_command_line(void)
{
    char path[64];
    snprintf(path, sizeof path, "/proc/%d/cmdline", (int)getppid());
    return can_read(path);
}

// A processor now and then, as on a busy machine: half a second of it, in 3 s.
static int work_now_and_then(void)
{
    for (int i = 0; i < 10; i++, usleep(250000))
        for (clock_t enough = clock() + CLOCKS_PER_SEC / 20; clock() < enough;)
            continue;
    return 0;
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

int inside(const char *what, const char *path)
{
    if (strcmp(what, "print") == 0)
        return print_much(1u << 20);
    if (strcmp(what, "flood") == 0)
        return print_much((size_t)1 << 34);
    if (strcmp(what, "spin") == 0)
        for (volatile long i = 0; i >= 0; i++)
            continue;
    if (strcmp(what, "sleep") == 0)
        return (int)sleep(300);
    if (strcmp(what, "now and then") == 0)
        return work_now_and_then();
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
    if (strcmp(what, "command line") == 0)
        return can_read_command_line();
    if (strcmp(what, "signal") == 0)
        return syscall(SYS_tgkill, getppid(), getppid(), 0) == 0;
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
