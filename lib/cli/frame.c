#include "cli/cli.h"
#include "preview/draw/canvas_internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char help[] =
    "usage: photonlab frame PICTURE [PICTURE] -o OUT.png [flags]\n"
    "\n"
    "Frames a picture, or two of one height side by side, with words below it: what `make finale` hangs on the wall.\n"
    "\n"
    "  -o FILE        where to: .png or .pfm\n"
    "  --title WORDS  a line in large letters\n"
    "  --text WORDS   lines in small ones; \\n begins another\n";

static const char *files[2], *out, *title = "", *text = "";
static const Flag flags[] = {
    {"o", FLAG_TEXT, &out, 0, 0}, {"title", FLAG_TEXT, &title, 0, 0}, {"text", FLAG_TEXT, &text, 0, 0}};

static void fill(Image *image, int x0, int y0, int x1, int y1, Colour colour)
{
    for (int y = y0 > 0 ? y0 : 0; y < y1 && y < image->height; y++)
        for (int x = x0 > 0 ? x0 : 0; x < x1 && x < image->width; x++)
            *image_at(image, x, y) = colour;
}

// Letters are points, one a pixel, as dense as the letter covers it.
static void write_words(Image *image, int x, int y, float scale, const char *words)
{
    size_t count;
    Vertex *points = text_vertices((float)x, (float)y, scale, (Rgba){255, 255, 255, 255}, words, &count);
    for (size_t i = 0; points && i < count; i++)
        if (points[i].x >= 0.0f && points[i].x < (float)image->width && points[i].y < (float)image->height)
            *image_at(image, (int)points[i].x, (int)points[i].y) = colour_grey(0.55f * (float)points[i].a / 255.0f);
    free(points);
}

static void hang(Image *wall, const Image *picture, int x, int y)
{
    int edge = 2; // a thin light line about it
    fill(wall, x - edge, y - edge, x + picture->width + edge, y + picture->height + edge, colour(0.4f, 0.36f, 0.28f));
    for (int row = 0; row < picture->height; row++)
        memcpy(image_at(wall, x, y + row), image_at(picture, 0, row), (size_t)picture->width * sizeof(Colour));
}

// `\n` as two characters, as a shell passes it, begins a new line. Returns how many lines there are.
static int break_lines(const char *words, char *lines, size_t size)
{
    int count = *words != '\0';
    size_t used = 0;
    for (; *words && used + 1 < size; words++) {
        bool breaks = words[0] == '\n' || (words[0] == '\\' && words[1] == 'n');
        count += breaks;
        lines[used++] = breaks ? '\n' : *words;
        words += breaks && *words == '\\';
    }
    lines[used] = '\0';
    return count;
}

// As large as fits: its own lines may be as wide as the pictures.
static float scale_of(const char *words, int width, float most)
{
    return fminf(most, 0.98f * (float)width / fmaxf(canvas_text_width(1.0f, words), 1.0f));
}

static bool make_frame(const Image pictures[2], Image *wall, Error *error)
{
    int side = pictures[0].height / 12 + 4, gap = pictures[1].pixels ? side / 2 : 0;
    int inner = pictures[0].width + gap + pictures[1].width;
    char lines[2000];
    int count = break_lines(text, lines, sizeof lines);
    float large = scale_of(title, inner, 1.0f + (float)inner / 500.0f);
    float small = scale_of(lines, inner, 0.5f + (float)inner / 1000.0f);
    int above = *title ? (int)(1.3f * LINE_HEIGHT * large) : 0, words = above + (int)(LINE_HEIGHT * small) * count;
    if (!image_create(wall, inner + 2 * side, pictures[0].height + 2 * side + words + (words ? side / 2 : 0), error))
        return false;
    fill(wall, 0, 0, wall->width, wall->height, colour(0.012f, 0.012f, 0.016f));
    hang(wall, &pictures[0], side, side);
    if (gap)
        hang(wall, &pictures[1], side + pictures[0].width + gap, side);
    int y = side + pictures[0].height + side / 2 + 4;
    write_words(wall, side, y, large, title);
    write_words(wall, side, y + above, small, lines);
    return true;
}

static int run(void)
{
    Error error = {""};
    Image pictures[2] = {{0}}, wall = {0};
    if (!out || !image_path_is_known(out, &error))
        return report_usage("photonlab frame", "%s", out ? error.message : "say where to: -o OUT.png");
    bool ok = image_read(&pictures[0], files[0], &error) && (!files[1] || image_read(&pictures[1], files[1], &error));
    if (ok && files[1] && pictures[0].height != pictures[1].height)
        ok = error_set(&error, "%s: %d pixels high, where %s has %d", files[1], pictures[1].height, files[0],
                       pictures[0].height);
    ok = ok && make_frame(pictures, &wall, &error) && image_write(&wall, out, &error);
    image_free(&pictures[0]);
    image_free(&pictures[1]);
    image_free(&wall);
    return ok ? 0 : report_error(&error);
}

const Command command_frame = {
    .words = "a frame with words about a picture",
    .line = {"photonlab frame", help, "one picture or two", flags, FLAG_COUNT(flags), 1, 2},
    .files = files,
    .run = run,
};
