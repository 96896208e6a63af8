// The list of views, and what drawing each of them begins and ends with.
#include "preview/view/view_internal.h"

#include <string.h>

#define VIEW(kind, name) extern const ViewType view_##name;
#include "preview/view/views.def"
#undef VIEW
#define VIEW(kind, name) [VIEW_##kind] = &view_##name,
const ViewType *const view_types[VIEW_COUNT] = {
#include "preview/view/views.def"
};
#undef VIEW

const char *const view_names[VIEW_COUNT + 1] = {
#define VIEW(kind, name) #name,
#include "preview/view/views.def"
#undef VIEW
};

const char *const colour_names[COLOUR_COUNT + 1] = {"power", "photon", "bounce", "material"};

View view_default(const Scene *scene)
{
    View view = {
        .orbit = orbit_of_camera(&scene->camera, bvh_bounds(scene->bvh)),
        .framing = FRAMING_DEFAULT,
        .wireframe = true,
        .flight = -1.0,
    };
    for (int i = 0; i < VIEW_COUNT; i++)
        for (int j = 0; j < MOST_SETTINGS; j++)
            view.settings[i][j] = view_types[i]->settings[j].start;
    return view;
}

const char *whose_step(const ViewData *data, const char *id)
{
    StepState state = data->recording.states[step_find(id) - step_table];
    return state == STEP_STUDENT       ? ", yours"
           : state == STEP_NOT_STARTED ? ", the reference's"
                                       : ""; // nobody else is there
}

void view_move(View *view, float right, float down)
{
    if (view_type(view)->place == IN_THE_SCENE) {
        orbit_pan(&view->orbit, -right, down);
        return;
    }
    view->framing.right -= right / view->framing.zoom;
    view->framing.up += down / view->framing.zoom;
}

void view_turn(View *view, float right, float down)
{
    if (view_type(view)->place == ON_A_SHEET)
        view_move(view, right, down);
    else
        orbit_turn(&view->orbit, 4.0f * right, 4.0f * down);
}

void view_zoom(View *view, float factor)
{
    if (view_type(view)->place == IN_THE_SCENE)
        orbit_zoom(&view->orbit, factor);
    else
        view->framing.zoom = fminf(fmaxf(view->framing.zoom / factor, LEAST_ZOOM), MOST_ZOOM);
}

void view_frame(View *view, const Scene *scene, float aspect)
{
    if (view_type(view)->place == IN_THE_SCENE)
        orbit_frame(&view->orbit, bvh_bounds(scene->bvh), aspect);
    else
        view->framing = FRAMING_DEFAULT;
}

double wrap(double value, double low, double high)
{
    if (value < low)
        return high;
    return value > high ? low : value;
}

void pane_frame(const Framing *framing, Orbit *orbit)
{
    orbit->distance /= framing->zoom;
    orbit_pan(orbit, framing->right * framing->zoom, framing->up * framing->zoom);
}

void pane_look(const Pane *pane, const Orbit *orbit, Box box, float right, float down)
{
    float matrix[16];
    orbit_projection(orbit, box, (float)pane->width / (float)pane->height, matrix);
    for (int i = 0; i < 4; i++) {
        matrix[4 * i] += 2.0f * right / (float)pane->width * matrix[4 * i + 3];
        matrix[4 * i + 1] -= 2.0f * down / (float)pane->height * matrix[4 * i + 3];
    }
    canvas_view(pane->data->canvas, pane->left, 0, pane->width, pane->height, matrix);
}

void pane_look_at_scene(const Pane *pane)
{
    pane_look(pane, &pane->view->orbit, bvh_bounds(pane->data->scene->bvh), 0, 0);
}

float pane_look_at_sheet(const Pane *pane, Box box)
{
    Orbit orbit = {.vertical_fov = 20.0f};
    orbit_frame(&orbit, box, (float)pane->width / (float)pane->height);
    orbit.distance *= 1.25f; // the words stand around it
    pane_frame(&pane->view->framing, &orbit);
    pane_look(pane, &orbit, box, 0, 0);
    return (box.high.y - box.low.y) / (2.0f * orbit.distance * tanf(10.0f * PI / 180.0f)) * (float)pane->height;
}

void pane_draw(const Pane *pane, int list, DrawStyle style)
{
    const VertexBuffer *buffer = &pane->data->made[pane->view->kind].lists[list];
    vertex_buffer_draw(pane->data->canvas, buffer, 0, buffer->count, &style);
}

// Makes the view's vertices, unless there are some of the same data and choices. Colours are those of
// views of photons; the time is that of views of photons in flight.
static void make(const View *view, ViewData *data)
{
    const ViewType *type = view_type(view);
    Made *made = &data->made[view->kind];
    double key[5 + MOST_SETTINGS] = {1 + data->come[type->shows], data->recording.play.glossy};
    if (type->shows == RUN_PHOTONS)
        key[2] = view->colour;
    if (type->in_flight) {
        key[3] = view->flight;
        key[4] = view->flight < 0.0 ? 0.0 : (double)view->most_points;
    }
    memcpy(key + 5, view->settings[view->kind], sizeof view->settings[view->kind]);
    if (memcmp(key, made->key, sizeof key) == 0)
        return;
    memcpy(made->key, key, sizeof key);
    Vertices lists[MOST_LISTS] = {{.items = NULL}};
    type->build(view, data, lists);
    for (int i = 0; i < MOST_LISTS; i++)
        vertices_upload(&lists[i], data->canvas, &made->lists[i]);
}

// As large as it fits.
static void draw_picture(const Pane *pane, const Picture *picture)
{
    float columns = (float)picture->columns, rows = (float)picture->rows;
    float scale = fminf((float)pane->width / columns, (float)pane->height / rows);
    int across = (int)(scale * columns + 0.5f), down = (int)(scale * rows + 0.5f);
    canvas_picture(pane->data->canvas, pane->left + (pane->width - across) / 2, (pane->height - down) / 2, across, down,
                   picture->rgba, picture->columns, picture->rows);
}

static void draw_half(const Pane *pane, const Picture *picture)
{
    const ViewType *type = view_type(pane->view);
    if (picture->rgba && picture->columns > 0 && picture->rows > 0) {
        draw_picture(pane, picture);
        return;
    }
    if (pane->view->wireframe && type->place == IN_THE_SCENE)
        wireframe_draw(pane, type->wires);
    make(pane->view, pane->data);
    type->draw(pane);
}

// Pixels that words and points have to fit into.
static float least_side(const Canvas *canvas)
{
    return fminf((float)canvas_height(canvas), 0.6f * (float)canvas_width(canvas));
}

float view_scale(const Canvas *canvas, const View *view)
{
    return view->scale > 0.0f ? view->scale : fminf(fmaxf(least_side(canvas) / 640.0f, 0.7f), 3.0f);
}

Area view_area(const Canvas *canvas, const View *view)
{
    int width = canvas_width(canvas);
    float panel = fminf(view->panel * EM * view_scale(canvas, view), 0.36f * (float)width);
    return (Area){width - (int)panel, canvas_height(canvas)};
}

void view_draw(Canvas *canvas, const View *view, ViewData *yours, ViewData *reference, const Captions *captions)
{
    Area area = view_area(canvas, view);
    bool split = view->split && reference;
    float side = least_side(canvas);
    float scale = side < 640.0f ? 1.0f : side < 1300.0f ? 2.0f : 3.0f; // whole: points stay even
    Pane pane = {view, yours, 0, split ? area.width / 2 : area.width, area.height, scale};
    canvas_begin(canvas, (Rgba){7, 9, 14, 255});
    draw_half(&pane, &captions->pictures[0]);
    if (split) {
        pane.data = reference;
        pane.left = pane.width;
        pane.width = area.width - pane.left;
        draw_half(&pane, &captions->pictures[1]);
        canvas_rectangle(canvas, (float)pane.left - 1, 0, 2, (float)area.height, (Rgba){110, 120, 140, 255});
    }
    if (view->panel > 0.0f)
        overlay_draw(canvas, view, yours, captions);
}
