#include "preview/view/view_internal.h"

#include <stdlib.h>
#include <string.h>

static const char *const KINDS[VIEW_COUNT] = {"points", "paths", "lobe", "screen", "tree"};
static const char *const COLOURS[COLOUR_COUNT] = {"power", "photon", "bounce", "material"};

static int find_name(const char *const *names, int count, const char *name)
{
    for (int i = 0; i < count; i++)
        if (strcmp(names[i], name) == 0)
            return i;
    return -1;
}

bool view_kind_parse(const char *name, ViewKind *kind)
{
    int found = find_name(KINDS, VIEW_COUNT, name);
    if (found >= 0)
        *kind = (ViewKind)found;
    return found >= 0;
}

bool colour_mode_parse(const char *name, ColourMode *colour)
{
    int found = find_name(COLOURS, COLOUR_COUNT, name);
    if (found >= 0)
        *colour = (ColourMode)found;
    return found >= 0;
}

const char *view_kind_name(ViewKind kind)
{
    return KINDS[kind];
}

const char *colour_mode_name(ColourMode colour)
{
    return COLOURS[colour];
}

bool view_is_framed(const View *view)
{
    return view->kind == VIEW_LOBE || view->kind == VIEW_SCREEN;
}

void pane_frame(const Framing *framing, Orbit *orbit)
{
    orbit->distance /= framing->zoom;
    orbit_pan(orbit, framing->right * framing->zoom, framing->up * framing->zoom);
}

View view_default(const Scene *scene)
{
    return (View){
        .kind = VIEW_POINTS,
        .colour = COLOUR_POWER,
        .orbit = orbit_of_camera(&scene->camera, bvh_bounds(scene->bvh)),
        .framing = FRAMING_DEFAULT,
        .wireframe = true,
        .path = -1,
        .bounce = -1,
        .exponent = 20.0f,
        .angle = 45.0f,
        .surface = -1,
        .level = 8,
        .flight = -1.0,
    };
}

void pane_look_beside(const Pane *pane, const Orbit *orbit, Box box, float right, float down)
{
    float matrix[16];
    orbit_projection(orbit, box, (float)pane->width / (float)pane->height, matrix);
    for (int i = 0; i < 4; i++) {
        matrix[4 * i] += 2.0f * right / (float)pane->width * matrix[4 * i + 3];
        matrix[4 * i + 1] -= 2.0f * down / (float)pane->height * matrix[4 * i + 3];
    }
    canvas_view(pane->canvas, pane->left, pane->top, pane->width, pane->height, matrix);
}

void pane_look(const Pane *pane, const Orbit *orbit, Box box)
{
    pane_look_beside(pane, orbit, box, 0, 0);
}

static void pane_draw(const Pane *pane)
{
    const View *view = pane->view;
    bool in_scene = view->kind != VIEW_LOBE && view->kind != VIEW_SCREEN;
    if (view->wireframe && in_scene)
        wireframe_draw(pane, view->kind == VIEW_TREE ? 0.45f : 0.75f);
    switch (view->kind) {
    case VIEW_POINTS:
        view_points_draw(pane);
        return;
    case VIEW_PATHS:
        view_paths_draw(pane);
        return;
    case VIEW_LOBE:
        view_lobe_draw(pane);
        return;
    case VIEW_SCREEN:
        view_screen_draw(pane);
        return;
    case VIEW_TREE:
        view_tree_draw(pane);
        return;
    }
}

// As large as it fits.
static void draw_picture(Canvas *canvas, const Captions *captions)
{
    float width = (float)canvas_width(canvas), height = (float)canvas_height(canvas);
    float columns = (float)captions->picture_columns, rows = (float)captions->picture_rows;
    float scale = fminf(width / columns, height / rows);
    canvas_picture(canvas, 0.5f * (width - scale * columns), 0.5f * (height - scale * rows), scale * columns,
                   scale * rows, captions->picture, captions->picture_columns, captions->picture_rows);
}

void view_draw(Canvas *canvas, const Scene *scene, const View *view, Side *yours, Side *reference,
               const Captions *captions)
{
    int width = canvas_width(canvas), height = canvas_height(canvas);
    bool split = view->split && reference && !captions->picture;
    int half = width / 2;
    Pane pane = {canvas, scene, view, yours, 0, 0, split ? half : width, height, overlay_scale(canvas)};
    canvas_background(canvas, 7, 9, 14);
    canvas_begin(canvas);
    if (captions->picture && captions->picture_columns > 0 && captions->picture_rows > 0) {
        draw_picture(canvas, captions);
    } else {
        pane_draw(&pane);
        if (split) {
            pane.side = reference;
            pane.left = half;
            pane.width = width - half;
            pane_draw(&pane);
            canvas_rectangle(canvas, (float)half - 1, 0, 2, (float)height, (const uint8_t[4]){110, 120, 140, 255});
        }
    }
    if (!captions->bare)
        overlay_draw(canvas, view, scene, yours, captions);
}
