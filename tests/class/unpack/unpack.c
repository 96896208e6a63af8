// class_unpack FROM TO: the steps that lie in a submission (a directory, or a .tar.gz, .tgz, .tar.xz, .tar.bz2, .tar or
// .zip), laid out like exercises/. Prints what was left out. Exit 1 with one sentence when there is nothing to grade, 3
// when two files of one step are equally good.
#include "class/unpack/unpack.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/resource.h>
#include <sys/stat.h>

// NULL is the last ending.
static bool ends_in(const char *name, const char *const *endings)
{
    size_t length = strlen(name);
    while (*endings && !(length > strlen(*endings) && strcasecmp(name + length - strlen(*endings), *endings) == 0))
        endings++;
    return *endings != NULL;
}

bool found_is_archive(const char *name)
{
    static const char *const endings[] = {".tar.gz", ".tgz", ".tar.xz", ".txz", ".tar.bz2", ".tar", ".zip", NULL};
    return ends_in(name, endings);
}

bool found_wants(const char *path)
{
    static const char *const endings[] = {".c", ".h", ".inl", ".cc", ".cpp", ".cxx", ".c.txt", NULL};
    if (!ends_in(path, endings) || strlen(path) > 1000)
        return false;
    int depth = 0;
    for (const char *part = path; part; part = strchr(part, '/') ? strchr(part, '/') + 1 : NULL) {
        depth++;
        if (*part == '.' || *part == '/' || strncmp(part, "__MACOSX/", 9) == 0)
            return false;
    }
    return depth <= MOST_DEPTH;
}

bool found_count(Found *found, Error *error)
{
    if (++found->entries > MOST_ENTRIES)
        return error_set(error, "it holds more than %u files", MOST_ENTRIES);
    return true;
}

bool found_add(Found *found, const char *path, char *bytes, size_t size, const char *broken, Error *error)
{
    FoundFile *files = realloc(found->files, (found->count + 1) * sizeof *files);
    char *name = strdup(path);
    found->kept += bytes ? size : 0;
    if (files)
        found->files = files;
    if (!files || !name || found->kept > MOST_KEPT) {
        free(name);
        free(bytes);
        return error_set(error, "its C files have more than %u MB in all", MOST_KEPT >> 20);
    }
    files[found->count++] = (FoundFile){name, bytes, size, broken};
    return true;
}

static void found_free(Found *found)
{
    for (size_t i = 0; i < found->count; i++) {
        free(found->files[i].path);
        free(found->files[i].bytes);
    }
    free(found->files);
}

// A folder with nothing but an archive in it is what some course systems make of one.
static bool find(const char *from, Found *found, Error *error)
{
    struct stat state;
    if (stat(from, &state) != 0)
        return error_set(error, "it cannot be read");
    if (!S_ISDIR(state.st_mode) && !found_is_archive(from) &&
        found_wants(strrchr(from, '/') ? strrchr(from, '/') + 1 : from))
        return error_set(error, "a file alone, called neither after a student and a step (doe_1.1_reflect.c) nor in a "
                                "student's folder");
    if (!S_ISDIR(state.st_mode))
        return archive_find(from, found, error);
    if (!directory_find(from, found, error))
        return false;
    bool has_code = false;
    for (size_t i = 0; i < found->count; i++)
        has_code = has_code || !found->files[i].broken;
    if (has_code || found->archives == 0)
        return true;
    if (found->archives > 1)
        return error_set(error, "there are %zu archives in it; which one counts?", found->archives);
    char path[4096];
    snprintf(path, sizeof path, "%.3000s/%s", from, found->archive);
    return archive_find(path, found, error);
}

// A decompressor that is fed a bomb must not take the machine along.
static void limit_self(void)
{
    setrlimit(RLIMIT_CPU, &(struct rlimit){UNPACK_SECONDS, UNPACK_SECONDS});
    setrlimit(RLIMIT_AS, &(struct rlimit){1u << 30, 1u << 30});
    setrlimit(RLIMIT_FSIZE, &(struct rlimit){MOST_KEPT, MOST_KEPT});
    setrlimit(RLIMIT_CORE, &(struct rlimit){0, 0});
}

int main(int count, char **arguments)
{
    if (count != 3) {
        fprintf(stderr, "usage: class_unpack FROM TO\n");
        return 2;
    }
    limit_self();
    Found found = {NULL, 0, 0, 0, "", 0};
    Error error = {""};
    char note[NOTE_SIZE] = "";
    Chosen chosen = {{NULL}, {false}, false};
    int written = -1;
    if (find(arguments[1], &found, &error)) {
        written = choose_steps(&found, &chosen, &error);
        if (written != -2)
            choose_note(&found, &chosen, note, sizeof note);
    }
    if (written > 0)
        written = write_chosen(&found, &chosen, arguments[2], &error);
    found_free(&found);
    if (written < 0) {
        fprintf(stderr, "%s%s%s\n", error.message, *note ? "; " : "", note);
        return written == -2 ? 3 : 1;
    }
    if (*note)
        printf("%s\n", note);
    return 0;
}
