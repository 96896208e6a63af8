// Which of the C files found are the submission: people hand in exercises/, its parent, one stage, loose files, or all
// of the framework, and forget an empty step beside their own.
#include "base/file.h"
#include "class/unpack/unpack.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

// Is one of the folders above the file called so?
static bool is_below(const char *path, int folder, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = path; at && at < path + folder; at = strchr(at, '/') ? strchr(at, '/') + 1 : NULL)
        if (strncmp(at, name, length) == 0 && (at[length] == '/' || name[length - 1] == '-'))
            return true;
    return false;
}

Place place_of(const char *path)
{
    Place place = {.name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path};
    place.folder = place.name > path ? (int)(place.name - path - 1) : 0;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        const char *file = step_table[i].file, *slash = strchr(file, '/');
        size_t length = strlen(slash + 1);
        int stage = (int)(slash - file), before = place.folder - stage;
        if (strncasecmp(place.name, slash + 1, length) == 0 && strcasecmp(place.name + length, ".c") == 0)
            place.step = &step_table[i];
        if (before >= 0 && strncmp(path + before, file, (size_t)stage) == 0 &&
            (before == 0 || path[before - 1] == '/')) {
            place.stage = file;
            place.stage_length = stage;
        }
    }
    place.root = place.folder;
    if (place.stage)
        place.root = place.folder > place.stage_length ? place.folder - place.stage_length - 1 : 0;
    static const char *const foreign[] = {"solutions", "tests", "prebuilt", "build", "lib", "scenes", "before-update-"};
    for (size_t i = 0; i < sizeof foreign / sizeof *foreign; i++)
        place.foreign = place.foreign || is_below(path, place.folder, foreign[i]);
    return place;
}

// Higher: likelier what is meant.
static int place_rank(const Place *place, const char *path)
{
    const int word = (int)strlen("exercises");
    int rank = place->stage ? 1 : 0;
    if (place->root >= word && strncmp(path + place->root - word, "exercises", (size_t)word) == 0)
        rank += 1000;
    for (int i = 0; i < place->root; i++)
        rank -= path[i] == '/' ? 2 : 0;
    return rank;
}

bool same_words(const FoundFile *a, const FoundFile *b)
{
    size_t i = 0, j = 0;
    for (;; i++, j++) {
        while (i < a->size && isspace((unsigned char)a->bytes[i]))
            i++;
        while (j < b->size && isspace((unsigned char)b->bytes[j]))
            j++;
        if (i == a->size || j == b->size)
            return i == a->size && j == b->size;
        if (a->bytes[i] != b->bytes[j])
            return false;
    }
}

// Skips a comment that begins at `at`; where there is none, gives `at` back.
static size_t skip_comment(const FoundFile *file, size_t at)
{
    if (at + 1 >= file->size || file->bytes[at] != '/')
        return at;
    if (file->bytes[at + 1] == '/')
        while (at < file->size && file->bytes[at] != '\n')
            at++;
    else if (file->bytes[at + 1] == '*')
        for (at += 2; at < file->size && !(file->bytes[at - 1] == '*' && file->bytes[at] == '/'); at++)
            ;
    return at;
}

// Has it code, and none that calls todo? The empty step does.
static bool is_started(const FoundFile *file)
{
    bool code = false;
    for (size_t i = 0; i < file->size; i++) {
        i = skip_comment(file, i);
        if (i + 5 <= file->size && memcmp(file->bytes + i, "todo(", 5) == 0 &&
            (i == 0 || !(isalnum((unsigned char)file->bytes[i - 1]) || file->bytes[i - 1] == '_')))
            return false;
        code = code || (i < file->size && !isspace((unsigned char)file->bytes[i]));
    }
    return code;
}

static bool choose_one(const Found *found, size_t step, Chosen *chosen, Error *error)
{
    int best = 0;
    for (size_t i = 0; i < found->count; i++) {
        const FoundFile *file = &found->files[i], *other = chosen->of[step];
        Place place = place_of(file->path);
        if (place.step != &step_table[step] || file->broken || (place.foreign && !chosen->foreign_too))
            continue;
        bool started = is_started(file);
        if (started && other && chosen->started[step] && !same_words(file, other))
            return error_set(error, "%s is started both in `%.300s` and in `%.300s`; which one counts?",
                             step_table[step].id, other->path, file->path);
        int rank = place_rank(&place, file->path);
        if (!other || started > chosen->started[step] || (started == chosen->started[step] && rank > best)) {
            chosen->of[step] = file;
            chosen->started[step] = started;
            best = rank;
        }
    }
    return true;
}

int choose_steps(const Found *found, Chosen *chosen, Error *error)
{
    int count = 0;
    if (found->entries == 0)
        return error_set(error, "the folder is empty"), -1;
    chosen->foreign_too = true;
    for (size_t i = 0; i < found->count; i++) {
        Place place = place_of(found->files[i].path);
        if (place.step && !place.foreign && !found->files[i].broken)
            chosen->foreign_too = false;
    }
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (!choose_one(found, i, chosen, error))
            return -2;
        count += chosen->of[i] != NULL;
    }
    return count > 0 ? count
                     : (error_set(error, "no step's file that can be read is in it (names like 1.1_reflect.c)"), -1);
}

// ---- what is left out

typedef struct {
    char *text;
    size_t size, more;
} Note;

static void add_note(Note *note, const char *path, const char *why)
{
    size_t used = strlen(note->text);
    if (used + strlen(path) + strlen(why) + 40 > note->size) {
        note->more++;
        return;
    }
    snprintf(note->text + used, note->size - used, "%s%s %s", used ? "; " : "", path, why);
}

static void note_file(const FoundFile *file, const Chosen *chosen, Note *note, size_t *foreign)
{
    Place place = place_of(file->path);
    const FoundFile *taken = place.step ? chosen->of[place.step - step_table] : NULL;
    const char *helper = helper_path(file, chosen);
    if (file == taken || (place.foreign && !chosen->foreign_too && !place.step))
        return;
    if (file->broken && !place.foreign)
        add_note(note, file->path, file->broken);
    else if (place.foreign && !chosen->foreign_too && (!taken || !same_words(file, taken))) {
        if (++*foreign <= 5)
            add_note(note, file->path, "lies in a folder of the framework's and was not taken");
        else
            note->more++;
    } else if (!place.step && !helper)
        add_note(note, file->path, "is not called like a step and was not taken");
    else if (helper && file_ends_in(file->path, ".c"))
        add_note(note, file->path, "is not called like a step: it is there to include, and not graded");
    else if (taken && !same_words(file, taken))
        add_note(note, file->path, "is the empty step; yours was taken from another folder");
}

void choose_note(const Found *found, const Chosen *chosen, char *note, size_t size)
{
    Note all = {note, size - 40, 0};
    size_t foreign = 0;
    for (size_t i = 0; i < found->count; i++)
        note_file(&found->files[i], chosen, &all, &foreign);
    size_t used = strlen(note);
    if (all.more > 0)
        snprintf(note + used, size - used, "; and %zu more", all.more);
}
