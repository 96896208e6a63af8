// What is drawn, and what decides how.
#include "preview/view/view_internal.h"
#include "web/module/web.h"

#include "base/text.h"

#include <stdlib.h>

// A copy of what is collected goes into the view: more may come.
static bool copy_collected(Recording *copy)
{
    const Recording *all = &page.collected;
    *copy = *all;
    copy->photons = malloc((all->count + 1) * sizeof *all->photons);
    copy->legs = malloc((all->leg_count + 1) * sizeof *all->legs);
    if (!copy->photons || !copy->legs) {
        recording_free(copy);
        return error_set(&page.error, "not enough memory for the photons");
    }
    memcpy(copy->photons, all->photons, all->count * sizeof *all->photons);
    memcpy(copy->legs, all->legs, all->leg_count * sizeof *all->legs);
    copy->recorded = page.asked.recorded < all->emitted ? page.asked.recorded : all->emitted;
    recording_measure(copy);
    return true;
}

static bool ready(int width, int height)
{
    page.error.message[0] = '\0';
    if (!page.scene)
        return error_set(&page.error, "there is no scene yet");
    if (!page.canvas) {
        if (!(page.canvas = canvas_create(web_gl, width, height, &page.error)))
            return false;
        web_draw_points(page.canvas);
    }
    if (!page.data && !(page.data = view_data_create(page.canvas, page.scene)))
        return error_set(&page.error, "not enough memory for the picture");
    return canvas_resize(page.canvas, width, height, &page.error);
}

// Before findings are received, which belong to a picture.
bool EXPORT(web_open_canvas)(void)
{
    return page.canvas ? ready(canvas_width(page.canvas), canvas_height(page.canvas)) : ready(64, 64);
}

// What is collected by now is what the next pictures show.
bool EXPORT(web_show)(void)
{
    Recording copy;
    if (!web_open_canvas() || !copy_collected(&copy))
        return false;
    view_data_record(page.data, copy);
    return true;
}

// Draws into the canvas that gl.js has: no words, which the page has its own for.
bool EXPORT(web_draw)(int width, int height)
{
    if (!ready(width, height))
        return false;
    Captions captions = {.status = NULL};
    const Image *image = &page.rendered.image;
    if (page.show_rendered && image->pixels)
        captions.pictures[0] =
            (Picture){rendered_rgba(image, view_brightness(&page.view)), image->width, image->height};
    view_draw(page.canvas, &page.view, page.data, NULL, &captions);
    free((void *)captions.pictures[0].rgba);
    canvas_present(page.canvas, width, height);
    return true;
}

// In words, what the picture shows.
const char *EXPORT(web_describe)(void)
{
    page.text[0] = '\0';
    if (page.data)
        view_type(&page.view)->describe(&page.view, page.data, page.text, sizeof page.text);
    return page.text;
}

void web_append_quoted(const char *words)
{
    text_append(page.text, sizeof page.text, "\"");
    for (; *words; words++)
        text_append(page.text, sizeof page.text, *words == '"' || *words == '\\' ? "\\%c" : "%c",
                    (unsigned char)*words < ' ' ? ' ' : *words);
    text_append(page.text, sizeof page.text, "\"");
}

// JSON: what the colours mean, [["#rrggbb", "words"], …].
const char *EXPORT(web_legend)(void)
{
    Legend legend = {.count = 0};
    page.text[0] = '\0';
    if (page.data && view_type(&page.view)->legend)
        view_type(&page.view)->legend(&page.view, page.data, &legend);
    text_append(page.text, sizeof page.text, "[");
    for (int i = 0; i < legend.count; i++) {
        Rgba c = legend.entries[i].colour;
        text_append(page.text, sizeof page.text, "%s[\"#%02x%02x%02x\",", i ? "," : "", c.r, c.g, c.b);
        web_append_quoted(legend.entries[i].text);
        text_append(page.text, sizeof page.text, "]");
    }
    text_append(page.text, sizeof page.text, "]");
    return page.text;
}

// ---- the camera ----

// In heights of the picture, the scene along with the hand.
void EXPORT(web_turn)(float right, float down)
{
    view_turn(&page.view, right, down);
}

void EXPORT(web_move)(float right, float down)
{
    view_move(&page.view, right, down);
}

void EXPORT(web_zoom)(float factor) // below 1: nearer
{
    view_zoom(&page.view, factor);
}

void EXPORT(web_frame)(float aspect) // all of it fits
{
    view_frame(&page.view, page.scene, aspect);
}

void EXPORT(web_home)(void) // where the scene's camera is
{
    page.view.orbit = view_default(page.scene).orbit;
    page.view.framing = FRAMING_DEFAULT;
}

// An arrow key: what the view chooses (a path, a level of the tree).
void EXPORT(web_choose)(bool sideways, int step)
{
    if (view_type(&page.view)->choose && page.data)
        view_type(&page.view)->choose(&page.view, page.data, sideways, step);
}
