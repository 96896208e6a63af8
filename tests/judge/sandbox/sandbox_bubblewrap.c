// bwrap's arguments: namespaces of its own, and a file system that holds the system's programs and what is visible.
#include "judge/sandbox/sandbox_parts.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// A user and group that nobody has.
#define NOBODYS 60600

// /lib and the like are links into /usr on most systems, directories on some.
static void show_system(Words *words)
{
    static const char *const names[] = {"/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32"};
    words_add(words, "--ro-bind");
    words_add(words, "/usr");
    words_add(words, "/usr");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char target[4096];
        ssize_t length = readlink(names[i], target, sizeof target - 1);
        if (length > 0) {
            target[length] = '\0';
            words_add(words, "--symlink");
            words_add(words, "%s", target);
            words_add(words, "%s", names[i]);
        } else {
            words_add(words, "--ro-bind-try");
            words_add(words, "%s", names[i]);
            words_add(words, "%s", names[i]);
        }
    }
}

static void bind_path(Words *words, const char *how, const char *path)
{
    words_add(words, "%s", how);
    words_add(words, "%s", path);
    words_add(words, "%s", path);
}

static void show_files(Words *words, const SandboxRun *run)
{
    static const char *const settings[] = {"/etc/ld.so.cache", "/etc/ld.so.conf", "/etc/ld.so.conf.d",
                                           "/etc/alternatives"};
    for (size_t i = 0; i < sizeof settings / sizeof *settings; i++)
        bind_path(words, "--ro-bind-try", settings[i]);
    // A checkout may lie below /usr, or what is hidden within what is shown.
    struct stat state;
    for (int i = 0; i < MOST_HIDDEN && run->hidden[i]; i++) {
        if (strncmp(run->hidden[i], "/usr/", 5) == 0 && stat(run->hidden[i], &state) == 0 && S_ISDIR(state.st_mode)) {
            words_add(words, "--tmpfs");
            words_add(words, "%s", run->hidden[i]);
        }
    }
    for (int i = 0; i < MOST_VISIBLE && run->visible[i]; i++)
        bind_path(words, "--ro-bind-try", run->visible[i]);
    if (run->writable)
        bind_path(words, "--bind", run->writable);
}

// No session of its own in there: it is in none with a terminal already, and what stays in its group ends with that.
bool sandbox_bubblewrap(const SandboxRun *run, Launch *launch, Error *error)
{
    static const char *const fixed[] = {"--unshare-all",     "--unshare-user", "--as-pid-1",
                                        "--die-with-parent", "--cap-drop",     "ALL",
                                        "--hostname",        "sandbox"};
    char *program = sandbox_find_program("bwrap");
    if (!program)
        return error_set(error, "bubblewrap is not installed");
    Words *words = &launch->arguments;
    words_add(words, "%s", program);
    free(program);
    for (size_t i = 0; i < sizeof fixed / sizeof *fixed; i++)
        words_add(words, "%s", fixed[i]);
    words_add(words, "--uid");
    words_add(words, "%d", NOBODYS);
    words_add(words, "--gid");
    words_add(words, "%d", NOBODYS);
    show_system(words);
    const char *const made[] = {"--proc", "/proc", "--dev", "/dev", "--tmpfs", "/tmp"};
    for (size_t i = 0; i < sizeof made / sizeof *made; i++)
        words_add(words, "%s", made[i]);
    show_files(words, run);
    words_add(words, "--chdir");
    words_add(words, "/tmp");
    words_add(words, "--seccomp");
    words_add(words, "4"); // where sandbox.c puts it
    words_add(words, "--");
    for (const char *const *word = run->arguments; *word; word++)
        words_add(words, "%s", *word);
    return true;
}
