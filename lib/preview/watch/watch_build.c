// Building what was saved, and the line of what the compiler says that tells most.
#include "preview/watch/watch_internal.h"
#include "base/file.h"
#include "base/parallel.h"
#include "math/rng.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define LONGEST    60.0       // s; what the compiler is given
#define MOST_BYTES (1u << 20) // of what it writes about one object

// "1.3_scatter_diffuse"
static const char *name_of(size_t i)
{
    return strrchr(step_table[i].file, '/') + 1;
}

// The next path of a make rule: parted by blanks, with a backslash before a blank that belongs to it. NULL: no more.
static char *next_path(char **text)
{
    char *from = *text;
    while (*from == ' ' || *from == '\n' || (*from == '\\' && from[1] == '\n'))
        from++;
    char *path = from, *to = from;
    while (*from && *from != ' ' && *from != '\n') {
        from += *from == '\\' && from[1] == ' ';
        *to++ = *from++;
    }
    *text = from + (*from != '\0');
    *to = '\0';
    return path < to ? path : NULL;
}

static bool is_own_header(const Watch *watch, const char *path)
{
    size_t folder = strlen(watch->source), length = strlen(path);
    return length > folder + 2 && strncmp(path, watch->source, folder) == 0 && path[folder] == '/' &&
           strcmp(path + length - 2, ".h") == 0;
}

uint64_t watch_headers(const Watch *watch, size_t i)
{
    char rules[4096];
    size_t size;
    watch_path(rules, watch->objects, i, ".d");
    char *text = file_read(rules, MOST_BYTES, &size, NULL), *rest = text;
    uint64_t sum = 0;
    for (char *path; text && (path = next_path(&rest));)
        if (is_own_header(watch, path))
            sum = watch_fingerprint(hash_u64(sum + 1), path);
    free(text);
    return sum;
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

static const char *line_of(const char *text, const char *at)
{
    while (at > text && at[-1] != '\n')
        at--;
    return at;
}

// The first; NULL: no line has this word.
static const char *line_with(const char *text, const char *word)
{
    const char *found = strstr(text, word);
    return found ? line_of(text, found) : NULL;
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
    return line_of(text, found);
}

static void describe_line(const char *found, const char *file, char *line, size_t size)
{
    const char *end = found + strcspn(found, "\n"), *path_end = found + strcspn(found, ":\n"), *name = path_end;
    while (name > found && name[-1] != '/')
        name--;
    bool is_source =
        path_end - name > 2 && (strncmp(path_end - 2, ".c", 2) == 0 || strncmp(path_end - 2, ".h", 2) == 0);
    if (found == end)
        snprintf(line, size, "%s: the compiler failed and said nothing", file);
    else
        snprintf(line, size, "%s%s%.*s", is_source ? "" : file, is_source ? "" : ": ", (int)(end - name), name);
}

WatchEvent watch_begin_build(Watch *watch, size_t i)
{
    char source[4096], object[4096];
    watch_path(source, watch->source, i, ".c");
    watch_path(object, watch->objects, i, ".so");
    watch->files[i].dirty = false;
    watch->files[i].error[0] = '\0';
    watch_look_at(watch, i); // what is built, even if it was seen half-written before
    if (access(source, F_OK) != 0) {
        if (unlink(object) != 0 && errno == ENOENT)
            return WATCH_NOTHING;
        snprintf(watch->message, sizeof watch->message, "%s.c: deleted; the reference plays in its place", name_of(i));
        return WATCH_BUILT;
    }
    watch->building = i;
    make_folder_of(object);
    if (job_start(&watch->compiler, watch->command, source, object))
        return WATCH_BUILDING;
    snprintf(watch->message, sizeof watch->message, "%s.c: cannot start the compiler: %s", name_of(i), strerror(errno));
    return WATCH_FAILED;
}

WatchEvent watch_end_build(Watch *watch)
{
    char name[256];
    int status;
    Job *compiler = &watch->compiler;
    Source *file = &watch->files[watch->building];
    if (!job_poll(compiler, LONGEST, &status))
        return WATCH_NOTHING;
    snprintf(name, sizeof name, "%s.c", name_of(watch->building));
    watch->warning[0] = '\0';
    file->headers = watch_headers(watch, watch->building); // it may read others now
    if (status == 0) {
        const char *warning = line_with(compiler->text, "warning:");
        snprintf(watch->message, sizeof watch->message, "%s: built in %.2f s", name,
                 clock_seconds() - compiler->started);
        if (warning)
            describe_line(warning, name, watch->warning, sizeof watch->warning);
        return WATCH_BUILT;
    }
    if (status == -1)
        snprintf(compiler->text, sizeof compiler->text, "error: the compiler did not end within %.0f s\n", LONGEST);
    describe_line(find_line(compiler->text), name, watch->message, sizeof watch->message);
    snprintf(file->error, sizeof file->error, "%.299s", watch->message);
    return WATCH_FAILED;
}
