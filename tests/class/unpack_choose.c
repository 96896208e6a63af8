// Which of the C files found are the submission: people hand in exercises/, its parent, one stage, loose files, or all
// of the framework with old copies in it.
#include "file.h"
#include "steps/steps.h"
#include "unpack.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

// Where a file lies: ROOT/<stage's folder>/name, or ROOT/name.
typedef struct {
    char root[1024];
    const char *stage; // its folder's name, in step_table; NULL: loose
    size_t stage_length;
    const StepInfo *step; // NULL: a header, say
    const char *name;
} Place;

static Place place_of(const char *path)
{
    Place place = {"", NULL, 0, NULL, strrchr(path, '/') ? strrchr(path, '/') + 1 : path};
    size_t above = place.name > path ? (size_t)(place.name - path - 1) : 0;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        const char *file = step_table[i].file, *slash = strchr(file, '/');
        size_t length = strlen(slash + 1), folder = (size_t)(slash - file);
        if (strncmp(place.name, slash + 1, length) == 0 && strcmp(place.name + length, ".c") == 0)
            place.step = &step_table[i];
        bool staged = above >= folder && strncmp(path + above - folder, file, folder) == 0 &&
                      (above == folder || path[above - folder - 1] == '/');
        if (staged) {
            place.stage = file;
            place.stage_length = folder;
        }
    }
    if (place.stage)
        above = above > place.stage_length ? above - place.stage_length - 1 : 0;
    snprintf(place.root, sizeof place.root, "%.*s", (int)above, path);
    return place;
}

static bool has_part(const char *path, const char *part)
{
    size_t length = strlen(part);
    for (const char *at = path; at; at = strchr(at, '/') ? strchr(at, '/') + 1 : NULL)
        if (strncmp(at, part, length) == 0 && (at[length] == '/' || at[length] == '\0'))
            return true;
    return false;
}

// Higher is likelier what is meant. A folder called exercises wins, the framework's own copies lose, then the
// shallower.
static int rank_of(const char *root)
{
    const char *last = strrchr(root, '/') ? strrchr(root, '/') + 1 : root;
    int rank = strcmp(last, "exercises") == 0 ? 1000 : 500;
    static const char *const foreign[] = {"solutions", "tests", "prebuilt", "build", "lib"};
    for (size_t i = 0; i < sizeof foreign / sizeof *foreign; i++)
        rank -= has_part(root, foreign[i]) ? 200 : 0;
    for (; *root; root++)
        rank -= *root == '/';
    return rank;
}

static bool choose_root(const Found *found, char *root, size_t size, Error *error)
{
    int best = -10000;
    char rival[1024] = "";
    for (size_t i = 0; i < found->count; i++) {
        Place place = place_of(found->files[i].path);
        if (!place.step)
            continue;
        int rank = rank_of(place.root);
        if (rank > best) {
            best = rank;
            snprintf(root, size, "%s", place.root);
            *rival = '\0';
        } else if (rank == best && strcmp(root, place.root) != 0) {
            snprintf(rival, sizeof rival, "%s", place.root);
        }
    }
    if (best == -10000)
        return error_set(error, "no step's file is in it (names like 1.1_reflect.c)");
    if (*rival)
        return error_set(error, "steps lie both in `%s` and in `%s`; which ones count?", root, rival);
    return true;
}

static bool write_file(const char *to, const char *folder, size_t length, const FoundFile *file, const char *name,
                       Error *error)
{
    char path[4096];
    FileWriter writer;
    snprintf(path, sizeof path, "%.3000s/%.*s", to, (int)length, folder);
    if (mkdir(path, 0755) != 0 && errno != EEXIST)
        return error_set(error, "%s: %s", path, strerror(errno));
    snprintf(path, sizeof path, "%.3000s/%.*s/%.900s", to, (int)length, folder, name);
    if (!file_write_begin(&writer, path, error))
        return false;
    fwrite(file->bytes, 1, file->size, writer.stream);
    return file_write_end(&writer, true, error);
}

// A loose header is looked for beside a loose step, and that step is going to lie in its stage's folder.
static bool write_header(const char *to, const Place *place, const FoundFile *file, Error *error)
{
    if (place->stage)
        return write_file(to, place->stage, place->stage_length, file, place->name, error);
    bool ok = write_file(to, ".", 1, file, place->name, error);
    for (size_t i = 0; i < STEP_COUNT && ok; i++)
        ok = write_file(to, step_table[i].file, strcspn(step_table[i].file, "/"), file, place->name, error);
    return ok;
}

static void add_note(char *note, size_t size, const char *what, const char *name)
{
    size_t used = strlen(note);
    if (used + 200 < size)
        snprintf(note + used, size - used, "%s%s: %.100s", used ? "; " : "", what, name);
}

static bool take(const Found *found, size_t i, const char *to, char taken[STEP_COUNT], char *note, size_t size,
                 Error *error)
{
    const FoundFile *file = &found->files[i];
    Place place = place_of(file->path);
    bool is_code = place.name[strlen(place.name) - 1] == 'c';
    if (file->broken) {
        add_note(note, size, "not taken, as it is a link, unreadable or too large", place.name);
        return true;
    }
    if (!place.step) {
        if (is_code && place.name[0] >= '0' && place.name[0] <= '9')
            add_note(note, size, "not a step's name", place.name);
        return write_header(to, &place, file, error);
    }
    char *how = &taken[place.step - step_table];
    if (*how == 's' && !place.stage)
        return true; // the copy in its stage's folder counts
    *how = place.stage ? 's' : 'l';
    return write_file(to, place.step->file, strcspn(place.step->file, "/"), file, place.name, error);
}

int choose_and_write(const Found *found, const char *to, char *note, size_t size, Error *error)
{
    char root[1024] = "", taken[STEP_COUNT] = "";
    if (found->entries == 0)
        return error_set(error, "the folder is empty"), -1;
    if (!choose_root(found, root, sizeof root, error))
        return -1;
    for (size_t i = 0; i < found->count; i++)
        if (strcmp(place_of(found->files[i].path).root, root) == 0 && !take(found, i, to, taken, note, size, error))
            return -1;
    int written = 0;
    for (size_t i = 0; i < STEP_COUNT; i++)
        written += taken[i] != 0;
    if (written == 0)
        return error_set(error, "no step's file in it can be read"), -1;
    return written;
}
