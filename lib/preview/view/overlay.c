// Words over the picture: the list of keys, whose half is whose; and breaking lines.
#include "preview/view/view_internal.h"

#include <string.h>

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
    size_t used = 0;
    for (int lines = 1;; lines++) {
        size_t length = fitting(text, scale, width), room = size - used - 4;
        length = length < room ? length : room;
        memcpy(wrapped + used, text, length);
        wrapped[used + length] = '\0';
        text += length;
        if (!*text || length == room)
            return lines;
        if (lines == most) {
            cut_short(wrapped + used, scale, width);
            return lines;
        }
        text += *text == ' ' || *text == '\n';
        used += length;
        wrapped[used++] = '\n';
    }
}

// Over the picture, so that the panel can still be read; on a dark plate.
static void draw_help(Canvas *canvas, Area area, float scale, const char *text)
{
    float across = (float)area.width, down = (float)area.height, lines = 1.0f, width, height, margin;
    for (const char *at = text; *at; at++)
        lines += *at == '\n';
    for (;; scale -= 0.1f) {
        margin = MARGIN * scale;
        width = canvas_text_width(scale, text);
        height = lines * LINE_HEIGHT * scale;
        if (scale <= 0.6f || (width + 3.0f * margin <= across && height + 3.0f * margin <= down))
            break;
    }
    float left = 0.5f * (across - width), top = 0.5f * (down - height);
    canvas_rectangle(canvas, left - margin, top - margin, width + 2.0f * margin, height + 1.4f * margin,
                     (Rgba){16, 22, 36, 240});
    canvas_text(canvas, left, top, scale, COLOUR_OF_TEXT, text);
}

void overlay_draw(Canvas *canvas, const View *view, const ViewData *yours, const Captions *captions)
{
    static const char *const TITLES[2] = {"yours", "reference"};
    float scale = view_scale(canvas, view);
    Area area = view_area(canvas, view);
    panel_draw(canvas, view, yours, captions);
    for (int half = 0; half < 2 && view->split; half++)
        canvas_text(canvas,
                    (0.25f + 0.5f * (float)half) * (float)area.width - 0.5f * canvas_text_width(scale, TITLES[half]),
                    (float)area.height - (LINE_HEIGHT + MARGIN) * scale, scale, COLOUR_OF_LIGHTS, TITLES[half]);
    if (view->help && captions->help)
        draw_help(canvas, area, scale, captions->help);
}
