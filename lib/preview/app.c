// The window: what the mouse does, and when to draw. Everything else is the session's; the keys: app_keys.c
#include "preview/app.h"
#include "base/parallel.h"

#include <math.h>
#include <stdio.h>

#define FLIGHT_SECONDS 8.0 // of slow light across the scene, thrice

bool app_start(App *app, const Scene *scene, const PreviewOptions *options, Broker *broker, Window *window,
               Error *error)
{
    *app = (App){.scene = scene, .options = options, .window = window, .view = options->view};
    window_framebuffer_size(window, &app->width, &app->height);
    app->canvas = canvas_create(window_loader(window), app->width, app->height, error);
    if (!app->canvas || !session_start(&app->session, scene, options, broker, app->canvas, error))
        return false;
    app->session.timed = true;
    session_ask_photons(&app->session, &app->view);
    app->dirty = true;
    return true;
}

void app_end(App *app)
{
    if (app->canvas) {
        session_end(&app->session);
        canvas_free(app->canvas);
    }
}

void app_moved(App *app)
{
    app->dirty = true;
    app->moved_at = clock_seconds();
    app->moving = true;
    session_stop_render(&app->session); // it shows another view
}

void app_drag(App *app, int button, bool shift, float right, float down)
{
    View *view = &app->view;
    right /= (float)app->height;
    down /= (float)app->height;
    if (button == 0 && !shift && view->kind != VIEW_SCREEN) {
        orbit_turn(&view->orbit, 4.0f * right, 4.0f * down);
    } else if (view_is_framed(view)) {
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
    if (view_is_framed(view))
        view->framing.zoom = fminf(fmaxf(view->framing.zoom * powf(0.9f, -notches), LEAST_ZOOM), MOST_ZOOM);
    else
        orbit_zoom(&view->orbit, powf(0.9f, notches));
    app_moved(app);
}

void app_resize(App *app)
{
    Error error = {""};
    window_framebuffer_size(app->window, &app->width, &app->height);
    if (app->width > 0 && app->height > 0 && !canvas_resize(app->canvas, app->width, app->height, &error))
        fprintf(stderr, "%s\n", error.message);
    session_stop_render(&app->session);
    app->dirty = true;
}

void app_hurry(App *app, double now)
{
    app->moving = true;
    app->moved_at = now;
}

bool app_is_hurried(const App *app)
{
    return app->moving || app->flying || app->session.coming;
}

double app_light_speed(const App *app)
{
    Box box = bvh_bounds(app->scene->bvh);
    return 3.0 * (double)vec3_length(vec3_sub(box.high, box.low)) / FLIGHT_SECONDS;
}

static size_t points_drawn(const App *app)
{
    size_t count = side_recording(app->session.sides[YOURS])->count;
    return app->moving && count > MOVING_POINTS ? MOVING_POINTS : count;
}

void app_turn_by_itself(App *app, double now)
{
    double seconds = app->options->orbit_seconds;
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
    fflush(stdout);
}

void app_note_rest(App *app, bool all_drawn)
{
    if (!app->wants_rest || !all_drawn)
        return;
    canvas_finish(app->canvas);
    app->wants_rest = false;
    printf("rest: %.2f s until all %zu photons were drawn\n", clock_seconds() - app->moved_at, points_drawn(app));
    fflush(stdout);
}
