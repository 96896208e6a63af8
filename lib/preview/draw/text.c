// Letters of a TrueType font of the system, by stb_truetype: each is painted once for each size, and then drawn pixel by pixel as
// points that cover as much as the letter does there. No texture, and the same bytes from every OpenGL.
#include "preview/draw/canvas_internal.h"

#include "base/array.h"
#include "base/file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#if defined(__has_include)
#if __has_include(<stb/stb_truetype.h>)
#define FONT_HEADER <stb/stb_truetype.h>
#elif __has_include(<stb_truetype.h>)
#define FONT_HEADER <stb_truetype.h>
#endif
#endif

#define TAB    7.0f // ems between places that a tab goes to
#define GLYPHS 1024 // that are kept painted; a power of two

typedef struct {
    uint32_t letter;
    float scale;
    unsigned char *cover; // width × height; NULL: not painted yet, or a blank
    int left, top, width, height;
    float advance;
} Glyph;

#ifdef FONT_HEADER

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wshadow"
#endif
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#define STBTT_assert(holds) ((void)(holds)) // of memory that is there: without, a letter is blank
#include FONT_HEADER
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#define MOST_FONT_BYTES (16u << 20)

static const char *const FONTS[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                                    "/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf",
                                    "/System/Library/Fonts/Supplemental/Arial Unicode.ttf"};

// One for the whole program, as the system has one.
static struct {
    size_t tried; // of FONTS
    bool found;
    stbtt_fontinfo info;
    Glyph glyphs[GLYPHS];
} font;

bool canvas_has_letters(void)
{
    const char *without = getenv("PHOTONLAB_WITHOUT");
    size_t size, most = sizeof FONTS / sizeof *FONTS;
    if (without && strstr(without, "font"))
        font.tried = most;
    while (!font.found && font.tried < most) {
        unsigned char *bytes = (unsigned char *)file_read(FONTS[font.tried++], MOST_FONT_BYTES, &size, NULL);
        font.found = bytes && stbtt_InitFont(&font.info, bytes, stbtt_GetFontOffsetForIndex(bytes, 0));
        if (!font.found)
            free(bytes);
    }
    return font.found;
}

// A question mark for what the font has not.
static const Glyph *glyph_of(uint32_t letter, float scale)
{
    if (letter >= 128 && stbtt_FindGlyphIndex(&font.info, (int)letter) == 0)
        letter = '?';
    uint32_t place = (letter * 31 + (uint32_t)(scale * 64.0f)) % GLYPHS;
    Glyph *glyph = &font.glyphs[place];
    if (glyph->letter == letter && glyph->scale == scale)
        return glyph;
    free(glyph->cover);
    *glyph = (Glyph){.letter = letter, .scale = scale};
    float size = stbtt_ScaleForMappingEmToPixels(&font.info, EM * scale);
    int advance, bearing;
    stbtt_GetCodepointHMetrics(&font.info, (int)letter, &advance, &bearing);
    glyph->advance = (float)advance * size;
    glyph->cover = stbtt_GetCodepointBitmap(&font.info, size, size, (int)letter, &glyph->width, &glyph->height,
                                            &glyph->left, &glyph->top);
    if (!glyph->cover)
        glyph->width = glyph->height = 0;
    return glyph;
}

#else

bool canvas_has_letters(void)
{
    return false;
}

static const Glyph *glyph_of(uint32_t letter, float scale)
{
    (void)letter, (void)scale;
    return NULL;
}

#endif

// The next character of UTF-8; what is none, or cannot be shown, is a question mark.
static uint32_t next_letter(const char **text)
{
    const unsigned char *at = (const unsigned char *)*text;
    int more = at[0] < 0x80 ? 0 : at[0] >= 0xF0 ? 3 : at[0] >= 0xE0 ? 2 : at[0] >= 0xC0 ? 1 : -1;
    uint32_t letter = more <= 0 ? at[0] : at[0] & (0x3Fu >> more);
    bool sound = more >= 0;
    for (int i = 1; i <= more && sound; i++) {
        sound = (at[i] & 0xC0) == 0x80;
        letter = letter << 6 | (at[i] & 0x3F);
    }
    *text += sound ? more + 1 : 1;
    return sound && (letter >= 32 || letter == '\n' || letter == '\t') && letter != 127 ? letter : '?';
}

typedef struct {
    float left, x, y, scale;
} Pen;

// Moves the pen past the letter. NULL: it leaves nothing.
static const Glyph *write_letter(Pen *pen, uint32_t letter)
{
    float tab = TAB * EM * pen->scale;
    if (letter == '\n') {
        pen->x = pen->left;
        pen->y += LINE_HEIGHT * pen->scale;
        return NULL;
    }
    if (letter == '\t') {
        pen->x = pen->left + tab * floorf((pen->x - pen->left) / tab + 1.0f);
        return NULL;
    }
    const Glyph *glyph = glyph_of(letter, pen->scale);
    pen->x += glyph->advance;
    return glyph;
}

Vertex *text_vertices(float x, float y, float scale, Rgba colour, const char *text, size_t *count)
{
    Vertex *points = NULL;
    size_t capacity = 0;
    *count = 0;
    if (!canvas_has_letters())
        return NULL;
    Pen pen = {floorf(x + 0.5f), floorf(x + 0.5f), floorf(y + BASE_LINE * scale + 0.5f), scale};
    while (*text) {
        float from = floorf(pen.x + 0.5f), down = floorf(pen.y + 0.5f);
        const Glyph *glyph = write_letter(&pen, next_letter(&text));
        size_t cells = glyph && glyph->cover ? (size_t)glyph->width * (size_t)glyph->height : 0;
        if (!array_reserve(&points, *count + cells, &capacity, sizeof *points))
            break;
        for (size_t i = 0; i < cells; i++) {
            int cover = glyph->cover[i] * colour.a / 255;
            float right = (float)(glyph->left + (int)(i % (size_t)glyph->width)) + 0.5f;
            float below = (float)(glyph->top + (int)(i / (size_t)glyph->width)) + 0.5f;
            if (cover > 0)
                points[(*count)++] =
                    (Vertex){from + right, down + below, 0, colour.r, colour.g, colour.b, (uint8_t)cover};
        }
    }
    return points;
}

float canvas_text_width(float scale, const char *text)
{
    float widest = 0.0f;
    Pen pen = {0.0f, 0.0f, 0.0f, scale};
    if (!canvas_has_letters())
        return 0.5f * EM * scale * (float)strlen(text); // so that lines are cut where they would be
    while (*text) {
        write_letter(&pen, next_letter(&text));
        widest = fmaxf(widest, pen.x);
    }
    return widest;
}
