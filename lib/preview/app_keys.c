// What each key does.
#include "preview/app.h"
#include "base/parallel.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

static void other_photons(App *app)
{
    RunRequest *asked = &app->session.asked;
    if (app->key == 'r')
        asked->seed++;
    else
        asked->photons = (long)fmin(fmax((double)asked->photons * (app->key == '+' ? 2.0 : 0.5), 1000.0), 16e6);
    session_ask_photons(&app->session);
}

static void save_snapshot(App *app)
{
    Error error = {""};
    char command[2048];
    const char *path = app->session.options->snapshot;
    session_draw(&app->session, &app->view, app_key_list());
    if (!snapshot_write(app->canvas, path, &error)) {
        fprintf(stderr, "%s\n", error.message);
        return;
    }
    snapshot_command(&app->session, command, sizeof command);
    printf("%s\n    %s\n", path, command);
    snprintf(app->session.build, sizeof app->session.build, "saved: %s", path);
}

// The desktop's own way to open a page; without one, where it lies.
static void open_report(App *app)
{
    const char *report = app->session.options->report;
    if (!report || access(report, R_OK) != 0) {
        snprintf(app->session.build, sizeof app->session.build, "no report yet: run `make report`");
        puts(app->session.build);
        return;
    }
    pid_t child = fork();
    if (child == 0) {
        execlp("xdg-open", "xdg-open", report, (char *)NULL);
        execlp("open", "open", report, (char *)NULL);
        _exit(127);
    }
    printf("the report: %s\n", report);
}

// Slow light starts at the lamps, where the view shows it, or ends.
static void toggle_flight(App *app)
{
    if (!app->flying && !view_type(&app->view)->in_flight)
        return;
    app->flying = !app->flying;
    app->flight_started = clock_seconds();
    app->view.flight = app->flying ? 0.0 : -1.0;
}

static bool choose_view(App *app)
{
    if (app->key < '1' || app->key >= '1' + VIEW_COUNT)
        return false;
    session_stop_render(&app->session);
    app->view.kind = (ViewKind)(app->key - '1');
    if (app->flying && !view_type(&app->view)->in_flight)
        toggle_flight(app);
    return true;
}

// Arrows change what the present view chooses.
static void choose_within(App *app)
{
    bool sideways = app->key == GLFW_KEY_LEFT || app->key == GLFW_KEY_RIGHT;
    int step = app->key == GLFW_KEY_RIGHT || app->key == GLFW_KEY_UP ? 1 : -1;
    if (view_type(&app->view)->choose)
        view_type(&app->view)->choose(&app->view, app->session.data[YOURS], sideways, step);
}

static void toggle_render(App *app)
{
    if (app->session.rendering)
        session_stop_render(&app->session);
    else if (view_type(&app->view)->shows != RUN_LOBE)
        session_render(&app->session);
}

static void change_exposure(App *app)
{
    float stops = app->view.exposure + (app->key == '.' ? 0.5f : -0.5f);
    app->view.exposure = fminf(fmaxf(stops, -MOST_EXPOSURE), MOST_EXPOSURE);
}

static void next_way(App *app)
{
    session_next_way(&app->session);
}

static void next_colour(App *app)
{
    app->view.colour = (ColourMode)((app->view.colour + 1) % COLOUR_COUNT);
}

static void frame_all(App *app)
{
    Area area = view_area(app->canvas, &app->view);
    view_frame(&app->view, app->scene, (float)area.width / (float)area.height);
    app_moved(app);
}

// The picture alone, or words beside it.
static void toggle_panel(App *app)
{
    app->view.panel = app->view.panel > 0.0f ? 0.0f : WIDE_PANEL;
    app_moved(app);
}

static void look_as_at_first(App *app)
{
    app->view.orbit = app->home;
    app->view.framing = app->session.options->view.framing;
    app_moved(app);
}

static void next_step(App *app)
{
    session_show_step(&app->session, coach_next(&app->session.coach));
}

static void hint(App *app)
{
    coach_hint(&app->session.coach);
}

static void quit(App *app)
{
    app->quit = app->key != GLFW_KEY_ESCAPE || !app->view.help; // escape closes what is open, before it closes all
    app->view.help = false;
}

// The switches of all views have keys of their own.
static bool toggle_setting(App *app)
{
    for (int i = 0; i < VIEW_COUNT; i++)
        for (int j = 0; j < MOST_SETTINGS; j++)
            if (view_types[i]->settings[j].key == app->key) {
                app->view.settings[i][j] = app->view.settings[i][j] == 0.0;
                return true;
            }
    return false;
}

static void list_views(char *text, size_t size)
{
    text_append(text, size, "1 to %d\t", VIEW_COUNT);
    for (int i = 0; i < VIEW_COUNT; i++)
        text_append(text, size, "%s%s", i == 0 ? "" : ", ", view_names[i]);
}

static void list_choices(char *text, size_t size)
{
    int count = 0;
    for (int i = 0; i < VIEW_COUNT; i++)
        if (view_types[i]->arrows)
            text_append(text, size, "%s%s: %s",
                        ++count == 1 ? "arrows\t"
                        : count % 2  ? "\n\t"
                                     : ". ",
                        view_names[i], view_types[i]->arrows);
    for (int i = 0; i < VIEW_COUNT; i++)
        for (int j = 0; j < MOST_SETTINGS; j++)
            if (view_types[i]->settings[j].key)
                text_append(text, size, "\n%c\t%s: %s", view_types[i]->settings[j].key, view_names[i],
                            view_types[i]->settings[j].words);
}

// All keys but the views' own, in the order of the list; what the views add to it is listed by a function.
static const struct {
    const char *shown, *words;
    void (*act)(App *app);
    size_t toggle; // or what it turns on and off: a bool of the App
    int keys[4];
    bool held; // goes on while it is held; the others would flicker
    void (*list)(char *text, size_t size);
} KEYS[] = {
    {"n", "the next step that is not right; a click on a step goes to it", next_step, .keys = {'n'}},
    {"?", "a hint for this step, each tells more", hint, .keys = {'?'}},
    {.list = list_views},
    {"c", "colour by power, photon, bounce, material", next_colour, .keys = {'c'}},
    {"b", "the reference beside yours", .toggle = offsetof(App, view.split), .keys = {'b'}},
    {.act = choose_within,
     .keys = {GLFW_KEY_LEFT, GLFW_KEY_RIGHT, GLFW_KEY_UP, GLFW_KEY_DOWN},
     .held = true,
     .list = list_choices},
    {"mouse", "left: turn. right: move. wheel: near, far", NULL, .keys = {0}},
    {"f", "frame the scene", frame_all, .keys = {'f'}},
    {"0", "the scene's camera", look_as_at_first, .keys = {'0'}},
    {"space", "slow light: photons in order of flight", toggle_flight, .keys = {' '}},
    {"+ -", "more, fewer photons", other_photons, .keys = {'+', '-'}},
    {"r", "another seed", other_photons, .keys = {'r'}},
    {"t", "the panel, on and off", toggle_panel, .keys = {'t'}},
    {"p", "render what you see, by your code, or end that", toggle_render, .keys = {'p'}},
    {"i", "render another way: from photons, gathered, by passes", next_way, .keys = {'i'}},
    {"w", "the scene's edges, on and off", .toggle = offsetof(App, view.wireframe), .keys = {'w'}},
    {"s", "save what you see as a picture", save_snapshot, .keys = {'s'}},
    {"o", "open the last report", open_report, .keys = {'o'}},
    {", .", "darker, brighter", change_exposure, .keys = {',', '.'}, .held = true},
    {"h", "this list", .toggle = offsetof(App, view.help), .keys = {'h'}},
    {"q, esc", "quit", quit, .keys = {'q', GLFW_KEY_ESCAPE}},
};
enum { KEY_COUNT = sizeof KEYS / sizeof *KEYS };

const char *app_key_list(void)
{
    static char text[2000];
    if (text[0])
        return text;
    for (int i = 0; i < KEY_COUNT; i++) {
        text_append(text, sizeof text, "%s", i > 0 ? "\n" : "");
        if (KEYS[i].list)
            KEYS[i].list(text, sizeof text);
        else
            text_append(text, sizeof text, "%s\t%s", KEYS[i].shown, KEYS[i].words);
    }
    return text;
}

static bool act(App *app)
{
    for (int i = 0; i < KEY_COUNT; i++)
        for (int j = 0; j < 4; j++)
            if (KEYS[i].keys[j] == app->key && (KEYS[i].act || KEYS[i].toggle) && (!app->repeat || KEYS[i].held)) {
                if (KEYS[i].act)
                    KEYS[i].act(app);
                else
                    *(bool *)((char *)app + KEYS[i].toggle) ^= true;
                return true;
            }
    return !app->repeat && (choose_view(app) || toggle_setting(app));
}

void app_key(App *app, int key)
{
    app->key = key;
    app->dirty |= act(app);
}
