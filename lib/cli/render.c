#include "cli/guard.h"
#include "cli/render_passes.h"
#include "cli/tev.h"
#include "base/array.h"
#include "base/file.h"

#include <stdio.h>

static const char help[] =
    "usage: photonlab render SCENE -o OUT.png|OUT.pfm|OUT.exr [flags]\n"
    "\n"
    "Renders a scene. What a flag does not say, the scene's `render:` section does.\n"
    "\n"
    "  -o FILE              where to: .png (sRGB, for looking); .pfm, .exr (linear floats, for measuring and for other programs)\n"
    "  --bits 8|16          of the PNG's channels (8)\n"
    "  --integrator NAME    photons       direct light by shadow rays, the rest from photon maps (default)\n"
    "                       photons-only  everything from the map at the first rough surface\n"
    "                       gather        as photons, but indirect light by gather rays, which look the map up where they end;\n"
    "                                     --k photons for each of these look-ups\n"
    "                       path          no photons: a path tracer, to check against\n"
    "  --photons N          photons to emit\n"
    "  --k N                photons in an estimate; caustics take a quarter, but with gather\n"
    "  --radius R           none farther than R metres; 0: no limit. Fewer than k within R: r = R and all of them\n"
    "  --samples N          eye rays per pixel\n"
    "  --size WxH           pixels\n"
    "  --depth N            bounces after which a path is cut\n"
    "  --seed S             another seed, another noise\n"
    "  --threads T          0: all cores. The picture is the same whatever T\n"
    "  --reuse F            photons: share estimates from the maps within F of their radius (0.35); 0: none is shared\n"
    "  --code DIR           play the steps built in DIR laid out like build/solutions\n"
    "  --steps LIST         2.3 or 2.4 for glossy surfaces, 1.5, 3.4 or 6.4 for the photon's life; e.g. 2.3,1.5. Unset: 2.4 and\n"
    "                       3.4; with --code, 2.3 and 1.5 where yours are started and your 2.4 and 3.4 are not\n"
    "  --passes N           N photon passes, whose radii shrink, and their mean; --photons and --samples (1) are those of each. The\n"
    "                       picture is there after 1, 2, 4, 8 … passes; ctrl-c keeps the passes, in OUT.part\n"
    "  --seconds S          passes, until so much time is over\n"
    "  --alpha A            how quickly radii shrink (2/3); 1: they do not\n"
    "  --radii pass|pixel   pass: the same for all pixels of a pass, by its number (default); pixel: by what each has found\n"
    "  --resume FILE.part   go on from there: the same bytes as without a break\n"
    "  --part K/M           only part K of M of the passes, into -o OUT.part, for `photonlab merge`\n"
    "  --spectral           photons of single wavelengths, as step 6.4 has them, not of red, green and blue\n"
    "  --wavelengths 1|3    with wavelengths: how many a photon has, until it meets dispersing glass (3)\n"
    "  --glass-sides 1|2    1: eye rays bend at the front of glass only, the looking glass of the source text\n"
    "  --tev HOST[:PORT]    shows the picture in the viewer tev while it is made (port " TEV_PORT ")\n"
    "  --quiet              no progress and no summary\n"
    "  --json               one line of JSON on standard output: counts, rays, seconds, the energy ledger\n";

typedef struct {
    const char *scene, *out, *code, *steps, *tev;
    int size[2];
    Choice integrator;
    RenderSettings settings; // 0 or −1: no flag, so the scene's own value counts
    int bits;
    bool quiet, json, spectral;
    int wavelengths;
    PassFlags passes;
    RenderOptions options;
} Arguments;

// 0 when the arguments are right, otherwise the exit code or HELP_SHOWN.
static int parse(int count, char **arguments, Arguments *a)
{
    *a = (Arguments){.integrator = {integrator_names, -1}, // −1: as the scene says
                     .bits = 8,
                     .wavelengths = 3,
                     .settings = {.radius = -1.0f},
                     .passes = {.radii = {radii_names, -1}},
                     .options = {.glass_sides = 2, .reuse = REUSE_DEFAULT, .seed = 1}};
    const Flag flags[] = {
        {"o", FLAG_TEXT, &a->out, 0, 0},
        {"bits", FLAG_INT, &a->bits, 8, 16},
        {"integrator", FLAG_CHOICE, &a->integrator, 0, 0},
        {"photons", FLAG_LONG, &a->settings.photons, 1, MOST_PHOTONS},
        {"k", FLAG_INT, &a->settings.k, 1, MOST_K},
        {"radius", FLAG_FLOAT, &a->settings.radius, 0, SCENE_LARGEST_NUMBER},
        {"samples", FLAG_INT, &a->settings.samples, 1, MOST_SAMPLES},
        {"size", FLAG_SIZE, a->size, 1, MOST_SIDE},
        {"depth", FLAG_INT, &a->settings.depth, 1, MOST_DEPTH},
        {"seed", FLAG_SEED, &a->options.seed, 0, 0},
        {"threads", FLAG_INT, &a->options.threads, 0, MOST_THREADS},
        {"reuse", FLAG_FLOAT, &a->options.reuse, 0, 1},
        {"code", FLAG_TEXT, &a->code, 0, 0},
        {"steps", FLAG_TEXT, &a->steps, 0, 0},
        PASS_FLAGS(a->passes),
        {"spectral", FLAG_PRESENT, &a->spectral, 0, 0},
        {"wavelengths", FLAG_INT, &a->wavelengths, 1, 3},
        {"glass-sides", FLAG_INT, &a->options.glass_sides, 1, 2},
        {"tev", FLAG_TEXT, &a->tev, 0, 0},
        {"quiet", FLAG_PRESENT, &a->quiet, 0, 0},
        {"json", FLAG_PRESENT, &a->json, 0, 0},
    };
    int wrong =
        command_line_parse(&(CommandLine){"photonlab render", help, "one scene file", flags, FLAG_COUNT(flags), 1, 1},
                           count, arguments, &a->scene);
    if (wrong)
        return wrong;
    if (a->bits != 8 && a->bits != 16)
        return report_usage("photonlab render", "--bits %d: expected 8 or 16", a->bits);
    if (!a->out)
        return report_usage("photonlab render", "say where to write the picture: -o OUT.png");
    a->settings.width = a->size[0];
    a->settings.height = a->size[1];
    if (a->wavelengths == 2)
        return report_usage("photonlab render", "--wavelengths 2: expected 1 or 3");
    a->options.hero = a->wavelengths == 3;
    if (a->options.glass_sides == 1 && a->integrator.chosen == INTEGRATOR_PATH)
        return report_usage("photonlab render", "--glass-sides 1: the path tracer knows whole glass only");
    wrong = pass_flags_check(&a->passes, a->out);
    if (wrong)
        return wrong;
    Error error = {""};
    bool is_known = file_ends_in(a->out, PASS_FILE_ENDING) || image_path_is_known(a->out, &error);
    if (!is_known || (a->steps && !step_choice_parse(a->steps, &a->options.play, &error)))
        return report_usage("photonlab render", "%s", error.message);
    return 0;
}

// The scene's settings, but for those that flags replace. Many passes have an eye ray each.
static RenderSettings settings_of(const Scene *scene, const RenderSettings *flags, bool by_passes)
{
    const RenderSettings *own = &scene->settings;
    int samples = by_passes ? 1 : own->samples;
    return (RenderSettings){
        .width = flags->width ? flags->width : own->width,
        .height = flags->height ? flags->height : own->height,
        .samples = flags->samples ? flags->samples : samples,
        .photons = flags->photons ? flags->photons : own->photons,
        .k = flags->k ? flags->k : own->k,
        .radius = flags->radius >= 0.0f ? flags->radius : own->radius,
        .depth = flags->depth ? flags->depth : own->depth,
    };
}

static void print_json(const RenderStats *s)
{
    printf(
        "{\"passes\":%d,\"photons_emitted\":%ld,\"photons_stored\":%zu,\"rays\":%llu,\"photon_rays\":%llu,\"eye_rays\":%llu,"
        "\"map_bytes\":%zu,\"seconds\":{\"photons\":%.6f,\"build\":%.6f,\"eye\":%.6f},\"redraw_caps\":%ld,"
        "\"unsound\":%ld,",
        s->passes, s->photons_emitted, s->photons_stored, (unsigned long long)(s->photon_rays + s->eye_rays),
        (unsigned long long)s->photon_rays, (unsigned long long)s->eye_rays, s->map_bytes, s->photon_seconds,
        s->build_seconds, s->eye_seconds, redraw_cap_count(), s->unsound.total);
    print_ledger_json(&s->ledger);
    printf("}\n");
}

static void show_tile(void *user, const Image *image, int x, int y, int width, int height)
{
    tev_show(user, image, x, y, width, height);
}

static bool render_once(Arguments *a, const Scene *scene, Tev *tev, bool *sound, RenderStats *stats, Error *error)
{
    ProgressBar bar;
    Image image = {0, 0, NULL};
    if (tev) {
        a->options.tiles.take = show_tile;
        a->options.tiles.user = tev;
    }
    a->options.progress = progress_bar_start(&bar, a->quiet);
    bool ok = render_image(scene, &a->options, &image, stats, error);
    progress_bar_end(&bar);
    ok = ok && write_picture(&image, a->out, a->bits, sound, error);
    if (tev && !*sound)
        tev_show_all(tev, &image); // with what was marked
    image_free(&image);
    return ok;
}

// After the picture: what there is to tell. The exit code.
static int tell(const Arguments *a, const RenderStats *stats)
{
    if (!a->quiet) {
        report_oddities(&stats->ledger, stats->photons_emitted, &stats->unsound);
        if (stats->estimates)
            fprintf(stderr, "%zu estimates of irradiance in %.1f s\n", stats->estimates, stats->gather_seconds);
        fprintf(stderr, "%s: %d×%d, %ld photons emitted, %zu stored; %.1f s photons, %.1f s map, %.1f s eye\n", a->out,
                a->options.settings.width, a->options.settings.height, stats->photons_emitted, stats->photons_stored,
                stats->photon_seconds, stats->build_seconds, stats->eye_seconds);
    }
    if (a->json)
        print_json(stats);
    return 0;
}

static int render(Arguments *a, const Scene *scene)
{
    Error error = {""}, gone = {""};
    bool by_passes = pass_flags_given(&a->passes), sound = true;
    a->options.settings = settings_of(scene, &a->settings, by_passes);
    a->options.integrator = a->integrator.chosen < 0 ? scene->settings.integrator : (Integrator)a->integrator.chosen;
    bool traces_paths = a->options.integrator == INTEGRATOR_PATH;
    if ((a->code || !traces_paths || by_passes) && !steps_load(a->code, &error))
        return report_error(&error);
    choose_steps(a->code, a->steps, a->spectral, scene, &a->options.play);
    if (a->options.play.loop == LOOP_WAVELENGTH && traces_paths)
        return report_usage("photonlab render", "the path tracer knows red, green and blue only; say --steps 3.4");
    if (a->code && !a->quiet)
        report_steps(a->options.play, traces_paths);
    parallel_limit(a->options.threads);

    RenderStats stats;
    Tev *tev = NULL;
    if (a->tev && !(tev = tev_open(a->tev, a->out, a->options.settings.width, a->options.settings.height, &error)))
        return report_error(&error);
    PassJob job = {a->scene, a->out, a->bits, a->quiet, &sound, tev};
    bool ok = by_passes ? render_by_passes(&job, &a->passes, scene, &a->options, &stats, &error)
                        : render_once(a, scene, tev, &sound, &stats, &error);
    if (tev && !tev_close(tev, &gone))
        report_error(&gone);
    if (!ok)
        report_error(&error);
    if (!sound && a->code)
        report_suspects(a->options.play);
    return ok ? tell(a, &stats) : EXIT_INPUT;
}

int command_render(int count, char **arguments)
{
    Arguments a;
    int wrong = parse(count, arguments, &a);
    if (wrong)
        return wrong == HELP_SHOWN ? 0 : wrong;
    array_keep_memory();
    guard_begin(a.code, a.options.threads);
    Error error = {""};
    Scene *scene = file_may_write(a.out, &error) ? scene_load(a.scene, &error) : NULL;
    if (!scene)
        return report_error(&error);
    int code = render(&a, scene);
    scene_free(scene);
    return code;
}
