// What the mouse does, and turning without it. The keys: app_keys.c; the loop: preview_window.c.
#include "preview/app.h"
#include "base/parallel.h"

#include <math.h>
#include <stdio.h>

void app_moved(App *app)
{
    app->dirty = true;
    app->moved_at = clock_seconds();
    app->moving = true;
    session_stop_render(&app->session); // it shows another view
}

void app_drag(App *app, float right, float down)
{
    View *view = &app->view;
    right /= (float)app->height;
    down /= (float)app->height;
    if (app->button == 0 && !app->drag_shift && view_type(view)->place != ON_A_SHEET) {
        orbit_turn(&view->orbit, 4.0f * right, 4.0f * down);
    } else if (view_type(view)->place != IN_THE_SCENE) {
        view->framing.right -= right / view->framing.zoom;
        view->framing.up += down / view->framing.zoom;
    } else {
        orbit_pan(&view->orbit, -right, down);
    }
    app_moved(app);
}

void app_scroll(App *app, float notches)
{
    View *view = &app->view;
    if (view_type(view)->place != IN_THE_SCENE)
        view->framing.zoom = fminf(fmaxf(view->framing.zoom * powf(0.9f, -notches), LEAST_ZOOM), MOST_ZOOM);
    else
        orbit_zoom(&view->orbit, powf(0.9f, notches));
    app_moved(app);
}

void app_resize(App *app, int width, int height)
{
    Error error = {""};
    app->width = width;
    app->height = height;
    if (width > 0 && height > 0 && !canvas_resize(app->canvas, width, height, &error))
        fprintf(stderr, "%s\n", error.message);
    session_stop_render(&app->session);
    app->dirty = true;
}

static size_t points_drawn(const App *app)
{
    size_t count = view_data_recording(app->session.data[YOURS])->count;
    return app->moving && count > MOVING_POINTS ? MOVING_POINTS : count;
}

void app_turn_by_itself(App *app, double now)
{
    double seconds = app->session.options->orbit_seconds;
    if (app->wants_rest || seconds <= 0.0 || app->orbit_done || session_is_busy(&app->session))
        return;
    if (!app->turning) {
        app->turning = true;
        app->turning_since = now;
        app->frames_at_start = app->frames;
    }
    orbit_turn(&app->view.orbit, 0.01f, 0.0f);
    app_moved(app);
    if (now - app->turning_since < seconds)
        return;
    app->turning = false;
    app->orbit_done = app->wants_rest = true;
    printf("orbit: %.1f frames a second, with %zu photons drawn\n",
           (double)(app->frames - app->frames_at_start) / (now - app->turning_since), points_drawn(app));
}

void app_note_rest(App *app, bool all_drawn)
{
    if (!app->wants_rest || !all_drawn)
        return;
    canvas_finish(app->canvas);
    app->wants_rest = false;
    printf("rest: %.2f s until all %zu photons were drawn\n", clock_seconds() - app->moved_at, points_drawn(app));
}
