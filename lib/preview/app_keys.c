// What each key does.
#include "base/parallel.h"
#include "preview/app.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

static void photons_times(App *app, double factor)
{
    double photons = (double)app->session.photons * factor;
    app->session.photons = (long)fmin(fmax(photons, 1000.0), 16e6);
    session_ask_photons(&app->session, &app->view);
}

static void save_snapshot(App *app)
{
    Error error = {""};
    char command[2048];
    session_draw(&app->session, app->canvas, &app->view, app->options->bare);
    if (!snapshot_write(app->canvas, app->options->snapshot, &error)) {
        fprintf(stderr, "%s\n", error.message);
        return;
    }
    snapshot_command(app->options, &app->view, &app->session, app->width, app->height, command, sizeof command);
    printf("%s\n    %s\n", app->options->snapshot, command);
    fflush(stdout);
}

// The desktop's own way to open a page; without one, where it lies.
static void open_report(App *app)
{
    const char *report = app->options->report;
    FILE *file = report ? fopen(report, "rb") : NULL;
    if (!file) {
        snprintf(app->session.build, sizeof app->session.build, "no report yet: run `make report`");
        printf("%s\n", app->session.build);
        fflush(stdout);
        return;
    }
    fclose(file);
    pid_t child = fork();
    if (child == 0) {
        execlp("xdg-open", "xdg-open", report, (char *)NULL);
        execlp("open", "open", report, (char *)NULL);
        _exit(127);
    }
    printf("the report: %s\n", report);
    fflush(stdout);
}

// Slow light starts at the lamps, or ends.
static void toggle_flight(App *app)
{
    app->flying = !app->flying;
    app->flight_started = clock_seconds();
    app->view.flight = app->flying ? 0.0 : -1.0;
}

static void choose_kind(App *app, ViewKind kind)
{
    app->view.kind = kind;
    if (app->flying && kind != VIEW_POINTS && kind != VIEW_PATHS)
        toggle_flight(app);
    session_need(&app->session, &app->view);
}

// Which way an arrow changes what the present view chooses: `sideways` by ←/→, otherwise by ↑/↓.
static void choose_within(App *app, bool sideways, int step)
{
    View *view = &app->view;
    const Recording *recording = side_recording(app->session.sides[YOURS]);
    switch (view->kind) {
    case VIEW_PATHS:
        if (sideways) {
            long last = recording->recorded - 1;
            view->path = view->path + step < -1 ? last : view->path + step > last ? -1 : view->path + step;
            view->bounce = -1;
        } else if (view->path >= 0) {
            view->bounce = view->bounce + step < -1 ? -1 : view->bounce + step;
        }
        return;
    case VIEW_LOBE:
        if (sideways)
            view->angle = fminf(fmaxf(view->angle + 5.0f * (float)step, 0.0f), 85.0f);
        else
            view->exponent =
                fminf(fmaxf(step > 0 ? view->exponent * 1.5f + 0.5f : (view->exponent - 0.5f) / 1.5f, 0.0f), 5000.0f);
        session_lobe_changed(&app->session, view);
        return;
    case VIEW_SCREEN:
        if (sideways) {
            int count = (int)app->scene->flat_count;
            view->surface = view->surface + step < -1       ? count - 1
                            : view->surface + step >= count ? -1
                                                            : view->surface + step;
        }
        return;
    case VIEW_TREE:
        if (!sideways)
            view->level = view->level + step < 0 ? 0 : view->level + step > 24 ? 24 : view->level + step;
        return;
    case VIEW_POINTS:
        return;
    }
}

static void toggle_render(App *app)
{
    if (app->session.render)
        session_stop_render(&app->session);
    else if (app->view.kind != VIEW_LOBE)
        session_render(&app->session, &app->view, app->width, app->height);
}

void app_key(App *app, int key)
{
    View *view = &app->view;
    app->dirty = true;
    switch (key) {
    case 'h':
        view->help = !view->help;
        return;
    case '1':
    case '2':
    case '3':
    case '4':
    case '5':
        session_stop_render(&app->session);
        choose_kind(app, (ViewKind)(key - '1'));
        return;
    case 'c':
        view->colour = (ColourMode)((view->colour + 1) % COLOUR_COUNT);
        return;
    case 'b':
        view->split = !view->split;
        session_need(&app->session, view);
        return;
    case 'w':
        view->wireframe = !view->wireframe;
        return;
    case 'd':
        view->diffuse = !view->diffuse;
        session_lobe_changed(&app->session, view);
        return;
    case 'f':
        if (view_is_framed(view))
            view->framing = FRAMING_DEFAULT;
        else
            orbit_frame(&view->orbit, bvh_bounds(app->scene->bvh), (float)app->width / (float)app->height);
        app_moved(app);
        return;
    case '0':
        view->orbit = app->options->view.orbit;
        view->framing = app->options->view.framing;
        app_moved(app);
        return;
    case 'r':
        app->session.seed++;
        session_ask_photons(&app->session, view);
        return;
    case '+':
        photons_times(app, 2.0);
        return;
    case '-':
        photons_times(app, 0.5);
        return;
    case ' ':
        if (view->kind == VIEW_POINTS || view->kind == VIEW_PATHS)
            toggle_flight(app);
        return;
    case 's':
        save_snapshot(app);
        return;
    case 'o':
        open_report(app);
        return;
    case 'p':
        toggle_render(app);
        return;
    case WINDOW_LEFT:
    case WINDOW_RIGHT:
        choose_within(app, true, key == WINDOW_RIGHT ? 1 : -1);
        return;
    case WINDOW_UP:
    case WINDOW_DOWN:
        choose_within(app, false, key == WINDOW_UP ? 1 : -1);
        return;
    case WINDOW_ESCAPE: // closes what is open, before it closes all
        app->quit = !view->help;
        view->help = false;
        return;
    case 'q':
        app->quit = true;
        return;
    default:
        app->dirty = false;
    }
}
