// The window's loop: sleep, take what has come, draw when something changed.
#include "preview/app.h"
#include "base/parallel.h"

#include <math.h>
#include <stdio.h>

#define BUSY_WAIT 0.008 // s, while something is on its way
#define IDLE_WAIT 0.03  // s: as late as this a save is noticed

// Keys that go on while they are held; the others would flicker.
static bool is_for_holding(int key)
{
    return key == WINDOW_LEFT || key == WINDOW_RIGHT || key == WINDOW_UP || key == WINDOW_DOWN;
}

static void take_events(App *app)
{
    WindowEvent event;
    while (window_next_event(app->window, &event)) {
        switch (event.type) {
        case WINDOW_EVENT_KEY:
            if (!event.repeat || is_for_holding(event.key))
                app_key(app, event.key);
            break;
        case WINDOW_EVENT_DRAG:
            app_drag(app, event.button, event.shift, event.x, event.y);
            break;
        case WINDOW_EVENT_SCROLL:
            app_scroll(app, event.y);
            break;
        case WINDOW_EVENT_RESIZE:
            app_resize(app);
            break;
        case WINDOW_EVENT_REFRESH:
            app->dirty = true;
            break;
        case WINDOW_EVENT_CLOSE:
            app->quit = true;
            break;
        }
    }
}

// Slow light goes on until the last photon has landed, and starts again.
static void advance_flight(App *app, double now)
{
    if (!app->flying)
        return;
    const Recording *recording = side_recording(app->session.sides[YOURS]);
    double farthest = recording->farthest;
    double flown = (now - app->flight_started) * app_light_speed(app);
    if (flown > farthest + 1.0 * app_light_speed(app))
        app->flight_started = now;
    app->view.flight = fmin(flown, farthest);
    app->dirty = true;
}

static void draw(App *app)
{
    View view = app->view;
    view.most_points = app_is_hurried(app) ? MOVING_POINTS : 0;
    session_draw(&app->session, app->canvas, &view, app->options->bare);
    canvas_present(app->canvas, app->width, app->height);
    window_swap(app->window);
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
    fflush(stdout);
}

// One turn of the loop.
static void turn(App *app)
{
    bool active = session_is_busy(&app->session) || app->session.render || app->moving || app->flying || app->turning;
    window_wait(app->window, app->turning ? 0.0 : active ? BUSY_WAIT : IDLE_WAIT);
    take_events(app);
    bool news = session_poll(&app->session, &app->view);
    double now = clock_seconds();
    app->dirty = app->dirty || news;
    if (news && app->session.answered && app->session.after_save)
        app_hurry(app, now);
    app_turn_by_itself(app, now);
    if (app->moving && now - app->moved_at > REST_SECONDS) {
        app->moving = false;
        app->dirty = true; // all photons
    }
    advance_flight(app, now);
    if (!app->dirty || app->width < 1 || app->height < 1)
        return;
    bool rest = !app_is_hurried(app);
    draw(app);
    note_answer(&app->session);
    app_note_rest(app, rest);
}

bool preview_window(const Scene *scene, const PreviewOptions *options, Broker *broker, bool *no_window, Error *error)
{
    Window *window = window_create("photonlab", options->width, options->height, error);
    *no_window = window == NULL;
    if (!window)
        return false;
    static App app;
    bool ok = app_start(&app, scene, options, broker, window, error);
    while (ok && !app.quit)
        turn(&app);
    app_end(&app);
    window_free(window);
    return ok;
}
