#include "render/passes/pass_file.h"
#include "base/file.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define FIRST_LINE   "photonlab passes 1"
#define MOST_BYTES   ((size_t)1 << 40)
#define POINT_FLOATS 5

static size_t floats_of(const Passes *passes, size_t pixels)
{
    return 1 + pixels * (3 * (size_t)passes->sums.count + (passes->by_pixel ? POINT_FLOATS : 0));
}

// ---- writing ----

static void put_float(FILE *stream, float value)
{
    unsigned char bytes[4];
    file_put_float(bytes, value);
    fwrite(bytes, 1, sizeof bytes, stream);
}

static void put_colour(FILE *stream, Colour colour)
{
    for (int c = 0; c < 3; c++)
        put_float(stream, colour_channel(colour, c));
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
    put_float(writer.stream, passes->radius);
    for (int i = 0; i < sums->count; i++)
        for (size_t p = 0; p < pixels; p++)
            put_colour(writer.stream, sums->runs[i].mean.pixels[p]);
    for (size_t p = 0; passes->by_pixel && p < pixels; p++) {
        put_float(writer.stream, passes->points[p].count);
        put_float(writer.stream, passes->points[p].radius);
        put_colour(writer.stream, passes->points[p].flux);
    }
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

static float take_float(Reader *reader)
{
    float value;
    uint32_t bits = 0;
    for (int i = 0; i < 4; i++)
        bits |= (uint32_t)*reader->at++ << (8 * i);
    memcpy(&value, &bits, sizeof value);
    return value;
}

static Colour take_colour(Reader *reader)
{
    float r = take_float(reader);
    float g = take_float(reader);
    float b = take_float(reader);
    return colour(r, g, b);
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

static bool take_floats(Reader *reader, Passes *passes, const int size[2])
{
    size_t pixels = (size_t)size[0] * (size_t)size[1];
    if ((size_t)(reader->end - reader->at) != 4 * floats_of(passes, pixels))
        return damaged(reader, "is cut off, or longer than it says");
    for (int i = 0; i < passes->sums.count; i++)
        if (!image_create(&passes->sums.runs[i].mean, size[0], size[1], reader->error))
            return false;
    passes->radius = take_float(reader);
    for (int i = 0; i < passes->sums.count; i++)
        for (size_t p = 0; p < pixels; p++)
            passes->sums.runs[i].mean.pixels[p] = take_colour(reader);
    if (!passes->by_pixel)
        return true;
    if (!(passes->points = malloc(pixels * sizeof *passes->points)))
        return error_set(reader->error, "%s: no memory for %zu points", reader->path, pixels);
    for (size_t p = 0; p < pixels; p++) {
        passes->points[p].count = take_float(reader);
        passes->points[p].radius = take_float(reader);
        passes->points[p].flux = take_colour(reader);
    }
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
              take_floats(&reader, passes, size);
    free(text);
    if (!ok)
        passes_free(passes);
    return ok;
}
