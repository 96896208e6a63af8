// bwrap's arguments: namespaces of its own, and a file system that holds the system's programs and what is visible.
#include "judge/sandbox/sandbox_parts.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// A user and group that nobody has.
#define NOBODYS "60600"

static void bind_path(Words *words, const char *how, const char *from, const char *to)
{
    words_add_each(words, (const char *const[]){how, from, to, NULL});
}

// /lib and the like are links into /usr on most systems, directories on some.
static void show_system(Words *words)
{
    static const char *const names[] = {"/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32"};
    bind_path(words, "--ro-bind", "/usr", "/usr");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char target[4096];
        ssize_t length = readlink(names[i], target, sizeof target - 1);
        target[length > 0 ? length : 0] = '\0';
        bind_path(words, length > 0 ? "--symlink" : "--ro-bind-try", length > 0 ? target : names[i], names[i]);
    }
}

static void show_files(Words *words, const SandboxRun *run)
{
    static const char *const settings[] = {"/etc/ld.so.cache", "/etc/ld.so.conf", "/etc/ld.so.conf.d",
                                           "/etc/alternatives"};
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++)
        bind_path(words, "--ro-bind-try", settings[i], settings[i]);
    // A checkout may lie below /usr, or what is hidden within what is shown.
    struct stat state;
    for (int i = 0; i < MOST_HIDDEN && run->hidden[i]; i++) {
        if (strncmp(run->hidden[i], "/usr/", 5) == 0 && stat(run->hidden[i], &state) == 0 && S_ISDIR(state.st_mode))
            words_add_each(words, (const char *const[]){"--tmpfs", run->hidden[i], NULL});
    }
    for (int i = 0; i < MOST_VISIBLE && run->visible[i]; i++)
        bind_path(words, "--ro-bind-try", run->visible[i], run->visible[i]);
    if (run->writable)
        bind_path(words, "--bind", run->writable, run->writable);
}

// No session of its own in there: it is in none with a terminal already, and what stays in its group ends with that.
bool sandbox_bubblewrap(const SandboxRun *run, Launch *launch, Error *error)
{
    static const char *const fixed[] = {"--unshare-all",     "--unshare-user", "--as-pid-1",
                                        "--die-with-parent", "--cap-drop",     "ALL",
                                        "--hostname",        "sandbox",        NULL};
    static const char *const user[] = {"--uid", NOBODYS, "--gid", NOBODYS, NULL};
    static const char *const made[] = {"--proc", "/proc", "--dev", "/dev", "--tmpfs", "/tmp", NULL};
    // The filter is where sandbox_child.c puts it.
    static const char *const last[] = {"--chdir", "/tmp", "--seccomp", "4", "--", NULL};
    char *program = sandbox_find_program("bwrap");
    if (!program)
        return error_set(error, "bubblewrap is not installed");
    Words *words = &launch->arguments;
    words_add(words, "%s", program);
    free(program);
    words_add_each(words, fixed);
    words_add_each(words, user);
    show_system(words);
    words_add_each(words, made);
    show_files(words, run);
    words_add_each(words, last);
    words_add_each(words, run->arguments);
    return true;
}
