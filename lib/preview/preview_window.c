// The window's loop: sleep, take what has come, draw when something changed.
#include "preview/app.h"
#include "base/parallel.h"

#include <math.h>
#include <stdio.h>

#define BUSY_WAIT 0.008 // s, while something is on its way
#define IDLE_WAIT 0.03  // s: as late as this a save is noticed

#define REST_SECONDS   0.05 // without a movement: all photons are drawn
#define FLIGHT_SECONDS 8.0  // of slow light across the scene, thrice

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

// The student's question is answered when its photons are on the screen.
static void note_answer(Session *session)
{
    if (!session->after_save || !session->answered)
        return;
    session->after_save = false;
    printf("drawn: %s photons, %.2f s after the save\n", session->coming ? "the first new" : "all new",
           clock_seconds() - session->asked_at);
}

// One turn of the loop.
static void turn(App *app)
{
    bool active = session_is_busy(&app->session) || app->session.runs[RUN_RENDER][YOURS] || app->moving ||
                  app->flying || app->turning;
    if (app->turning)
        glfw.glfwPollEvents();
    else
        glfw.glfwWaitEventsTimeout(active ? BUSY_WAIT : IDLE_WAIT);
    bool news = session_poll(&app->session);
    double now = clock_seconds();
    app->dirty = app->dirty || news;
    if (news && app->session.answered && app->session.after_save) {
        app->moving =
            true; // the answer is wanted soon: a fair part of its photons first, all of them in the next frame
        app->moved_at = now;
    }
    app_turn_by_itself(app, now);
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
    app_note_rest(app, rest);
}

static bool start(App *app, const Scene *scene, const PreviewOptions *options, Broker *broker, Error *error)
{
    app->scene = scene;
    app->view = options->view;
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
