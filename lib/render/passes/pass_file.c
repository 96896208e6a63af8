#include "render/passes/pass_file.h"
#include "base/file.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FIRST_LINE   "photonlab passes 1"
#define MOST_BYTES   ((size_t)1 << 40)
#define POINT_FLOATS (sizeof(PointStatistics) / sizeof(float))

// ---- writing ----

static void put_floats(FILE *stream, const void *floats, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        unsigned char bytes[4];
        file_put_float(bytes, ((const float *)floats)[i]);
        fwrite(bytes, 1, sizeof bytes, stream);
    }
}

bool pass_file_write(const char *path, const PassOrigin *origin, const Passes *passes, Error *error)
{
    FileWriter writer;
    const PassSums *sums = &passes->sums;
    int width = sums->runs[0].mean.width, height = sums->runs[0].mean.height;
    size_t pixels = (size_t)width * (size_t)height;
    if (!file_write_begin(&writer, path, error))
        return false;
    fprintf(writer.stream,
            "%s\n%s\n%s\n%s\npart %d/%d of %d passes: %d done, %dx%d, %d eye rays a pixel, "
            "radii by %s, runs of",
            FIRST_LINE, origin->scene, origin->settings, origin->code, origin->part, origin->parts, origin->all,
            passes->done, width, height, passes->samples, passes->by_pixel ? "pixel" : "pass");
    for (int i = 0; i < sums->count; i++)
        fprintf(writer.stream, " %d", sums->runs[i].count);
    fprintf(writer.stream, "\n");
    put_floats(writer.stream, &passes->radius, 1);
    for (int i = 0; i < sums->count; i++)
        put_floats(writer.stream, sums->runs[i].mean.pixels, 3 * pixels);
    if (passes->by_pixel)
        put_floats(writer.stream, passes->points, POINT_FLOATS * pixels);
    return file_write_end(&writer, true, error);
}

// ---- reading ----

// A file's bytes, from the place that was reached.
typedef struct {
    const char *path;
    const unsigned char *at, *end;
    Error *error;
} Reader;

static bool damaged(const Reader *reader, const char *what)
{
    return error_set(reader->error, "%s: %s; expected a whole file as `photonlab render --passes` writes it",
                     reader->path, what);
}

// The next line, without its end.
static bool take_line(Reader *reader, char *line, size_t size)
{
    const unsigned char *end = memchr(reader->at, '\n', (size_t)(reader->end - reader->at));
    if (!end || (size_t)(end - reader->at) >= size)
        return damaged(reader, "is no file of passes");
    memcpy(line, reader->at, (size_t)(end - reader->at));
    line[end - reader->at] = '\0';
    reader->at = end + 1;
    return true;
}

static void take_floats(Reader *reader, void *floats, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t bits = 0;
        for (int byte = 0; byte < 4; byte++)
            bits |= (uint32_t)*reader->at++ << (8 * byte);
        memcpy((float *)floats + i, &bits, sizeof bits);
    }
}

// "part 3/8 of 64 passes: 8 done, 512x512, 1 eye rays a pixel, radii by pass, runs of 4 4"
static bool take_numbers(Reader *reader, PassOrigin *origin, Passes *passes, int size[2])
{
    char line[1000], radii[8];
    int length = 0, counted = 0;
    if (!take_line(reader, line, sizeof line))
        return false;
    if (sscanf(line, "part %d/%d of %d passes: %d done, %dx%d, %d eye rays a pixel, radii by %7[a-z], runs of%n",
               &origin->part, &origin->parts, &origin->all, &passes->done, &size[0], &size[1], &passes->samples, radii,
               &length) != 8 ||
        length == 0 || passes->samples < 1 || size[0] < 1 || size[0] > IMAGE_MAX_SIDE || size[1] < 1 ||
        size[1] > IMAGE_MAX_SIDE || origin->all < 1 || origin->all > MOST_PASSES || origin->parts < 1 ||
        origin->parts > origin->all || origin->part < 1 || origin->part > origin->parts)
        return damaged(reader, "its numbers cannot be");
    pass_origin_range(origin, &passes->first, &passes->last);
    passes->by_pixel = strcmp(radii, "pixel") == 0;
    if (passes->by_pixel && passes->done > INT_MAX / passes->samples)
        return damaged(reader, "its numbers cannot be");
    int run;
    for (const char *at = line + length; sscanf(at, "%d%n", &run, &length) == 1; at += length) {
        if (run < 1 || run > passes->done - counted || passes->sums.count == MOST_RUNS)
            return damaged(reader, "its numbers cannot be");
        passes->sums.runs[passes->sums.count++] = (PassRun){passes->first + counted, run, {0, 0, NULL}};
        counted += run;
    }
    return (passes->done >= 1 && counted == passes->done && passes->done <= passes->last - passes->first) ||
           damaged(reader, "its numbers cannot be");
}

static bool take_pictures(Reader *reader, Passes *passes, const int size[2])
{
    size_t pixels = (size_t)size[0] * (size_t)size[1];
    size_t floats = 1 + pixels * (3 * (size_t)passes->sums.count + (passes->by_pixel ? POINT_FLOATS : 0));
    if ((size_t)(reader->end - reader->at) != 4 * floats)
        return damaged(reader, "is cut off, or longer than it says");
    take_floats(reader, &passes->radius, 1);
    for (int i = 0; i < passes->sums.count; i++) {
        Image *mean = &passes->sums.runs[i].mean;
        if (!image_create(mean, size[0], size[1], reader->error))
            return false;
        take_floats(reader, mean->pixels, 3 * pixels);
    }
    if (!passes->by_pixel)
        return true;
    if (!(passes->points = malloc(pixels * sizeof *passes->points)))
        return error_set(reader->error, "%s: no memory for %zu points", reader->path, pixels);
    take_floats(reader, passes->points, POINT_FLOATS * pixels);
    return true;
}

bool pass_file_read(const char *path, PassOrigin *origin, Passes *passes, Error *error)
{
    size_t bytes;
    int size[2];
    char first[sizeof FIRST_LINE];
    char *text = file_read(path, MOST_BYTES, &bytes, error);
    if (!text)
        return false;
    Reader reader = {path, (const unsigned char *)text, (const unsigned char *)text + bytes, error};
    passes->sums.count = 0;
    passes->points = NULL;
    bool ok = take_line(&reader, first, sizeof first) &&
              (strcmp(first, FIRST_LINE) == 0 || damaged(&reader, "is no file of passes")) &&
              take_line(&reader, origin->scene, sizeof origin->scene) &&
              take_line(&reader, origin->settings, sizeof origin->settings) &&
              take_line(&reader, origin->code, sizeof origin->code) && take_numbers(&reader, origin, passes, size) &&
              take_pictures(&reader, passes, size);
    free(text);
    if (!ok)
        passes_free(passes);
    return ok;
}
