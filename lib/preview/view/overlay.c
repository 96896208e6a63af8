// Words around the picture: title lines, a fault, the status, the list of keys.
#include "preview/view/view_internal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LINE   12.0f // pixels between lines, at scale 1
#define MARGIN 6.0f

static const Rgba PLATE = {12, 15, 22, 205};
static const Rgba RED_PLATE = {120, 16, 20, 235};

float overlay_scale(const Canvas *canvas)
{
    float height = (float)canvas_height(canvas), width = (float)canvas_width(canvas);
    float side = fminf(height, 0.6f * width); // whole numbers: letters stay even
    return side < 640.0f ? 1.0f : side < 1300.0f ? 2.0f : 3.0f;
}

static size_t fitting(const char *text, float scale, float width)
{
    size_t end = strcspn(text, "\n"), space = 0;
    char line[512];
    for (size_t i = 0; i < end && i + 1 < sizeof line; i++) {
        line[i] = text[i];
        line[i + 1] = '\0';
        if (canvas_text_width(scale, line) > width)
            return space ? space : i ? i : 1;
        if (text[i] == ' ')
            space = i;
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

// Wrapped text over the whole width, at the top, or at the bottom and a little lower. Returns its height.
static float draw_bar(Canvas *canvas, float scale, bool at_bottom, int most, Rgba ink, Rgba plate, const char *text)
{
    char wrapped[2048];
    float width = (float)canvas_width(canvas), margin = MARGIN * scale;
    int lines = overlay_wrap(text, scale, width - 2.0f * margin, most, wrapped, sizeof wrapped);
    float height = (float)lines * LINE * scale + (at_bottom ? 1.2f : 1.4f) * margin;
    float top = at_bottom ? (float)canvas_height(canvas) - height : 0.0f;
    canvas_rectangle(canvas, 0, top, width, height, plate);
    canvas_text(canvas, margin, top + (at_bottom ? 0.8f : 1.0f) * margin, scale, ink, wrapped);
    return height;
}

static void draw_help(Canvas *canvas, float scale, const char *text)
{
    float across = (float)canvas_width(canvas), down = (float)canvas_height(canvas);
    while (scale > 0.6f && (canvas_text_width(scale, text) + 3.0f * MARGIN * scale > across ||
                            text_height(text, scale) + 3.0f * MARGIN * scale > down))
        scale -= 0.1f;
    float width = canvas_text_width(scale, text), height = text_height(text, scale);
    draw_plate(canvas, 0.5f * (across - width) - MARGIN * scale, 0.5f * (down - height) - MARGIN * scale, scale,
               COLOUR_OF_TEXT, (Rgba){16, 22, 36, 240}, text);
}

// What is shown, at the top left.
static void draw_description(Canvas *canvas, float scale, float top, const View *view, const ViewData *data)
{
    char text[1024] = "", wrapped[1200];
    view_type(view)->describe(view, data, text, sizeof text);
    if (!text[0])
        return;
    float width = (float)canvas_width(canvas) * (view->split ? 0.46f : 0.66f) - 2.0f * MARGIN * scale;
    overlay_wrap(text, scale, width, 7, wrapped, sizeof wrapped);
    draw_plate(canvas, 0, top, scale, COLOUR_OF_TEXT, (Rgba){12, 15, 22, 150}, wrapped);
}

static void draw_title(Canvas *canvas, float scale, float middle, float bottom, const char *title)
{
    float width = canvas_text_width(scale, title) + 2.0f * MARGIN * scale;
    draw_plate(canvas, middle - 0.5f * width, bottom - (LINE + 1.4f * MARGIN) * scale, scale, COLOUR_OF_LIGHTS, PLATE,
               title);
}

void overlay_draw(Canvas *canvas, const View *view, const ViewData *yours, const Captions *captions)
{
    float scale = overlay_scale(canvas), top = 0.0f, width = (float)canvas_width(canvas);
    if (captions->banner && captions->banner[0])
        top = draw_bar(canvas, scale, false, canvas_height(canvas) < 400 ? 4 : 8, (Rgba){255, 235, 230, 255}, RED_PLATE,
                       captions->banner);
    bool rendered = captions->pictures[0].rgba;
    if (!rendered) {
        draw_description(canvas, scale, top, view, yours);
        legend_draw(canvas, view, yours, top);
    }
    if (view->split) {
        float bottom = (float)canvas_height(canvas) - (captions->status ? 38.0f * scale : 4.0f);
        draw_title(canvas, scale, 0.25f * width, bottom, "yours");
        draw_title(canvas, scale, 0.75f * width, bottom, "reference");
    }
    if (captions->status && captions->status[0])
        draw_bar(canvas, scale, true, 2, COLOUR_OF_TEXT, PLATE, captions->status);
    if (view->help && captions->help)
        draw_help(canvas, scale, captions->help);
}
