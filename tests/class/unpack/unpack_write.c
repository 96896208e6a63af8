// The chosen steps, and the files that they may include, to the disk.
#include "base/file.h"
#include "class/unpack/unpack.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

// Folders come into being on the way.
static bool write_file(const char *to, int length, const char *folder, const char *name, const FoundFile *file,
                       Error *error)
{
    char path[4096];
    FileWriter writer;
    snprintf(path, sizeof path, "%.3000s/%.*s%s%.900s", to, length, folder, length > 0 ? "/" : "", name);
    for (char *slash = path + strlen(to) + 1; (slash = strchr(slash, '/')); slash++) {
        *slash = '\0';
        if (mkdir(path, 0755) != 0 && errno != EEXIST)
            return error_set(error, "%s: %s", path, strerror(errno));
        *slash = '/';
    }
    if (!file_write_begin(&writer, path, error))
        return false;
    fwrite(file->bytes, 1, file->size, writer.stream);
    return file_write_end(&writer, true, error);
}

const char *helper_path(const FoundFile *file, const Chosen *chosen)
{
    Place place = place_of(file->path);
    bool may_be = file_ends_in(file->path, ".h") || file_ends_in(file->path, ".c") || file_ends_in(file->path, ".inl");
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (!chosen->of[i] || !may_be || file->broken || place.step || (place.foreign && !chosen->foreign_too))
            continue;
        Place step = place_of(chosen->of[i]->path);
        if (strncmp(chosen->of[i]->path, file->path, (size_t)step.root) != 0)
            continue;
        if (step.root == 0)
            return file->path;
        if (file->path[step.root] == '/')
            return file->path + step.root + 1;
    }
    return NULL;
}

// Files that would go to one place, with different words.
static bool is_unsure(const Found *found, const Chosen *chosen, size_t helper, const char *path, Error *error)
{
    for (size_t i = 0; i < helper; i++) {
        const char *other = helper_path(&found->files[i], chosen);
        if (other && strcmp(other, path) == 0 && !same_words(&found->files[i], &found->files[helper])) {
            error_set(error, "%.100s lies both in `%.300s` and in `%.300s`; which one counts?", path,
                      found->files[i].path, found->files[helper].path);
            return true;
        }
    }
    return false;
}

// A loose file is looked for beside a loose step, and that step is going to lie in its stage's folder. One that lies in
// a stage's folder itself comes later, and wins.
static bool write_loose(const char *to, const FoundFile *file, const char *path, Error *error)
{
    bool ok = write_file(to, 0, "", path, file, error);
    for (size_t i = 0; i < STEP_COUNT && ok; i++)
        ok = write_file(to, (int)strcspn(step_table[i].file, "/"), step_table[i].file, path, file, error);
    return ok;
}

// 0: all are written.
static int write_helpers(const Found *found, const Chosen *chosen, const char *to, Error *error)
{
    for (int staged = 0; staged <= 1; staged++)
        for (size_t i = 0; i < found->count; i++) {
            const FoundFile *file = &found->files[i];
            const char *path = helper_path(file, chosen);
            bool in_stage = false;
            for (size_t s = 0; path && s < STEP_COUNT; s++)
                in_stage = in_stage || strncmp(path, step_table[s].file, strcspn(step_table[s].file, "/") + 1) == 0;
            if (!path || in_stage != staged)
                continue;
            if (is_unsure(found, chosen, i, path, error))
                return -2;
            if (!(staged ? write_file(to, 0, "", path, file, error) : write_loose(to, file, path, error)))
                return -1;
        }
    return 0;
}

int write_chosen(const Found *found, const Chosen *chosen, const char *to, Error *error)
{
    int count = write_helpers(found, chosen, to, error);
    if (count < 0)
        return count;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (!chosen->of[i])
            continue;
        const char *path = step_table[i].file, *slash = strchr(path, '/');
        char name[256];
        snprintf(name, sizeof name, "%s.c", slash + 1);
        if (!write_file(to, (int)(slash - path), path, name, chosen->of[i], error))
            return -1;
        count++;
    }
    return count;
}
