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

static const char *camera, *framing, *steps_text;
static const char *const contexts[] = {"osmesa", "egl", "window", NULL}; // as ContextKind has them, after any
static Choice kind = {view_names, 0}, colours = {colour_names, 0}, context = {contexts, -1},
              integrator = {integrator_names, -1}, radii = {radii_rules, RADII_ALIKE};
static int size[2] = {1280, 720};
static bool frame, no_wireframe, bare;
static PreviewOptions options = {.photons = 200000, .recorded = 1000, .seed = 1, .view = {.flight = -1.0}};
static Flag flags[MOST_FLAGS] = {
    {"snapshot", FLAG_TEXT, &options.snapshot, 0, 0},
    {"every-save", FLAG_PRESENT, &options.every_save, 0, 0},
    {"view", FLAG_CHOICE, &kind, 0, 0},
    {"colour", FLAG_CHOICE, &colours, 0, 0},
    {"split", FLAG_PRESENT, &options.view.split, 0, 0},
    {"camera", FLAG_TEXT, &camera, 0, 0},
    {"framing", FLAG_TEXT, &framing, 0, 0},
    {"frame", FLAG_PRESENT, &frame, 0, 0},
    {"exposure", FLAG_FLOAT, &options.view.exposure, (double)-MOST_EXPOSURE, (double)MOST_EXPOSURE},
    {"flight", FLAG_NUMBER, &options.view.flight, 0, 1e30},
    {"size", FLAG_SIZE, size, 64, MOST_SIDE},
    {"photons", FLAG_LONG, &options.photons, 1, 100000000},
    {"paths", FLAG_LONG, &options.recorded, 0, 1000000},
    {"depth", FLAG_INT, &options.depth, 1, MOST_DEPTH},
    {"seed", FLAG_SEED, &options.seed, 0, 0},
    {"steps", FLAG_TEXT, &steps_text, 0, 0},
    {"spectral", FLAG_PRESENT, &options.spectral, 0, 0},
    {"render", FLAG_INT, &options.render, 1, 1000000},
    {"integrator", FLAG_CHOICE, &integrator, 0, 0},
    {"radii", FLAG_CHOICE, &radii, 0, 0},
    {"bare", FLAG_PRESENT, &bare, 0, 0},
    {"no-wireframe", FLAG_PRESENT, &no_wireframe, 0, 0},
    {"context", FLAG_CHOICE, &context, 0, 0},
    {"code", FLAG_TEXT, &options.code, 0, 0},
    {"photons-file", FLAG_TEXT, &options.given[0], 0, 0},
    {"reference-file", FLAG_TEXT, &options.given[1], 0, 0},
    {"watch", FLAG_TEXT, &options.source, 0, 0},
    {"build", FLAG_TEXT, &options.build, 0, 0},
    {"stage", FLAG_INT, &options.stage, 1, STAGE_COUNT},
    {"stages", FLAG_INT, &options.stages, 1, STAGE_COUNT},
    {"judge", FLAG_TEXT, &options.judge, 0, 0},
    {"report", FLAG_TEXT, &options.report, 0, 0},
    {"orbit", FLAG_FLOAT, &options.orbit_seconds, 0, 3600},
};
static char help[6000];

// The help and the flags, with those of the views.
static bool prepare(void)
{
    static const FlagKind KINDS[] = {
        [SETTING_WHOLE] = FLAG_WHOLE, [SETTING_NUMBER] = FLAG_NUMBER, [SETTING_SWITCH] = FLAG_ON};
    const char *flag = "  --view NAME";
    Flag *next = flags;
    while (next->name)
        next++;
    text_append(help, sizeof help, "%s", help_begin);
    for (int i = 0; i < VIEW_COUNT; i++) {
        const char *name = view_names[i];
        for (const char *line = view_types[i]->help; *line; line += strcspn(line, "\n") + 1) {
            text_append(help, sizeof help, "%-23s%-8s %.*s\n", flag, name, (int)strcspn(line, "\n"), line);
            flag = name = "";
        }
        for (int j = 0; j < MOST_SETTINGS && view_types[i]->settings[j].flag && next < flags + MOST_FLAGS; j++) {
            const ViewSetting *setting = &view_types[i]->settings[j];
            double *value = &options.view.settings[i][j];
            *value = setting->start;
            *next++ = (Flag){setting->flag, KINDS[setting->kind], value, setting->low, setting->high};
        }
    }
    text_append(help, sizeof help, "%s", help_end);
    return true;
}

// What no flag alone can tell.
static bool check(Error *error)
{
    int wanted = 1 + context.chosen;
    options.width = size[0];
    options.height = size[1];
    options.in_window = wanted > CONTEXT_EGL;
    options.context = options.in_window ? CONTEXT_ANY : (ContextKind)wanted;
    options.integrator = integrator.chosen;
    options.radii = (RadiiRule)radii.chosen;
    if (options.render > 0 && !options.snapshot)
        error_set(error, "--render: needs --snapshot; in the window the key `p` renders");
    if (steps_text)
        options.play_is_given = step_choice_parse(steps_text, &options.play, error);
    if (options.snapshot)
        image_path_is_known(options.snapshot, error);
    if (options.every_save && (!options.snapshot || !options.source))
        error_set(error, "--every-save: needs --snapshot, --watch and --build");
    if (options.given[0] && (!options.snapshot || options.source))
        error_set(error, "--photons-file: needs --snapshot, and goes without --watch");
    if (options.given[1] && !options.given[0])
        error_set(error, "--reference-file: needs --photons-file");
    if (options.source && (!options.build || !options.code))
        error_set(error, "--watch: needs --build and --code");
    return !error->message[0];
}

// Pictures, and no window.
static bool is_still(void)
{
    return options.every_save || (options.snapshot && !options.source);
}

// What the flags say about the view, over what the scene suggests.
static bool set_view(const Scene *scene, Error *error)
{
    View *view = &options.view, usual = view_default(scene);
    view->orbit = usual.orbit;
    view->framing = usual.framing;
    view->kind = (ViewKind)kind.chosen;
    view->colour = (ColourMode)colours.chosen;
    view->split = view->split || options.given[1];
    view->wireframe = !no_wireframe;
    view->panel = bare ? 0.0f : is_still() ? NARROW_PANEL : WIDE_PANEL;
    Vec3 p, t;
    char after;
    if (camera && sscanf(camera, "%f,%f,%f,%f,%f,%f%c", &p.x, &p.y, &p.z, &t.x, &t.y, &t.z, &after) != 6)
        return error_set(error, "--camera %s: expected six numbers, PX,PY,PZ,TX,TY,TZ", camera);
    if (camera && !isfinite(vec3_dot(p, p) + vec3_dot(t, t)))
        return error_set(error, "--camera %s: expected numbers that are not too large", camera);
    if (camera)
        view->orbit = orbit_look(p, t, view->orbit.vertical_fov);
    Framing *f = &view->framing;
    if (framing && (sscanf(framing, "%f,%f,%f%c", &f->zoom, &f->right, &f->up, &after) != 3 ||
                    !(f->zoom >= LEAST_ZOOM && f->zoom <= MOST_ZOOM && isfinite(f->right) && isfinite(f->up))))
        return error_set(error, "--framing %s: expected ZOOM,RIGHT,UP, e.g. 2,0.3,0", framing);
    if (frame)
        orbit_frame(&view->orbit, bvh_bounds(scene->bvh), (float)options.width / (float)options.height);
    return true;
}

static bool show(const Scene *scene, Broker *broker, Error *error)
{
    if (is_still())
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

static int run(void)
{
    Error error = {""};
    if (!check(&error))
        return report_usage("photonlab preview", "%s", error.message);
    parallel_limit(1); // no threads before the fork
    Scene *scene = scene_load(options.scene_path, &error);
    if (!scene)
        return report_error(&error);
    if (!set_view(scene, &error)) {
        scene_free(scene);
        return report_usage("photonlab preview", "%s", error.message);
    }
    Broker *broker = options.given[0] ? NULL : broker_start(scene, options.source, &error);
    parallel_limit(0);
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ); // what happens is told when it happens, through a pipe, too
    bool ok = (broker || options.given[0]) && show(scene, broker, &error);
    broker_stop(broker);
    scene_free(scene);
    return ok ? 0 : report_error(&error);
}

const Command command_preview = {
    .words = "a window on the photons, live; or a snapshot of it",
    .line = {"photonlab preview", help, "one scene file", flags, MOST_FLAGS, 1, 1},
    .files = &options.scene_path,
    .prepare = prepare,
    .run = run,
};
