// Words over the picture: the list of keys, whose half is whose; and breaking lines.
#include "preview/view/view_internal.h"

#include <string.h>

#define LINE   LINE_HEIGHT
#define MARGIN 6.0f

static size_t fitting(const char *text, float scale, float width)
{
    size_t end = strcspn(text, "\n"), space = 0, slash = 0;
    char line[512];
    for (size_t i = 0; i < end && i + 1 < sizeof line; i++) {
        line[i] = text[i];
        line[i + 1] = '\0';
        if (canvas_text_width(scale, line) > width)
            return space ? space : slash ? slash : i ? i : 1;
        if (text[i] == ' ')
            space = i;
        if (text[i] == '/') // a path is long, and has no blanks
            slash = i + 1;
    }
    return end < sizeof line ? end : sizeof line - 1;
}

// Takes characters off the line until ".." fits after it.
static void cut_short(char *line, float scale, float width)
{
    size_t length = strlen(line);
    do {
        strcpy(line + length, "..");
    } while (canvas_text_width(scale, line) > width && length-- > 0);
}

int overlay_wrap(const char *text, float scale, float width, int most, char *wrapped, size_t size)
{
    int lines = 0;
    size_t used = 0;
    while (lines < most) {
        size_t length = fitting(text, scale, width);
        if (used + length + 4 > size)
            length = size > used + 4 ? size - used - 4 : 0;
        memcpy(wrapped + used, text, length);
        wrapped[used + length] = '\0';
        text += length;
        lines++;
        if (!*text || used + length + 4 >= size)
            return lines;
        if (lines == most) {
            cut_short(wrapped + used, scale, width);
            return lines;
        }
        text += *text == ' ' || *text == '\n';
        used += length;
        wrapped[used++] = '\n';
    }
    return lines;
}

static float text_height(const char *text, float scale)
{
    int lines = 1;
    for (; *text; text++)
        lines += *text == '\n';
    return (float)lines * LINE * scale;
}

// Text on a dark plate; (x, y) its top left corner.
static void draw_plate(Canvas *canvas, float x, float y, float scale, Rgba ink, Rgba plate, const char *text)
{
    float margin = MARGIN * scale;
    canvas_rectangle(canvas, x, y, canvas_text_width(scale, text) + 2.0f * margin,
                     text_height(text, scale) + 1.4f * margin, plate);
    canvas_text(canvas, x + margin, y + margin, scale, ink, text);
}

// Over the picture, so that the panel can still be read.
static void draw_help(Canvas *canvas, const View *view, float scale, const char *text)
{
    float across = (float)view_area(canvas, view).width, down = (float)canvas_height(canvas);
    while (scale > 0.6f && (canvas_text_width(scale, text) + 3.0f * MARGIN * scale > across ||
                            text_height(text, scale) + 3.0f * MARGIN * scale > down))
        scale -= 0.1f;
    float width = canvas_text_width(scale, text), height = text_height(text, scale);
    draw_plate(canvas, 0.5f * (across - width) - MARGIN * scale, 0.5f * (down - height) - MARGIN * scale, scale,
               COLOUR_OF_TEXT, (Rgba){16, 22, 36, 240}, text);
}

static void draw_title(Canvas *canvas, const Area *area, float share, float scale, const char *title)
{
    float width = canvas_text_width(scale, title);
    canvas_text(canvas, (float)area->left + share * (float)area->width - 0.5f * width,
                (float)(area->top + area->height) - (LINE + MARGIN) * scale, scale, COLOUR_OF_LIGHTS, title);
}

void overlay_draw(Canvas *canvas, const View *view, const ViewData *yours, const Captions *captions)
{
    float scale = view_scale(canvas, view);
    Area area = view_area(canvas, view);
    if (view->panel <= 0.0f)
        return;
    panel_draw(canvas, view, yours, captions);
    if (view->split) {
        draw_title(canvas, &area, 0.25f, scale, "yours");
        draw_title(canvas, &area, 0.75f, scale, "reference");
    }
    if (view->help && captions->help)
        draw_help(canvas, view, scale, captions->help);
}
