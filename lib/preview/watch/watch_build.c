#define _GNU_SOURCE // environ
#include "preview/watch/watch_build.h"
#include "base/parallel.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define LONGEST 60.0 // s; what the compiler is given

extern char **environ;

// The environment with LC_ALL=C: messages are looked through for English words.
static char **english_environment(void)
{
    size_t count = 0, kept = 0;
    while (environ[count])
        count++;
    char **copy = calloc(count + 2, sizeof *copy);
    if (!copy)
        return NULL;
    for (size_t i = 0; i < count; i++)
        if (strncmp(environ[i], "LC_ALL=", 7) != 0)
            copy[kept++] = environ[i];
    copy[kept] = "LC_ALL=C";
    return copy;
}

static int spawn_shell(Build *build, int output, const char *command, const char *source, const char *object)
{
    char *const arguments[] = {"sh", "-c", (char *)command, "sh", (char *)source, (char *)object, NULL};
    char **environment = english_environment();
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDERR_FILENO);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    int failed =
        posix_spawn(&build->pid, "/bin/sh", &actions, &attributes, arguments, environment ? environment : environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    free(environment);
    return failed;
}

static void make_folder_of(const char *object)
{
    char folder[4096];
    snprintf(folder, sizeof folder, "%s", object);
    for (char *slash = folder + 1; (slash = strchr(slash, '/')); *slash++ = '/') {
        *slash = '\0';
        mkdir(folder, 0777);
    }
}

bool build_start(Build *build, const char *command, const char *source, const char *object, Error *error)
{
    int ends[2];
    make_folder_of(object);
    if (pipe(ends) != 0)
        return error_set(error, "no pipe for the compiler: %s", strerror(errno));
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    int failed = spawn_shell(build, ends[1], command, source, object);
    close(ends[1]);
    if (failed) {
        close(ends[0]);
        build->pid = 0;
        return error_set(error, "cannot start the compiler: %s", strerror(failed));
    }
    build->output = ends[0];
    build->started = clock_seconds();
    build->size = 0;
    build->text[0] = '\0';
    return true;
}

static void close_output(Build *build)
{
    if (build->output >= 0)
        close(build->output);
    build->output = -1;
}

void build_stop(Build *build)
{
    if (build->pid <= 0)
        return;
    kill(-build->pid, SIGKILL);
    while (waitpid(build->pid, NULL, 0) < 0 && errno == EINTR) {
    }
    build->pid = 0;
    close_output(build);
}

// The first part is kept; the first error counts.
static void drain(Build *build)
{
    char bytes[4096];
    while (build->output >= 0) {
        ssize_t got = read(build->output, bytes, sizeof bytes);
        if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR))
            return;
        if (got <= 0) {
            close_output(build);
            return;
        }
        size_t left = sizeof build->text - 1 - build->size;
        size_t kept = (size_t)got < left ? (size_t)got : left;
        memcpy(build->text + build->size, bytes, kept);
        build->size += kept;
        build->text[build->size] = '\0';
    }
}

bool build_poll(Build *build, bool *ok)
{
    if (build->pid <= 0)
        return false;
    int status = 0;
    drain(build);
    if (clock_seconds() - build->started > LONGEST) {
        build_stop(build);
        build->size = (size_t)snprintf(build->text, sizeof build->text,
                                       "error: the compiler did not end within %.0f s\n", LONGEST);
        *ok = false;
        return true;
    }
    if (waitpid(build->pid, &status, WNOHANG) != build->pid)
        return false;
    drain(build);
    close_output(build);
    build->pid = 0;
    *ok = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return true;
}

static bool has_word(const char *line, size_t length, const char *word)
{
    const char *found = strstr(line, word);
    return found && found + strlen(word) <= line + length;
}

// The first line with a word that tells, or the last line of all. A name that is not known makes gcc warn, and only
// then find errors in what it takes the name for.
static const char *find_line(const char *text)
{
    static const char *const words[] = {"implicit declaration", "error", "undefined reference", "ld: ", "not found",
                                        "No such file"};
    for (size_t w = 0; w < sizeof words / sizeof *words; w++)
        for (const char *line = text; *line; line += strcspn(line, "\n") + (line[strcspn(line, "\n")] == '\n'))
            if (has_word(line, strcspn(line, "\n"), words[w]))
                return line;
    const char *last = text;
    for (const char *line = text; *line; line += strcspn(line, "\n") + (line[strcspn(line, "\n")] == '\n'))
        last = *line != '\n' ? line : last;
    return last;
}

static void describe_line(const char *found, const char *file, char *line, size_t size)
{
    size_t length = strcspn(found, "\n"), path = strcspn(found, ":\n");
    const char *name = found;
    for (size_t i = 0; i < path; i++)
        name = found[i] == '/' ? found + i + 1 : name;
    size_t name_length = (size_t)(found + path - name);
    bool is_source =
        name_length > 2 && (strncmp(found + path - 2, ".c", 2) == 0 || strncmp(found + path - 2, ".h", 2) == 0);
    int rest = (int)(found + length - name);
    if (length == 0)
        snprintf(line, size, "%s: the compiler failed and said nothing", file);
    else if (is_source)
        snprintf(line, size, "%.*s", rest, name);
    else
        snprintf(line, size, "%s: %.*s", file, rest, name);
}

void build_error_line(const Build *build, const char *file, char *line, size_t size)
{
    describe_line(find_line(build->text), file, line, size);
}

bool build_warning_line(const Build *build, const char *file, char *line, size_t size)
{
    const char *warning = strstr(build->text, "warning:");
    if (!warning)
        return false;
    while (warning > build->text && warning[-1] != '\n')
        warning--;
    describe_line(warning, file, line, size);
    return true;
}
