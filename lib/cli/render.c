#include "cli/render.h"
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

static const char *const radii_names[] = {"pass", "pixel", NULL};
static RenderJob job = {
    .sound = true,
    .integrator = {integrator_names, -1}, // −1: as the scene says
    .bits = 8,
    .wavelengths = 3,
    .radii = {radii_names, -1},
    .options = {.settings = {.radius = -1.0f}, .glass_sides = 2, .reuse = REUSE_DEFAULT, .seed = 1}};
static const Flag flags[] = {
    {"o", FLAG_TEXT, &job.out, 0, 0},
    {"bits", FLAG_INT, &job.bits, 8, 16},
    {"integrator", FLAG_CHOICE, &job.integrator, 0, 0},
    {"photons", FLAG_LONG, &job.options.settings.photons, 1, MOST_PHOTONS},
    {"k", FLAG_INT, &job.options.settings.k, 1, MOST_K},
    {"radius", FLAG_FLOAT, &job.options.settings.radius, 0, SCENE_LARGEST_NUMBER},
    {"samples", FLAG_INT, &job.options.settings.samples, 1, MOST_SAMPLES},
    {"size", FLAG_SIZE, job.size, 1, MOST_SIDE},
    {"depth", FLAG_INT, &job.options.settings.depth, 1, MOST_DEPTH},
    {"seed", FLAG_SEED, &job.options.seed, 0, 0},
    {"threads", FLAG_INT, &job.options.threads, 0, MOST_THREADS},
    {"reuse", FLAG_FLOAT, &job.options.reuse, 0, 1},
    {"code", FLAG_TEXT, &job.code, 0, 0},
    {"steps", FLAG_TEXT, &job.steps, 0, 0},
    {"passes", FLAG_INT, &job.passes, 1, MOST_PASSES},
    {"seconds", FLAG_FLOAT, &job.seconds, 1e-3, 1e9},
    {"alpha", FLAG_FLOAT, &job.alpha, 1e-3, 1},
    {"radii", FLAG_CHOICE, &job.radii, 0, 0},
    {"part", FLAG_TEXT, &job.part, 0, 0},
    {"resume", FLAG_TEXT, &job.resume, 0, 0},
    {"spectral", FLAG_PRESENT, &job.spectral, 0, 0},
    {"wavelengths", FLAG_INT, &job.wavelengths, 1, 3},
    {"glass-sides", FLAG_INT, &job.options.glass_sides, 1, 2},
    {"tev", FLAG_TEXT, &job.tev, 0, 0},
    {"quiet", FLAG_PRESENT, &job.quiet, 0, 0},
    {"json", FLAG_PRESENT, &job.json, 0, 0},
};

// What no flag alone can tell.
static bool check(Error *error)
{
    if (job.bits != 8 && job.bits != 16)
        return error_set(error, "--bits %d: expected 8 or 16", job.bits);
    if (!job.out)
        return error_set(error, "say where to write the picture: -o OUT.png");
    if (job.wavelengths == 2)
        return error_set(error, "--wavelengths 2: expected 1 or 3");
    if (job.options.glass_sides == 1 && job.integrator.chosen == INTEGRATOR_PATH)
        return error_set(error, "--glass-sides 1: the path tracer knows whole glass only");
    return pass_flags_check(&job, error) &&
           (file_ends_in(job.out, PASS_FILE_ENDING) || image_path_is_known(job.out, error)) &&
           (!job.steps || step_choice_parse(job.steps, &job.options.play, error));
}

// What no flag says, the scene does. Many passes have an eye ray each.
static void complete_settings(const RenderSettings *own)
{
    RenderSettings *s = &job.options.settings;
    s->width = job.size[0] ? job.size[0] : own->width;
    s->height = job.size[1] ? job.size[1] : own->height;
    s->samples = s->samples ? s->samples : passes_wanted(&job) ? 1 : own->samples;
    s->photons = s->photons ? s->photons : own->photons;
    s->k = s->k ? s->k : own->k;
    s->radius = s->radius >= 0.0f ? s->radius : own->radius;
    s->depth = s->depth ? s->depth : own->depth;
}

static void print_json(const RenderStats *s)
{
    printf(
        "{\"passes\":%d,\"photons_emitted\":%ld,\"photons_stored\":%zu,\"rays\":%llu,\"photon_rays\":%llu,\"eye_rays\":%llu,"
        "\"map_bytes\":%zu,\"seconds\":{\"photons\":%.6f,\"build\":%.6f,\"eye\":%.6f},",
        s->passes, s->photons_emitted, s->photons_stored, (unsigned long long)(s->photon_rays + s->eye_rays),
        (unsigned long long)s->photon_rays, (unsigned long long)s->eye_rays, s->map_bytes, s->photon_seconds,
        s->build_seconds, s->eye_seconds);
    print_ledger_json(&s->ledger, &s->unsound);
}

static bool render_once(const Scene *scene, RenderStats *stats, Error *error)
{
    Image image = {0, 0, NULL};
    job.options.tiles.take = job.tev ? tev_show : NULL;
    job.options.progress = progress_bar_start(job.quiet);
    bool ok = render_image(scene, &job.options, &image, stats, error);
    progress_bar_end();
    ok = ok && write_picture(&image, job.out, job.bits, &job.sound, error);
    if (job.tev && !job.sound)
        tev_show_all(&image); // with what was marked
    image_free(&image);
    return ok;
}

// After the picture: what there is to tell.
static void tell(const RenderStats *stats)
{
    if (!job.quiet) {
        report_oddities(&stats->ledger, stats->photons_emitted, &stats->unsound);
        if (stats->estimates)
            fprintf(stderr, "%zu estimates of irradiance in %.1f s\n", stats->estimates, stats->gather_seconds);
        fprintf(stderr, "%s: %d×%d, %ld photons emitted, %zu stored; %.1f s photons, %.1f s map, %.1f s eye\n", job.out,
                job.options.settings.width, job.options.settings.height, stats->photons_emitted, stats->photons_stored,
                stats->photon_seconds, stats->build_seconds, stats->eye_seconds);
    }
    if (job.json)
        print_json(stats);
}

static int render(const Scene *scene)
{
    Error error = {""}, gone = {""};
    bool by_passes = passes_wanted(&job);
    complete_settings(&scene->settings);
    job.options.hero = job.wavelengths == 3;
    job.options.integrator = job.integrator.chosen < 0 ? scene->settings.integrator : (Integrator)job.integrator.chosen;
    bool traces_paths = job.options.integrator == INTEGRATOR_PATH;
    if ((job.code || !traces_paths || by_passes) && !steps_load(job.code, &error))
        return report_error(&error);
    choose_steps(job.code, job.steps, job.spectral, scene, &job.options.play);
    if (job.options.play.loop == LOOP_WAVELENGTH && traces_paths)
        return report_usage("photonlab render", "the path tracer knows red, green and blue only; say --steps 3.4");
    if (job.code && !job.quiet)
        report_steps(job.options.play, traces_paths);
    parallel_limit(job.options.threads);

    RenderStats stats;
    if (job.tev && !tev_open(job.tev, job.out, job.options.settings.width, job.options.settings.height, &error))
        return report_error(&error);
    bool ok = by_passes ? render_by_passes(&job, scene, &stats, &error) : render_once(scene, &stats, &error);
    if (job.tev && !tev_close(&gone))
        report_error(&gone);
    if (!ok)
        report_error(&error);
    if (!job.sound && job.code)
        report_suspects(job.options.play);
    if (ok)
        tell(&stats);
    return ok ? 0 : EXIT_INPUT;
}

static int run(void)
{
    Error error = {""};
    if (!check(&error))
        return report_usage("photonlab render", "%s", error.message);
    array_keep_memory();
    guard_begin(job.code, job.options.threads);
    Scene *scene = file_may_write(job.out, &error) ? scene_load(job.scene, &error) : NULL;
    if (!scene)
        return report_error(&error);
    int code = render(scene);
    scene_free(scene);
    return code;
}

const Command command_render = {
    .words = "render a scene to a picture",
    .line = {"photonlab render", help, "one scene file", flags, FLAG_COUNT(flags), 1, 1},
    .files = &job.scene,
    .run = run,
};
