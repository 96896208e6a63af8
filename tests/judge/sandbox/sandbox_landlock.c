// Landlock: a process says itself what files it will open from here on, and nothing that it starts can open more. It needs no
// rights for that; the kernel looks at the file that a path leads to, so links lead nowhere else. kernel.org, "Landlock:
// unprivileged access control". What it does not hold, opening apart, the filter of system calls does.
#define _GNU_SOURCE // O_PATH, syscall
#include "judge/sandbox/sandbox_parts.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#ifndef SYS_landlock_create_ruleset // headers older than it: calls that no kernel knows
enum { SYS_landlock_create_ruleset = -1, SYS_landlock_add_rule = -1, SYS_landlock_restrict_self = -1 };
#endif

// As linux/landlock.h has them, which is older than the kernel on some systems.
enum {
    EXECUTE = 1 << 0,
    WRITE_FILE = 1 << 1,
    READ_FILE = 1 << 2,
    READ_FOLDER = 1 << 3,
    IN_A_FILE = EXECUTE | WRITE_FILE | READ_FILE | 1 << 14, // and truncate
    READS = EXECUTE | READ_FILE | READ_FOLDER,
    ALL_OF_13 = (1 << 13) - 1 // remove, make: what the first version knew
};
typedef struct {
    uint64_t files, network, kept_in;
} Ruleset;
typedef struct {
    uint64_t access;
    int32_t path;
} __attribute__((packed)) Rule;
enum { ASK_VERSION = 1, BENEATH_PATH = 1 };

// What every version, from the first, added to the files' rights: refer, truncate, nothing, ioctl of devices.
static uint64_t all_rights(long version)
{
    return (uint64_t)ALL_OF_13 | (version >= 2 ? 1 << 13 : 0) | (version >= 3 ? 1 << 14 : 0) |
           (version >= 5 ? 1 << 15 : 0);
}

static long landlock_version(void)
{
    return syscall(SYS_landlock_create_ruleset, NULL, 0, ASK_VERSION);
}

bool sandbox_landlock_is_there(bool alone)
{
    return landlock_version() >= (alone ? 6 : 1);
}

// What is not there needs no rule. Between fork and exec, too: system calls alone.
static bool allow(int ruleset, const char *path, uint64_t rights)
{
    struct stat state;
    Rule rule = {rights & all_rights(landlock_version()), open(path, O_PATH | O_CLOEXEC)};
    if (rule.path < 0)
        return true;
    if (fstat(rule.path, &state) == 0 && !S_ISDIR(state.st_mode))
        rule.access &= IN_A_FILE;
    bool ok = syscall(SYS_landlock_add_rule, ruleset, BENEATH_PATH, &rule, 0) == 0;
    close(rule.path);
    return ok;
}

static bool allow_system(int ruleset)
{
    static const char *const shown[] = {"/usr",   "/bin",   "/sbin",   "/lib",
                                        "/lib32", "/lib64", "/libx32", "/etc/ld.so.cache"};
    bool ok = allow(ruleset, "/dev/null", READS | WRITE_FILE) && allow(ruleset, "/dev/urandom", READS);
    for (size_t i = 0; i < sizeof shown / sizeof *shown; i++)
        ok = ok && allow(ruleset, shown[i], READS);
    return ok;
}

// Rules only add: what is to be hidden must not lie in what is shown whole.
static bool nothing_shows(const SandboxRun *run, const Launch *launch, Error *error)
{
    const char *system = "/usr";
    for (int i = 0; i < MOST_HIDDEN && run->hidden[i]; i++)
        for (size_t j = 0; j <= launch->readable.count; j++) {
            const char *shown = j < launch->readable.count ? launch->readable.list[j] : system;
            size_t length = strlen(shown);
            if (strncmp(run->hidden[i], shown, length) == 0 &&
                (run->hidden[i][length] == '/' || !run->hidden[i][length]))
                return error_set(error, "%s lies in %s, which the code has to read: put it elsewhere", run->hidden[i],
                                 shown);
        }
    return true;
}

bool sandbox_landlock_prepare(const SandboxRun *run, Launch *launch, const char *folder, Error *error)
{
    long version = landlock_version();
    Ruleset all = {all_rights(version), version >= 4 ? 3 : 0, version >= 6 ? 3 : 0};
    size_t size = version >= 6 ? sizeof all : version >= 4 ? 2 * sizeof(uint64_t) : sizeof(uint64_t);
    if (!nothing_shows(run, launch, error))
        return false;
    int ruleset = launch->ruleset_fd = (int)syscall(SYS_landlock_create_ruleset, &all, size, 0);
    bool ok = ruleset >= 0 && allow_system(ruleset) && allow(ruleset, launch->arguments.list[0], READS);
    for (size_t i = 0; ok && i < launch->readable.count; i++)
        ok = allow(ruleset, launch->readable.list[i], READS);
    if (ok && run->writable) {
        char path[4200];
        snprintf(path, sizeof path, "%s%s", folder, run->writable);
        ok = allow(ruleset, path, all.files & ~(uint64_t)EXECUTE);
    }
    return ok || error_set(error, "Landlock's rules could not be made: %s", strerror(errno));
}

bool sandbox_landlock_enter(int ruleset)
{
    bool ok = allow(ruleset, "/proc/self", READ_FILE | READ_FOLDER) && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
              syscall(SYS_landlock_restrict_self, ruleset, 0) == 0;
    close(ruleset);
    return ok;
}
