#include "cli/render.h"
#include "base/file.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>

static const char help[] =
    "usage: photonlab merge FILE.part… -o OUT.png|OUT.pfm|OUT.part\n"
    "\n"
    "Makes one picture of the passes that several runs of `photonlab render --passes N --part K/M` have written: the same bytes as one\n"
    "run of all passes. Says which parts are missing, there twice, not finished, or of another picture.\n"
    "\n"
    "  -o FILE       where to: a picture, or a file of all passes\n"
    "  --bits 8|16   of the PNG's channels (8)\n"
    "  --code DIR    play the steps built in DIR\n";

#define MOST_FILES 10000

typedef struct {
    const char *path;
    PassOrigin origin;
    int first, last, done;
} Part;

static const char *files[MOST_FILES + 1], *out, *code; // files end with NULL
static int bits = 8;
static const Flag flags[] = {
    {"o", FLAG_TEXT, &out, 0, 0}, {"bits", FLAG_INT, &bits, 8, 16}, {"code", FLAG_TEXT, &code, 0, 0}};

static int compare(const void *a, const void *b)
{
    const Part *x = a, *y = b;
    return x->first != y->first ? x->first - y->first : x->last - y->last;
}

// What each file holds, in the order of their passes. Only one is in memory at a time.
static bool look_at(Part *parts, int count, Error *error)
{
    for (int i = 0; i < count; i++) {
        Part *part = &parts[i];
        Passes passes = {0};
        char differs[800];
        part->path = files[i];
        if (!pass_file_read(part->path, &part->origin, &passes, error))
            return false;
        part->first = passes.first;
        part->last = passes.last;
        part->done = passes.done;
        passes_free(&passes);
        if (pass_origin_differs(&part->origin, &parts[0].origin, differs, sizeof differs))
            return error_set(error, "%s: does not belong to %s: %s", part->path, parts[0].path, differs);
        if (part->origin.all != parts[0].origin.all)
            return error_set(error, "%s: does not belong to %s: it is of %d passes, not %d", part->path, parts[0].path,
                             part->origin.all, parts[0].origin.all);
    }
    qsort(parts, (size_t)count, sizeof *parts, compare);
    return true;
}

// Those passes are nowhere: in which parts are they, and how are they made?
static bool report_missing(const Part *like, int first, int last, Error *error)
{
    char list[200] = "";
    PassOrigin origin = like->origin;
    for (origin.part = 1; origin.part <= origin.parts; origin.part++) {
        int begins, ends;
        pass_origin_range(&origin, &begins, &ends);
        if (begins < last && ends > first)
            text_append(list, sizeof list, "%s%d/%d", *list ? ", " : "", origin.part, origin.parts);
    }
    return error_set(
        error,
        "passes %d to %d of %d are missing: part %s. Each is made by\n  photonlab render SCENE %s --passes "
        "%d --part K/%d -o OUT" PASS_FILE_ENDING,
        first + 1, last, origin.all, list, origin.settings, origin.all, origin.parts);
}

static bool check_complete(const Part *parts, int count, Error *error)
{
    int reached = 0;
    for (int i = 0; i < count; i++) {
        const Part *part = &parts[i];
        if (part->first < reached)
            return error_set(error, "%s and %s both hold pass %d", parts[i - 1].path, part->path, part->first + 1);
        if (part->first > reached)
            return report_missing(part, reached, part->first, error);
        if (part->done < part->last - part->first)
            return error_set(error, "%s: was stopped after %d of its %d passes; to go on: its command with --resume %s",
                             part->path, part->done, part->last - part->first, part->path);
        reached = part->last;
    }
    const Part *last = &parts[count - 1];
    return reached == last->origin.all || report_missing(last, reached, last->origin.all, error);
}

// Moves a part's runs, or all that the only one holds.
static bool add_part(const char *path, Passes *all, Error *error)
{
    PassOrigin origin;
    Passes part = {0};
    if (!pass_file_read(path, &origin, &part, error))
        return false;
    for (int i = 0; i < part.sums.count; i++)
        pass_sums_add(&all->sums, part.sums.runs[i]);
    all->radius = part.radius;
    all->samples = part.samples;
    all->by_pixel = part.by_pixel;
    all->points = part.points;
    all->done += part.done;
    return true;
}

static bool merge(Part *parts, int count, Passes *all, Error *error)
{
    if (!look_at(parts, count, error) || !check_complete(parts, count, error))
        return false;
    for (int i = 0; i < count; i++)
        if (!add_part(parts[i].path, all, error))
            return false;
    PassOrigin origin = parts[0].origin;
    origin.part = origin.parts = 1;
    if (file_ends_in(out, PASS_FILE_ENDING))
        return pass_file_write(out, &origin, all, error);
    Image image = {0, 0, NULL};
    bool sound;
    bool ok = passes_picture(all, &image, error) && write_picture(&image, out, bits, &sound, error);
    image_free(&image);
    return ok;
}

static int run(void)
{
    Error error = {""};
    if (bits != 8 && bits != 16)
        return report_usage("photonlab merge", "--bits %d: expected 8 or 16", bits);
    if (!out)
        return report_usage("photonlab merge", "say where to write the picture: -o OUT.png");
    if (!file_ends_in(out, PASS_FILE_ENDING) && !image_path_is_known(out, &error))
        return report_usage("photonlab merge", "%s", error.message);
    int count = 0;
    while (files[count])
        count++;
    Passes all = {0};
    Part *parts = calloc((size_t)count, sizeof *parts);
    bool ok = parts ? file_may_write(out, &error) && steps_load(code, &error) && merge(parts, count, &all, &error)
                    : error_set(&error, "not enough memory");
    passes_free(&all);
    free(parts);
    return ok ? 0 : report_error(&error);
}

const Command command_merge = {
    .words = "one picture of passes that several machines have rendered",
    .line = {"photonlab merge", help, "files of passes", flags, FLAG_COUNT(flags), 1, MOST_FILES},
    .files = files,
    .run = run,
};
