// The C files below a directory. Links are never followed.
#include "class/unpack/unpack.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool read_file(int directory, const char *name, const char *path, Found *found, Error *error)
{
    // O_NONBLOCK: a pipe must not hold the class up.
    int file = openat(directory, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    struct stat state;
    const char *broken = NULL;
    if (file < 0 || fstat(file, &state) != 0)
        broken = "cannot be read";
    else if (!S_ISREG(state.st_mode))
        broken = "is no file";
    else if (state.st_size > (off_t)MOST_FILE)
        broken = "is larger than 1 MB";
    if (broken) {
        if (file >= 0)
            close(file);
        return found_add(found, path, NULL, 0, broken, error);
    }
    size_t size = 0, room = (size_t)state.st_size;
    char *bytes = malloc(room + 1);
    ssize_t got;
    while (bytes && size < room && (got = read(file, bytes + size, room - size)) > 0)
        size += (size_t)got;
    close(file);
    return bytes ? found_add(found, path, bytes, size, NULL, error) : error_set(error, "no memory to read it");
}

static bool walk(int directory, const char *path, int depth, Found *found, Error *error);

static bool visit(int directory, const char *name, const char *above, int depth, Found *found, Error *error)
{
    char path[2048];
    struct stat state;
    if (name[0] == '.' || strcmp(name, "__MACOSX") == 0)
        return true;
    if (!found_count(found, error))
        return false;
    if (snprintf(path, sizeof path, "%s%s%s", above, *above ? "/" : "", name) >= (int)sizeof path ||
        fstatat(directory, name, &state, AT_SYMLINK_NOFOLLOW) != 0)
        return true;
    if (S_ISDIR(state.st_mode)) {
        int inside = depth < MOST_DEPTH ? openat(directory, name, O_RDONLY | O_NOFOLLOW | O_DIRECTORY | O_CLOEXEC) : -1;
        return inside < 0 || walk(inside, path, depth + 1, found, error);
    }
    if (S_ISLNK(state.st_mode)) // one without an ending may lead to a folder
        return (!found_wants(path) && strchr(name, '.')) || found_add(found, path, NULL, 0, "is a link", error);
    if (S_ISREG(state.st_mode) && found_is_archive(name) && strlen(path) < sizeof found->archive) {
        snprintf(found->archive, sizeof found->archive, "%.1023s", path);
        found->archives++;
    }
    return !found_wants(path) || read_file(directory, name, path, found, error);
}

// Closes `directory`.
static bool walk(int directory, const char *path, int depth, Found *found, Error *error)
{
    DIR *stream = fdopendir(directory);
    if (!stream) {
        close(directory);
        return true;
    }
    bool ok = true;
    for (struct dirent *entry; ok && (entry = readdir(stream));)
        ok = visit(directory, entry->d_name, path, depth, found, error);
    closedir(stream);
    return ok;
}

bool directory_find(const char *path, Found *found, Error *error)
{
    int directory = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (directory < 0)
        return error_set(error, "the folder cannot be read");
    return walk(directory, "", 0, found, error);
}
