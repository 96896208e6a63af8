#define _GNU_SOURCE // O_DIRECTORY, O_NOFOLLOW, O_PATH
#include "judge/sandbox/sandbox_folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define MOST_DEPTH 16

bool folder_open(char *folder, size_t size, gid_t group, Error *error)
{
    const char *temporary = getenv("TMPDIR");
    bool usable = temporary && temporary[0] == '/' && strlen(temporary) + 24 < size;
    snprintf(folder, size, "%s/photonlab-XXXXXX", usable ? temporary : "/tmp");
    if (!mkdtemp(folder) || chown(folder, 0, group) != 0 || chmod(folder, 0750) != 0) {
        error_set(error, "%s: %s", folder, strerror(errno));
        folder[0] = '\0';
        return false;
    }
    return true;
}

static bool copy_bytes(int from, int to)
{
    char bytes[1 << 14];
    long copied = 0;
    for (ssize_t got; (got = read(from, bytes, sizeof bytes)) != 0; copied += got)
        if (got < 0 || copied > FOLDER_MOST_BYTES || write(to, bytes, (size_t)got) != got)
            return false;
    return true;
}

// Opened without waiting, so that a pipe in a file's place cannot hold the judge up.
static int open_plain(int directory, const char *name, struct stat *state)
{
    int fd = openat(directory, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (fd >= 0 && fstat(fd, state) == 0 && S_ISREG(state->st_mode) && state->st_size <= FOLDER_MOST_BYTES)
        return fd;
    if (fd >= 0)
        close(fd);
    return -1;
}

// A file that others may read, and only root may write, needs no copy: a second name for it will do, where the folder lies in
// the same file system. Thousands of files a minute, made and deleted, are slow on ext4.
static bool link_file(const struct stat *state, int from_directory, const char *name, int to_directory,
                      const char *to_name)
{
    bool can_run = !(state->st_mode & S_IXUSR) || (state->st_mode & S_IXOTH);
    return state->st_uid == 0 && (state->st_mode & S_IROTH) && !(state->st_mode & (S_IWGRP | S_IWOTH)) && can_run &&
           linkat(from_directory, name, to_directory, to_name, 0) == 0;
}

static bool copy_file(int from_directory, const char *name, int to_directory, const char *to_name, uid_t writer,
                      gid_t group)
{
    struct stat state;
    int from = open_plain(from_directory, name, &state);
    if (from < 0)
        return true; // no plain file: left out
    unlinkat(to_directory, to_name, 0);
    if (!writer && group && link_file(&state, from_directory, name, to_directory, to_name)) {
        close(from);
        return true;
    }
    int to = openat(to_directory, to_name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    bool ok = to >= 0 && copy_bytes(from, to);
    if (ok && (writer || group)) {
        mode_t run = state.st_mode & S_IXUSR ? 0110 : 0;
        ok = fchown(to, writer, group) == 0 && fchmod(to, (writer ? 0640 : 0440) | run) == 0;
    } else if (ok) {
        ok = fchmod(to, state.st_mode & 0777) == 0;
    }
    close(from);
    if (to >= 0)
        ok = close(to) == 0 && ok;
    return ok;
}

static int enter(int directory, const char *name)
{
    return openat(directory, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

static bool make_directory(int parent, const char *name, uid_t owner, gid_t group)
{
    if (mkdirat(parent, name, 0700) != 0)
        return errno == EEXIST;
    return fchownat(parent, name, owner, group, AT_SYMLINK_NOFOLLOW) == 0 &&
           fchmodat(parent, name, owner ? 0700 : 0750, 0) == 0;
}

// Everything in the directory `from`, which it closes, as it does `to`.
static bool copy_all(int from, int to, uid_t writer, gid_t group, int depth)
{
    DIR *listing = from >= 0 ? fdopendir(from) : NULL;
    bool ok = listing && to >= 0 && depth < MOST_DEPTH;
    for (struct dirent *entry; ok && (entry = readdir(listing));) {
        struct stat state;
        const char *name = entry->d_name;
        if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0 || fstatat(from, name, &state, AT_SYMLINK_NOFOLLOW) != 0)
            continue;
        if (S_ISDIR(state.st_mode))
            ok = make_directory(to, name, writer, group) &&
                 copy_all(enter(from, name), enter(to, name), writer, group, depth + 1);
        else
            ok = copy_file(from, name, to, name, writer, group);
    }
    if (listing)
        closedir(listing);
    if (to >= 0)
        close(to);
    return ok;
}

// folder/path's directories, down to the one that holds its last name; that directory, open, or −1.
static int make_way(const char *folder, const char *path, gid_t group)
{
    char names[4096];
    snprintf(names, sizeof names, "%s", path);
    int at = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    char *name = names + strspn(names, "/");
    for (char *slash; at >= 0 && (slash = strchr(name, '/')); name = slash + 1) {
        *slash = '\0';
        int next = make_directory(at, name, 0, group) ? enter(at, name) : -1;
        close(at);
        at = next;
    }
    return at;
}

bool folder_copy(const char *folder, const char *path, uid_t writer, gid_t group, Error *error)
{
    struct stat state;
    const char *name = strrchr(path, '/') + 1;
    int parent = make_way(folder, path, group);
    bool ok = parent >= 0 && stat(path, &state) == 0;
    if (ok && S_ISDIR(state.st_mode))
        ok = make_directory(parent, name, writer, group) &&
             copy_all(open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC), enter(parent, name), writer, group, 0);
    else if (ok)
        ok = copy_file(AT_FDCWD, path, parent, name, writer, group);
    if (parent >= 0)
        close(parent);
    return ok || error_set(error, "%s: cannot be copied to %s: %s", path, folder, strerror(errno));
}

void folder_take_back(const char *folder, const char *path)
{
    char copy[4096];
    snprintf(copy, sizeof copy, "%s%s", folder, path);
    int from = open(copy, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    int to = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *listing = from >= 0 ? fdopendir(from) : NULL;
    for (struct dirent *entry; listing && to >= 0 && (entry = readdir(listing));)
        copy_file(from, entry->d_name, to, entry->d_name, 0, 0);
    if (listing)
        closedir(listing);
    if (to >= 0)
        close(to);
}

static void remove_all(int directory, int depth)
{
    DIR *listing = directory >= 0 ? fdopendir(directory) : NULL;
    for (struct dirent *entry; listing && depth < 64 && (entry = readdir(listing));) {
        const char *name = entry->d_name;
        if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0)
            continue;
        if (unlinkat(directory, name, 0) == 0)
            continue;
        remove_all(enter(directory, name), depth + 1);
        unlinkat(directory, name, AT_REMOVEDIR);
    }
    if (listing)
        closedir(listing);
}

void folder_close(const char *folder)
{
    if (!folder[0])
        return;
    remove_all(open(folder, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC), 0);
    rmdir(folder);
}

static bool all_open(int directory, int depth)
{
    DIR *listing = directory >= 0 && depth < MOST_DEPTH ? fdopendir(directory) : NULL;
    bool ok = listing != NULL;
    for (struct dirent *entry; ok && (entry = readdir(listing));) {
        struct stat state;
        const char *name = entry->d_name;
        if (strcmp(name, ".") == 0 || strcmp(name, "..") == 0 ||
            fstatat(directory, name, &state, AT_SYMLINK_NOFOLLOW) != 0)
            continue;
        if (S_ISDIR(state.st_mode))
            ok = (state.st_mode & 05) == 05 && all_open(enter(directory, name), depth + 1);
        else if (S_ISREG(state.st_mode))
            ok = (state.st_mode & 04) != 0;
    }
    if (listing)
        closedir(listing);
    return ok;
}

bool folder_is_open(const char *path)
{
    char part[4096];
    struct stat state;
    for (const char *slash = strchr(path + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        snprintf(part, sizeof part, "%.*s", (int)(slash - path), path);
        if (stat(part, &state) == 0 && !(state.st_mode & 01))
            return false;
    }
    if (stat(path, &state) != 0)
        return true;
    if (!S_ISDIR(state.st_mode))
        return (state.st_mode & 04) != 0;
    return (state.st_mode & 05) == 05 && all_open(open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC), 0);
}
