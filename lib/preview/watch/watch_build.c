#include "preview/watch/watch_build.h"
#include "base/parallel.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>

#define LONGEST 60.0 // s; what the compiler is given

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
    const char *const arguments[] = {"/bin/sh", "-c", command, "sh", source, object, NULL};
    make_folder_of(object);
    build->started = clock_seconds();
    build->size = 0;
    build->text[0] = '\0';
    return process_start(&build->compiler, arguments, PRINTS_ALL) ||
           error_set(error, "cannot start the compiler: %s", strerror(errno));
}

bool build_poll(Build *build, bool *ok)
{
    int status = 0;
    // The first part is kept; the first error counts.
    process_read(&build->compiler, build->text, sizeof build->text, &build->size);
    if (clock_seconds() - build->started > LONGEST) {
        process_kill(&build->compiler);
        build->size = (size_t)snprintf(build->text, sizeof build->text,
                                       "error: the compiler did not end within %.0f s\n", LONGEST);
        *ok = false;
        return true;
    }
    if (!process_has_ended(&build->compiler, &status))
        return false;
    process_read(&build->compiler, build->text, sizeof build->text, &build->size);
    process_kill(&build->compiler); // what it left running may hold the pipe
    *ok = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return true;
}

// NULL: no line has this word.
static const char *line_with(const char *text, const char *word)
{
    const char *line = strstr(text, word);
    while (line && line > text && line[-1] != '\n')
        line--;
    return line;
}

// The first line with a word that tells, or the last line of all. A name that is not known makes gcc warn, and only
// then find errors in what it takes the name for.
static const char *find_line(const char *text)
{
    static const char *const words[] = {"implicit declaration", "error", "undefined reference", "ld: ", "not found",
                                        "No such file"};
    const char *found = NULL;
    for (size_t w = 0; w < sizeof words / sizeof *words && !found; w++)
        found = line_with(text, words[w]);
    if (found)
        return found;
    found = text + strlen(text);
    while (found > text && found[-1] == '\n')
        found--;
    while (found > text && found[-1] != '\n')
        found--;
    return found;
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
    const char *warning = line_with(build->text, "warning:");
    if (warning)
        describe_line(warning, file, line, size);
    return warning;
}
