// The chosen steps, and the headers that they may include, to the disk.
#include "base/file.h"
#include "class/unpack/unpack.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

static bool write_file(const char *to, const char *folder, int length, const FoundFile *file, const char *name,
                       Error *error)
{
    char path[4096];
    FileWriter writer;
    snprintf(path, sizeof path, "%.3000s/%.*s", to, length, folder);
    if (mkdir(path, 0755) != 0 && errno != EEXIST)
        return error_set(error, "%s: %s", path, strerror(errno));
    snprintf(path, sizeof path, "%.3000s/%.*s/%.900s", to, length, folder, name);
    if (!file_write_begin(&writer, path, error))
        return false;
    fwrite(file->bytes, 1, file->size, writer.stream);
    return file_write_end(&writer, true, error);
}

static bool is_header(const FoundFile *file, const Place *place)
{
    size_t length = strlen(place->name);
    return !file->broken && length > 2 && strcasecmp(place->name + length - 2, ".h") == 0;
}

// In the same folder as a chosen step, or in the one above that holds the stages?
static bool is_near(const FoundFile *file, const Place *place, const Chosen *chosen)
{
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (!chosen->of[i])
            continue;
        const char *path = chosen->of[i]->path;
        Place step = place_of(path);
        if (step.root == place->root && strncmp(path, file->path, (size_t)step.root) == 0)
            return true;
    }
    return false;
}

static bool is_same_place(const Place *a, const Place *b)
{
    return a->stage_length == b->stage_length &&
           (!a->stage || strncmp(a->stage, b->stage, (size_t)a->stage_length) == 0) && strcmp(a->name, b->name) == 0;
}

// Headers of one name that would go to one place, with different words.
static bool is_unsure(const Found *found, const Chosen *chosen, size_t header, const Place *place, Error *error)
{
    for (size_t i = 0; i < header; i++) {
        Place other = place_of(found->files[i].path);
        if (is_header(&found->files[i], &other) && is_same_place(place, &other) &&
            is_near(&found->files[i], &other, chosen) && !same_words(&found->files[i], &found->files[header])) {
            error_set(error, "%.100s lies both in `%.300s` and in `%.300s`; which one counts?", place->name,
                      found->files[i].path, found->files[header].path);
            return true;
        }
    }
    return false;
}

// A loose header is looked for beside a loose step, and that step is going to lie in its stage's folder. One that lies in
// a stage's folder itself comes later, and wins.
static bool write_loose(const char *to, const FoundFile *file, const char *name, Error *error)
{
    bool ok = write_file(to, ".", 1, file, name, error);
    for (size_t i = 0; i < STEP_COUNT && ok; i++)
        ok = write_file(to, step_table[i].file, (int)strcspn(step_table[i].file, "/"), file, name, error);
    return ok;
}

int write_chosen(const Found *found, const Chosen *chosen, const char *to, Error *error)
{
    int count = 0;
    for (int staged = 0; staged <= 1; staged++)
        for (size_t i = 0; i < found->count; i++) {
            const FoundFile *file = &found->files[i];
            Place place = place_of(file->path);
            if (!is_header(file, &place) || (place.stage != NULL) != staged || !is_near(file, &place, chosen))
                continue;
            if (is_unsure(found, chosen, i, &place, error))
                return -2;
            bool ok = staged ? write_file(to, place.stage, place.stage_length, file, place.name, error)
                             : write_loose(to, file, place.name, error);
            if (!ok)
                return -1;
        }
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (!chosen->of[i])
            continue;
        const char *path = step_table[i].file, *slash = strchr(path, '/');
        char name[256];
        snprintf(name, sizeof name, "%s.c", slash + 1);
        if (!write_file(to, path, (int)(slash - path), chosen->of[i], name, error))
            return -1;
        count++;
    }
    return count;
}
