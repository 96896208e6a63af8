// The window's loop: sleep, take what has come, draw when something changed.
#include "preview/app.h"
#include "base/parallel.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define BUSY_WAIT 0.008 // s, while something is on its way
#define IDLE_WAIT 0.03  // s: as late as this a save is noticed

#define MOVING_POINTS  50000 // photons drawn while the camera moves
#define REST_SECONDS   0.05  // without a movement: all photons are drawn
#define FLIGHT_SECONDS 8.0   // of slow light across the scene, thrice

// Slow light goes on until the last photon has landed, and starts again.
static void advance_flight(App *app, double now)
{
    if (!app->flying)
        return;
    double speed = 3.0 * (double)box_diagonal(bvh_bounds(app->scene->bvh)) / FLIGHT_SECONDS; // m/s
    double farthest = view_data_recording(app->session.data[YOURS])->farthest;
    double flown = (now - app->flight_started) * speed;
    if (flown > farthest + 1.0 * speed)
        app->flight_started = now;
    app->view.flight = fmin(flown, farthest);
    app->dirty = true;
}

// A part of the photons has to do, since the camera moves, light flies, or the rest of them is still traced.
static bool is_hurried(const App *app)
{
    return app->moving || app->flying || app->session.coming;
}

static void draw(App *app)
{
    View view = app->view;
    view.most_points = is_hurried(app) ? MOVING_POINTS : 0;
    session_draw(&app->session, &view, app_key_list());
    canvas_present(app->canvas, app->width, app->height);
    glfw.glfwSwapBuffers(app->window);
    app->dirty = false;
    app->frames++;
}

static size_t points_drawn(const App *app)
{
    size_t count = view_data_recording(app->session.data[YOURS])->count;
    return app->moving && count > MOVING_POINTS ? MOVING_POINTS : count;
}

// While --orbit lasts; tells how fast at its end.
static void turn_by_itself(App *app, double now)
{
    double seconds = app->session.options->orbit_seconds;
    if (app->orbit > TURNING || seconds <= 0.0 || session_is_busy(&app->session))
        return;
    if (app->orbit == NOT_TURNED) {
        app->orbit = TURNING;
        app->turning_since = now;
        app->frames = 0;
    }
    orbit_turn(&app->view.orbit, 0.01f, 0.0f);
    app_moved(app);
    if (now - app->turning_since < seconds)
        return;
    app->orbit = TURNED;
    printf("orbit: %.1f frames a second, with %zu photons drawn\n", (double)app->frames / (now - app->turning_since),
           points_drawn(app));
}

// After a frame with all photons, the first that follows --orbit.
static void note_rest(App *app)
{
    if (app->orbit != TURNED)
        return;
    canvas_finish(app->canvas);
    app->orbit = RESTED;
    printf("rest: %.2f s until all %zu photons were drawn\n", clock_seconds() - app->moved_at, points_drawn(app));
}

// The student's question is answered when its photons are on the screen.
static void note_answer(Session *session)
{
    if (!session->after_save || !session->answered)
        return;
    session->after_save = false;
    printf("drawn: %s photons, %.2f s after the save\n", session->coming ? "the first new" : "all new",
           clock_seconds() - session->asked_at);
}

// Another scene, or other contents: who stands where its camera stood goes along with it.
static void take_scene(App *app)
{
    Orbit home = view_default(app->session.scene).orbit;
    if (memcmp(&app->view.orbit, &app->home, sizeof home) == 0 || app->stage != app->session.stage)
        app->view.orbit = home;
    app->home = home;
    app->scene = app->session.scene;
    app->stage = app->session.stage;
    app->dirty = true;
}

// One turn of the loop.
static void turn(App *app)
{
    bool active = session_is_busy(&app->session) || app->session.rendering || app->moving || app->flying;
    if (app->orbit == TURNING)
        glfw.glfwPollEvents();
    else
        glfw.glfwWaitEventsTimeout(active ? BUSY_WAIT : IDLE_WAIT);
    bool news = session_poll(&app->session);
    double now = clock_seconds();
    app->dirty = app->dirty || news;
    if (app->scene != app->session.scene)
        take_scene(app);
    if (news && app->session.answered && app->session.after_save) {
        // The answer is wanted soon: a fair part of its photons first, all of them in the next frame.
        app->moving = true;
        app->moved_at = now;
    }
    turn_by_itself(app, now);
    if (app->moving && now - app->moved_at > REST_SECONDS) {
        app->moving = false;
        app->dirty = true; // all photons
    }
    advance_flight(app, now);
    if (!app->dirty || app->width < 1 || app->height < 1)
        return;
    bool rest = !is_hurried(app);
    draw(app);
    note_answer(&app->session);
    if (rest)
        note_rest(app);
}

static bool start(App *app, const Scene *scene, const PreviewOptions *options, Broker *broker, Error *error)
{
    app->scene = scene;
    app->view = options->view;
    app->home = options->view.orbit;
    app->stage = options->stage;
    app->view.scale = window_scale(app->window);
    glfw.glfwGetFramebufferSize(app->window, &app->width, &app->height);
    app->canvas = canvas_create(window_loader(), app->width, app->height, error);
    if (!app->canvas || !session_start(&app->session, scene, options, &app->view, broker, app->canvas, error))
        return false;
    app->dirty = app->session.timed = true;
    app_listen(app);
    return true;
}

bool preview_window(const Scene *scene, const PreviewOptions *options, Broker *broker, bool *no_window, Error *error)
{
    static App app;
    app.window = window_create("photonlab", options->width, options->height, error);
    *no_window = app.window == NULL;
    if (!app.window)
        return false;
    bool ok = start(&app, scene, options, broker, error);
    while (ok && !app.quit)
        turn(&app);
    session_end(&app.session);
    canvas_free(app.canvas);
    window_free(app.window);
    return ok;
}
