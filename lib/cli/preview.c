#include "cli/cli.h"
#include "base/text.h"
#include "preview/preview.h"

#include <stdio.h>
#include <string.h>

static const char help_begin[] =
    "usage: photonlab preview SCENE [flags]\n"
    "\n"
    "Opens a window on the photons of a scene; the key h lists what can be done there. With --snapshot it writes that picture\n"
    "and needs no display.\n"
    "\n"
    "  --snapshot FILE.png  where to; in the window: where the key `s` writes (build/preview.png)\n"
    "  --every-save         without a display: the snapshot anew after every save\n";
// Between them: the views.
static const char help_end[] =
    "  --colour NAME        power, photon, bounce or material\n"
    "  --split              the reference beside it\n"
    "  --camera PX,PY,PZ,TX,TY,TZ   from where and to where; --frame: all of the scene\n"
    "  --framing ZOOM,RIGHT,UP      of the lobe and the screen: so many times nearer, and so far to the side, in heights\n"
    "                               of the picture\n"
    "  --exposure STOPS     photons and pictures brighter, or darker: one more is twice as bright\n"
    "  --flight M           only what has flown no farther than M metres\n"
    "  --size WxH           pixels (1280x720)\n"
    "  --photons N          to emit (200000)\n"
    "  --paths N            paths that are kept as lines (1000)\n"
    "  --depth N, --seed S  as in `photonlab photons`\n"
    "  --steps LIST         2.3 or 2.4 for glossy surfaces, 1.5, 3.4 or 6.4 for the photon's life\n"
    "  --spectral           photons of single wavelengths, as step 6.4 has them\n"
    "  --render N           the picture that the key `p` renders, after N passes; in a snapshot\n"
    "  --integrator NAME    … by photons, photons-only, gather or path (as the scene says)\n"
    "  --radii NAME         … where its passes look for photons: alike (by k), pass or pixel, which shrink as in stage 5\n"
    "  --bare               no text in the picture; --no-wireframe: no lines of the scene\n"
    "  --context NAME       what draws a snapshot: osmesa, egl, or window, a hidden one (the first that is there)\n"
    "  --code DIR           play the steps built in DIR\n"
    "  --photons-file FILE  nobody plays: these photons, which `make report` left in build/test/scatter_1/; with\n"
    "                       --reference-file FILE those beside them. Needs --snapshot\n"
    "  --watch DIR --build COMMAND   after each save below DIR: sh -c COMMAND sh SOURCE.c OBJECT.so, and new photons\n"
    "  --judge COMMAND      … and sh -c COMMAND sh ID, whose verdict of the step stands in the panel\n"
    "  --stage N            begin with a step of this stage, and go on to other stages' scenes with their steps\n"
    "  --stages N           the course has the first N stages; the panel leaves out the others\n"
    "  --report FILE        what the key `o` opens\n"
    "  --orbit SECONDS      the window turns by itself for so long, and tells how many frames a second it made\n";

typedef struct {
    const char *scene, *camera, *framing, *steps;
    Choice view, colour, context, integrator, radii;
    int size[2];
    bool frame, no_wireframe, split, bare;
    float flight, exposure;
    double settings[VIEW_COUNT][MOST_SETTINGS];
    PreviewOptions options;
} Arguments;

// The help, with the views and their flags, a line or more each.
static void list_flags(char *text, size_t size)
{
    const char *flag = "  --view NAME";
    snprintf(text, size, "%s", help_begin);
    for (int i = 0; i < VIEW_COUNT; i++) {
        const char *name = view_names[i];
        for (const char *line = view_types[i]->help; *line; line += strcspn(line, "\n") + 1) {
            text_append(text, size, "%-23s%-8s %.*s\n", flag, name, (int)strcspn(line, "\n"), line);
            flag = name = "";
        }
    }
    text_append(text, size, "%s", help_end);
}

// The flags of all views' settings; returns how many there are then.
static int add_settings(Arguments *a, Flag *flags, int count)
{
    static const FlagKind KINDS[] = {
        [SETTING_WHOLE] = FLAG_WHOLE, [SETTING_NUMBER] = FLAG_NUMBER, [SETTING_SWITCH] = FLAG_ON};
    for (int i = 0; i < VIEW_COUNT; i++)
        for (int j = 0; j < MOST_SETTINGS && view_types[i]->settings[j].flag && count < MOST_FLAGS; j++) {
            const ViewSetting *setting = &view_types[i]->settings[j];
            a->settings[i][j] = setting->start;
            flags[count++] =
                (Flag){setting->flag, KINDS[setting->kind], &a->settings[i][j], setting->low, setting->high};
        }
    return count;
}

// What no flag alone can tell.
static bool check(Arguments *a)
{
    PreviewOptions *options = &a->options;
    Error error = {""};
    options->width = a->size[0];
    options->height = a->size[1];
    int context = 1 + a->context.chosen;
    options->in_window = context > CONTEXT_EGL;
    options->context = options->in_window ? CONTEXT_ANY : (ContextKind)context;
    options->integrator = a->integrator.chosen;
    options->radii = (RadiiRule)a->radii.chosen;
    if (options->render > 0 && !options->snapshot)
        error_set(&error, "--render: needs --snapshot; in the window the key `p` renders");
    if (a->steps)
        options->play_is_given = step_choice_parse(a->steps, &options->play, &error);
    if (options->snapshot)
        image_path_is_known(options->snapshot, &error);
    if (options->every_save && (!options->snapshot || !options->source))
        error_set(&error, "--every-save: needs --snapshot, --watch and --build");
    if (options->given[0] && (!options->snapshot || options->source))
        error_set(&error, "--photons-file: needs --snapshot, and goes without --watch");
    if (options->given[1] && !options->given[0])
        error_set(&error, "--reference-file: needs --photons-file");
    if (options->source && (!options->build || !options->code))
        error_set(&error, "--watch: needs --build and --code");
    if (error.message[0])
        report_usage("photonlab preview", "%s", error.message);
    return !error.message[0];
}

// 0 when the arguments are right, otherwise the exit code or HELP_SHOWN.
static int parse(int count, char **arguments, Arguments *a)
{
    static const char *const CONTEXTS[] = {"osmesa", "egl", "window", NULL}; // as ContextKind has them, after any
    *a = (Arguments){.view = {view_names, 0},
                     .colour = {colour_names, 0},
                     .context = {CONTEXTS, -1},
                     .integrator = {integrator_names, -1},
                     .radii = {radii_rules, RADII_ALIKE},
                     .size = {1280, 720},
                     .flight = -1};
    a->options = (PreviewOptions){.photons = 200000, .recorded = 1000, .seed = 1};
    PreviewOptions *o = &a->options;
    Flag flags[MOST_FLAGS] = {
        {"snapshot", FLAG_TEXT, &o->snapshot, 0, 0},
        {"every-save", FLAG_PRESENT, &o->every_save, 0, 0},
        {"view", FLAG_CHOICE, &a->view, 0, 0},
        {"colour", FLAG_CHOICE, &a->colour, 0, 0},
        {"split", FLAG_PRESENT, &a->split, 0, 0},
        {"camera", FLAG_TEXT, &a->camera, 0, 0},
        {"framing", FLAG_TEXT, &a->framing, 0, 0},
        {"frame", FLAG_PRESENT, &a->frame, 0, 0},
        {"exposure", FLAG_FLOAT, &a->exposure, (double)-MOST_EXPOSURE, (double)MOST_EXPOSURE},
        {"flight", FLAG_FLOAT, &a->flight, 0, 1e30},
        {"size", FLAG_SIZE, a->size, 64, MOST_SIDE},
        {"photons", FLAG_LONG, &o->photons, 1, 100000000},
        {"paths", FLAG_LONG, &o->recorded, 0, 1000000},
        {"depth", FLAG_INT, &o->depth, 1, MOST_DEPTH},
        {"seed", FLAG_SEED, &o->seed, 0, 0},
        {"steps", FLAG_TEXT, &a->steps, 0, 0},
        {"spectral", FLAG_PRESENT, &o->spectral, 0, 0},
        {"render", FLAG_INT, &o->render, 1, 1000000},
        {"integrator", FLAG_CHOICE, &a->integrator, 0, 0},
        {"radii", FLAG_CHOICE, &a->radii, 0, 0},
        {"bare", FLAG_PRESENT, &a->bare, 0, 0},
        {"no-wireframe", FLAG_PRESENT, &a->no_wireframe, 0, 0},
        {"context", FLAG_CHOICE, &a->context, 0, 0},
        {"code", FLAG_TEXT, &o->code, 0, 0},
        {"photons-file", FLAG_TEXT, &o->given[0], 0, 0},
        {"reference-file", FLAG_TEXT, &o->given[1], 0, 0},
        {"watch", FLAG_TEXT, &o->source, 0, 0},
        {"build", FLAG_TEXT, &o->build, 0, 0},
        {"stage", FLAG_INT, &o->stage, 1, STAGE_COUNT},
        {"stages", FLAG_INT, &o->stages, 1, STAGE_COUNT},
        {"judge", FLAG_TEXT, &o->judge, 0, 0},
        {"report", FLAG_TEXT, &o->report, 0, 0},
        {"orbit", FLAG_FLOAT, &o->orbit_seconds, 0, 3600},
    };
    int flag_count = 0;
    while (flags[flag_count].name)
        flag_count++;
    flag_count = add_settings(a, flags, flag_count);
    char help[6000];
    list_flags(help, sizeof help);
    int wrong = command_line_parse(&(CommandLine){"photonlab preview", help, "one scene file", flags, flag_count, 1, 1},
                                   count, arguments, &a->scene);
    return wrong ? wrong : check(a) ? 0 : EXIT_USAGE;
}

// Pictures, and no window.
static bool is_still(const PreviewOptions *options)
{
    return options->every_save || (options->snapshot && !options->source);
}

// What the flags say about the view, over what the scene suggests.
static bool set_view(const Arguments *a, const Scene *scene, View *view, Error *error)
{
    *view = view_default(scene);
    view->kind = (ViewKind)a->view.chosen;
    view->colour = (ColourMode)a->colour.chosen;
    view->split = a->split || a->options.given[1];
    view->wireframe = !a->no_wireframe;
    view->flight = (double)a->flight;
    view->exposure = a->exposure;
    view->panel = a->bare ? 0.0f : is_still(&a->options) ? NARROW_PANEL : WIDE_PANEL;
    memcpy(view->settings, a->settings, sizeof view->settings);
    Vec3 p, t;
    char after;
    if (a->camera && sscanf(a->camera, "%f,%f,%f,%f,%f,%f%c", &p.x, &p.y, &p.z, &t.x, &t.y, &t.z, &after) != 6)
        return error_set(error, "--camera %s: expected six numbers, PX,PY,PZ,TX,TY,TZ", a->camera);
    if (a->camera && !isfinite(vec3_dot(p, p) + vec3_dot(t, t)))
        return error_set(error, "--camera %s: expected numbers that are not too large", a->camera);
    if (a->camera)
        view->orbit = orbit_look(p, t, view->orbit.vertical_fov);
    Framing *f = &view->framing;
    if (a->framing && (sscanf(a->framing, "%f,%f,%f%c", &f->zoom, &f->right, &f->up, &after) != 3 ||
                       !(f->zoom >= LEAST_ZOOM && f->zoom <= MOST_ZOOM && isfinite(f->right) && isfinite(f->up))))
        return error_set(error, "--framing %s: expected ZOOM,RIGHT,UP, e.g. 2,0.3,0", a->framing);
    if (a->frame)
        orbit_frame(&view->orbit, bvh_bounds(scene->bvh), (float)a->options.width / (float)a->options.height);
    return true;
}

static bool show(const Scene *scene, const Arguments *a, Broker *broker, Error *error)
{
    PreviewOptions options = a->options;
    if (is_still(&options))
        return preview_snapshot(scene, &options, broker, error);
    bool no_window = false;
    if (!options.snapshot)
        options.snapshot = "build/preview.png";
    if (preview_window(scene, &options, broker, &no_window, error))
        return true;
    if (!no_window || !options.source)
        return false;
    printf("no window: %s\n%s is written anew on every save instead; ctrl-c ends it\n", error->message,
           options.snapshot);
    *error = (Error){""};
    options.every_save = true;
    return preview_snapshot(scene, &options, broker, error);
}

int command_preview(int count, char **arguments)
{
    Arguments a;
    int wrong = parse(count, arguments, &a);
    if (wrong)
        return wrong == HELP_SHOWN ? 0 : wrong;
    Error error = {""};
    parallel_limit(1); // no threads before the fork
    Scene *scene = scene_load(a.scene, &error);
    if (!scene)
        return report_error(&error);
    a.options.scene_path = a.scene;
    if (!set_view(&a, scene, &a.options.view, &error)) {
        scene_free(scene);
        return report_usage("photonlab preview", "%s", error.message);
    }
    Broker *broker = a.options.given[0] ? NULL : broker_start(scene, a.options.source, &error);
    parallel_limit(0);
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ); // what happens is told when it happens, through a pipe, too
    bool ok = (broker || a.options.given[0]) && show(scene, &a, broker, &error);
    broker_stop(broker);
    scene_free(scene);
    return ok ? 0 : report_error(&error);
}
