// Without namespaces, as root: the program runs as a user that nobody is, and that no other run has at the same time.
// What it must not read is closed to others by the file system; what it may read of that is copied to a folder of its own.
#define _GNU_SOURCE // setresuid, setgroups
#include "judge/sandbox/sandbox_parts.h"
#include "judge/sandbox/sandbox_folder.h"

#include <errno.h>
#include <fcntl.h>
#include <grp.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

// User numbers that neither Debian nor systemd gives to anyone.
#define FIRST_UID 60600
#define LAST_UID  61100

// No two runs may have one user. An abstract socket's name exists once on a machine, and the kernel frees it when the judge ends,
// however it ends. −1: another run has this user.
static int lock_uid(uid_t uid)
{
    struct sockaddr_un name = {.sun_family = AF_UNIX};
    int length = snprintf(name.sun_path + 1, sizeof name.sun_path - 1, "photonlab-judge-%u", (unsigned)uid);
    int fd = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    socklen_t size = (socklen_t)(offsetof(struct sockaddr_un, sun_path) + 1 + (size_t)length);
    if (fd >= 0 && bind(fd, (struct sockaddr *)&name, size) == 0)
        return fd;
    if (fd >= 0)
        close(fd);
    return -1;
}

static bool is_below(const char *path, const char *top)
{
    size_t length = strlen(top);
    return strncmp(path, top, length) == 0 && (path[length] == '/' || path[length] == '\0');
}

// If one of the paths has to be copied, all are: paths of one folder in arguments are then all turned to the copies.
static bool needs_copies(const SandboxRun *run)
{
    for (int i = 0; i < MOST_VISIBLE && run->visible[i]; i++)
        if (!folder_is_open(run->visible[i]))
            return true;
    return false;
}

// An argument that names what was copied, or what lies in it or above it, is turned to the copy.
static void add_argument(const SandboxRun *run, Launch *launch, const bool *copied, const char *argument)
{
    const char *path = strncmp(argument, "-I", 2) == 0 ? argument + 2 : argument;
    bool moved = run->writable && is_below(path, run->writable);
    for (int i = 0; path[0] == '/' && i < MOST_VISIBLE && run->visible[i]; i++)
        moved = moved || (copied[i] && (is_below(path, run->visible[i]) || is_below(run->visible[i], path)));
    words_add(&launch->arguments, "%.*s%s%s", (int)(path - argument), argument, moved ? launch->folder : "", path);
}

static bool fill_folder(const SandboxRun *run, Launch *launch, bool *copied, Error *error)
{
    bool closed = needs_copies(run);
    for (int i = 0; i < MOST_VISIBLE && run->visible[i]; i++) {
        copied[i] = closed && access(run->visible[i], F_OK) == 0;
        if (copied[i] && !folder_copy(launch->folder, run->visible[i], 0, launch->uid, error))
            return false;
        if (access(run->visible[i], F_OK) == 0)
            words_add(&launch->readable, "%s%s", copied[i] ? launch->folder : "", run->visible[i]);
    }
    return !run->writable || folder_copy(launch->folder, run->writable, launch->uid, launch->uid, error);
}

bool sandbox_uid_prepare(const SandboxRun *run, Launch *launch, Error *error)
{
    for (uid_t uid = FIRST_UID; launch->uid_lock < 0 && uid <= LAST_UID; uid++) {
        launch->uid_lock = lock_uid(uid);
        launch->uid = uid;
    }
    if (launch->uid_lock < 0)
        return error_set(error, "no user is free to run the code as");
    bool copied[MOST_VISIBLE] = {false};
    if (!folder_open(launch->folder, sizeof launch->folder, launch->uid, error) ||
        !fill_folder(run, launch, copied, error))
        return false;
    char *program = sandbox_find_program(run->arguments[0]);
    if (!program)
        return error_set(error, "%s: no such program", run->arguments[0]);
    add_argument(run, launch, copied, program);
    free(program);
    for (const char *const *word = run->arguments + 1; *word; word++)
        add_argument(run, launch, copied, *word);
    words_add(&launch->environment, "TMPDIR=%s%s", launch->folder, run->writable ? run->writable : "");
    launch->hidden = run->hidden;
    return !sandbox_landlock_is_there(false) || sandbox_landlock_prepare(run, launch, launch->folder, error);
}

const char *sandbox_uid_enter(const Launch *launch, const char **path)
{
    gid_t group = launch->uid;
    *path = "";
    if (setgroups(0, NULL) != 0 || setresgid(group, group, group) != 0 ||
        setresuid(launch->uid, launch->uid, launch->uid) != 0)
        return "cannot become another user";
    for (char **word = launch->readable.list; word && *word; word++) {
        *path = *word;
        if (access(*word, R_OK) != 0)
            return "is not readable for the user that the code runs as; run `chmod o+rX` on it and on the directories above it";
    }
    for (int i = 0; i < MOST_HIDDEN && launch->hidden[i]; i++) {
        *path = launch->hidden[i];
        errno = 0;
        if (access(*path, R_OK) == 0 || access(*path, X_OK) == 0)
            return "can be read by the code that is graded; run `chmod -R go-rwx` on it";
    }
    return NULL;
}

// All processes of this user, those that left their group too.
static void end_all(uid_t uid)
{
    pid_t child = fork();
    if (child == 0) {
        if (setresuid(uid, uid, uid) == 0)
            kill(-1, SIGKILL);
        _exit(0);
    }
    while (child > 0 && waitpid(child, NULL, 0) < 0 && errno == EINTR)
        continue;
}

void sandbox_uid_finish(const SandboxRun *run, Launch *launch)
{
    if (launch->uid_lock < 0)
        return;
    end_all(launch->uid);
    if (run->writable && launch->folder[0])
        folder_take_back(launch->folder, run->writable);
    folder_close(launch->folder);
    close(launch->uid_lock);
}
