// class_unpack FROM TO: the steps that lie in a submission (a directory, or a .tar.gz, .tgz, .tar.xz, .tar.bz2, .tar or
// .zip), laid out like exercises/. Prints what was left out; exit 1 with one sentence when there is nothing to grade.
#include "unpack.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/resource.h>
#include <sys/stat.h>

bool found_is_archive(const char *name)
{
    static const char *const endings[] = {".tar.gz", ".tgz", ".tar.xz", ".txz", ".tar.bz2", ".tar", ".zip"};
    size_t length = strlen(name);
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        size_t ending = strlen(endings[i]);
        if (length > ending && strcasecmp(name + length - ending, endings[i]) == 0)
            return true;
    }
    return false;
}

bool found_wants(const char *path)
{
    size_t length = strlen(path);
    if (length < 3 || length > 1000 || path[length - 2] != '.' || (path[length - 1] != 'c' && path[length - 1] != 'h'))
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

bool found_add(Found *found, const char *path, char *bytes, size_t size, Error *error)
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
    files[found->count++] = (FoundFile){name, bytes, size, bytes == NULL};
    return true;
}

void found_free(Found *found)
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
    if (!S_ISDIR(state.st_mode))
        return archive_find(from, found, error);
    if (!directory_find(from, found, error))
        return false;
    if (found->count > 0 || found->archives == 0)
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
    char note[1024] = "";
    int steps = -1;
    if (find(arguments[1], &found, &error))
        steps = choose_and_write(&found, arguments[2], note, sizeof note, &error);
    found_free(&found);
    if (steps < 0) {
        fprintf(stderr, "%s\n", error.message);
        return 1;
    }
    if (*note)
        printf("%s\n", note);
    return 0;
}
