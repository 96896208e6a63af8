// Letters made of small rectangles, by stb_easy_font: no font file, no texture. Where it was missing when the program
// was built, the preview has no words.
#include "preview/draw/canvas_internal.h"

#include <stdlib.h>
#include <string.h>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wchar-subscripts"
#endif
#if defined(__has_include)
#if __has_include(<stb/stb_easy_font.h>)
#include <stb/stb_easy_font.h>
#define HAVE_FONT 1
#elif __has_include(<stb_easy_font.h>)
#include <stb_easy_font.h>
#define HAVE_FONT 1
#endif
#endif
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#ifdef HAVE_FONT

#define QUADS_PER_LETTER 16 // at most: @ has 14

// What our own sentences hold beside ASCII; no longer than the UTF-8 it stands for.
static const char *ascii_for(const char *text)
{
    static const char *const pairs[][2] = {{"±", "+-"}, {"×", "x"}, {"…", ".."}, {"°", "o"}, {"·", "|"}, {"−", "-"}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        if (strncmp(text, pairs[i][0], strlen(pairs[i][0])) == 0)
            return pairs[i][1];
    return "?";
}

#define MOST_LETTERS 4096

// The text as the font can show it: it knows 32…126 and the line's end, and reads past its table for anything else.
// Another letter of several bytes (UTF-8) becomes one `?`.
static char *printable(const char *text, char letters[MOST_LETTERS])
{
    char *end = letters;
    for (; *text && end < letters + MOST_LETTERS - 3; text++) {
        unsigned char c = (unsigned char)*text;
        if ((c & 0xC0) == 0x80)
            continue;
        if (c == '\n' || (c >= 32 && c < 127))
            *end++ = (char)c;
        else
            for (const char *letter = c < 128 ? "?" : ascii_for(text); *letter; letter++)
                *end++ = *letter;
    }
    *end = '\0';
    return letters;
}

// Puts the quad of four corners there as two triangles.
static void put_quad(Vertex *triangles, const Vertex quad[4], float x, float y, float scale)
{
    static const int ORDER[6] = {0, 1, 2, 0, 2, 3};
    for (int i = 0; i < 6; i++) {
        triangles[i] = quad[ORDER[i]];
        triangles[i].x = x + scale * triangles[i].x;
        triangles[i].y = y + scale * triangles[i].y;
    }
}

Vertex *text_vertices(float x, float y, float scale, Rgba colour, const char *text, size_t *count)
{
    *count = 0;
    char letters[MOST_LETTERS];
    size_t most = strlen(printable(text, letters)) * QUADS_PER_LETTER;
    Vertex *quads = malloc((most * 4 + 1) * sizeof *quads);
    Vertex *triangles = malloc((most * 6 + 1) * sizeof *triangles);
    if (quads && triangles) {
        unsigned char ink[4] = {colour.r, colour.g, colour.b, colour.a};
        int made = stb_easy_font_print(0, 0, letters, ink, quads, (int)(most * 4 * sizeof *quads));
        // Whole pixels: a stroke between two would be there or not by chance.
        x = (float)(int)(x + 0.5f);
        y = (float)(int)(y + 0.5f);
        for (int i = 0; i < made; i++)
            put_quad(triangles + 6 * i, quads + 4 * i, x, y, scale);
        *count = 6 * (size_t)made;
    }
    free(quads);
    return triangles;
}

float canvas_text_width(float scale, const char *text)
{
    char letters[MOST_LETTERS];
    return scale * (float)stb_easy_font_width(printable(text, letters));
}

#else

Vertex *text_vertices(float x, float y, float scale, Rgba colour, const char *text, size_t *count)
{
    (void)x, (void)y, (void)scale, (void)colour, (void)text;
    *count = 0;
    return NULL;
}

float canvas_text_width(float scale, const char *text)
{
    return 6.0f * scale * (float)strlen(text); // so that lines are cut where they would be
}

#endif
