#include "cli/cli.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>

static const char help[] =
    "usage: photonlab render SCENE -o OUT.png|OUT.pfm [flags]\n"
    "\n"
    "Renders a scene. What a flag does not say, the scene's `render:` section does.\n"
    "\n"
    "  -o FILE              where to: .png (sRGB, for looking) or .pfm (linear floats, for measuring)\n"
    "  --bits 8|16          of the PNG's channels (8)\n"
    "  --integrator NAME    photons       direct light by shadow rays, the rest from photon maps (default)\n"
    "                       photons-only  everything from the map at the first rough surface\n"
    "                       path          no photons: a path tracer, to check against\n"
    "  --photons N          photons to emit\n"
    "  --k N                photons in an estimate; caustics take a quarter\n"
    "  --radius R           none farther than R metres; 0: no limit. Fewer than k within R: r = R and all of them\n"
    "  --samples N          eye rays per pixel\n"
    "  --size WxH           pixels\n"
    "  --depth N            bounces after which a path is cut\n"
    "  --seed S             another seed, another noise\n"
    "  --threads T          0: all cores. The picture is the same whatever T\n"
    "  --reuse F            share estimates of indirect light within F of their radius (0.35); 0: one for every eye "
    "ray\n"
    "  --code DIR           play the steps built in DIR laid out like build/solutions\n"
    "  --steps LIST         2.3 or 2.4 for glossy surfaces, 1.5 or 3.4 for the photon's life; e.g. 2.3,1.5\n"
    "  --glass-sides 1|2    1: eye rays bend at the front of glass only, the looking glass of the source text\n"
    "  --quiet              no progress and no summary\n"
    "  --json               one line of JSON on standard output: counts, rays, seconds, the energy ledger\n";

typedef struct {
    const char *scene, *out, *code, *size, *integrator, *steps;
    // Texts until the scene is loaded, whose settings they replace.
    const char *photons, *k, *radius, *samples, *depth;
    int bits;
    bool quiet, json;
    RenderOptions options;
} Arguments;

enum { BITS = 256, INTEGRATOR, PHOTONS, K, RADIUS, SAMPLES, SIZE, DEPTH, SEED, THREADS, REUSE, CODE, STEPS, SIDES };

static const struct option flags[] = {
    {"bits", required_argument, NULL, BITS},
    {"integrator", required_argument, NULL, INTEGRATOR},
    {"photons", required_argument, NULL, PHOTONS},
    {"k", required_argument, NULL, K},
    {"radius", required_argument, NULL, RADIUS},
    {"samples", required_argument, NULL, SAMPLES},
    {"size", required_argument, NULL, SIZE},
    {"depth", required_argument, NULL, DEPTH},
    {"seed", required_argument, NULL, SEED},
    {"threads", required_argument, NULL, THREADS},
    {"reuse", required_argument, NULL, REUSE},
    {"code", required_argument, NULL, CODE},
    {"steps", required_argument, NULL, STEPS},
    {"glass-sides", required_argument, NULL, SIDES},
    {"quiet", no_argument, NULL, 'q'},
    {"json", no_argument, NULL, 'j'},
    {"output", required_argument, NULL, 'o'},
    {"help", no_argument, NULL, 'h'},
    {NULL, 0, NULL, 0},
};

static bool parse_flag(int flag, Arguments *a)
{
    RenderOptions *options = &a->options;
    const char **text = flag == 'o'          ? &a->out
                        : flag == INTEGRATOR ? &a->integrator
                        : flag == PHOTONS    ? &a->photons
                        : flag == K          ? &a->k
                        : flag == RADIUS     ? &a->radius
                        : flag == SAMPLES    ? &a->samples
                        : flag == SIZE       ? &a->size
                        : flag == DEPTH      ? &a->depth
                        : flag == CODE       ? &a->code
                        : flag == STEPS      ? &a->steps
                                             : NULL;
    if (text) {
        *text = optarg;
        return true;
    }
    switch (flag) {
    case BITS:
        return parse_int("render", "--bits", optarg, 8, 16, &a->bits) &&
               (a->bits == 8 || a->bits == 16 ||
                (report_usage("render", "--bits %s: expected 8 or 16", optarg), false));
    case SEED:
        return parse_seed("render", "--seed", optarg, &options->seed);
    case THREADS:
        return parse_int("render", "--threads", optarg, 0, MOST_THREADS, &options->threads);
    case REUSE:
        return parse_float("render", "--reuse", optarg, 0.0f, 1.0f, &options->reuse);
    case SIDES:
        return parse_int("render", "--glass-sides", optarg, 1, 2, &options->glass_sides);
    case 'q':
        a->quiet = true;
        return true;
    case 'j':
        a->json = true;
        return true;
    }
    return false;
}

static bool parse_integrator(const char *name, Integrator *integrator)
{
    static const char *const names[] = {"photons", "photons-only", "path"};
    for (int i = 0; i < 3; i++)
        if (strcmp(name, names[i]) == 0) {
            *integrator = (Integrator)i;
            return true;
        }
    report_usage("render", "--integrator %s: expected photons, photons-only or path", name);
    return false;
}

static bool parse_size(const char *text, int *width, int *height)
{
    char after;
    if (sscanf(text, "%dx%d%c", width, height, &after) == 2 && *width >= 1 && *width <= MOST_SIDE && *height >= 1 &&
        *height <= MOST_SIDE)
        return true;
    report_usage("render", "--size %s: expected WIDTHxHEIGHT, each from 1 to %d, e.g. 512x512", text, MOST_SIDE);
    return false;
}

// Checks the flags that replace the scene's settings, before the scene is loaded (settings: NULL) and puts them in
// after.
static bool apply_settings(const Arguments *a, RenderSettings *settings)
{
    RenderSettings scratch;
    RenderSettings *to = settings ? settings : &scratch;
    return (!a->photons || parse_long("render", "--photons", a->photons, 1, MOST_PHOTONS, &to->photons)) &&
           (!a->k || parse_int("render", "--k", a->k, 1, MOST_K, &to->k)) &&
           (!a->radius || parse_float("render", "--radius", a->radius, 0.0f, 1e30f, &to->radius)) &&
           (!a->samples || parse_int("render", "--samples", a->samples, 1, MOST_SAMPLES, &to->samples)) &&
           (!a->depth || parse_int("render", "--depth", a->depth, 1, MOST_DEPTH, &to->depth)) &&
           (!a->size || parse_size(a->size, &to->width, &to->height));
}

// 0 when the arguments are right; -1 when help was printed; otherwise the exit code.
static int parse(int count, char **arguments, Arguments *a)
{
    *a = (Arguments){.bits = 8, .options = {.glass_sides = 2, .reuse = REUSE_DEFAULT, .seed = 1}};
    optind = 1;
    for (int flag; (flag = getopt_long(count, arguments, "o:h", flags, NULL)) != -1;) {
        if (flag == 'h') {
            fputs(help, stdout);
            return -1;
        }
        if (flag == '?')
            return report_usage("render", "see above");
        if (!parse_flag(flag, a))
            return EXIT_USAGE;
    }
    if (optind + 1 != count)
        return report_usage("render", "expected one scene file, found %d", count - optind);
    a->scene = arguments[optind];
    if (!a->out)
        return report_usage("render", "say where to write the picture: -o OUT.png");
    Error error = {""};
    if (!image_path_is_known(a->out, &error))
        return report_usage("render", "%s", error.message);
    if (a->steps && !step_choice_parse(a->steps, &a->options.play, &error))
        return report_usage("render", "%s", error.message);
    if (a->integrator && !parse_integrator(a->integrator, &a->options.integrator))
        return EXIT_USAGE;
    return apply_settings(a, NULL) ? 0 : EXIT_USAGE;
}

static void print_json(const RenderStats *s)
{
    printf("{\"photons_emitted\":%ld,\"photons_stored\":%zu,\"rays\":%llu,\"photon_rays\":%llu,\"eye_rays\":%llu,"
           "\"map_bytes\":%zu,\"seconds\":{\"photons\":%.6f,\"build\":%.6f,\"eye\":%.6f},\"redraw_caps\":%ld,",
           s->photons_emitted, s->photons_stored, (unsigned long long)(s->photon_rays + s->eye_rays),
           (unsigned long long)s->photon_rays, (unsigned long long)s->eye_rays, s->map_bytes, s->photon_seconds,
           s->build_seconds, s->eye_seconds, redraw_cap_count());
    print_ledger_json(&s->ledger);
    printf("}\n");
}

static bool save(const Image *image, const Arguments *a, Error *error)
{
    return a->bits == 16 ? image_write_png(image, a->out, 16, error) : image_write(image, a->out, error);
}

int command_render(int count, char **arguments)
{
    Arguments a;
    int wrong = parse(count, arguments, &a);
    if (wrong)
        return wrong < 0 ? 0 : wrong;
    Error error = {""};
    if ((a.code || a.options.integrator != INTEGRATOR_PATH) && !steps_load(a.code, &error))
        return report_error(&error);
    Scene *scene = scene_load(a.scene, &error);
    if (!scene)
        return report_error(&error);
    a.options.settings = scene->settings;
    apply_settings(&a, &a.options.settings);
    parallel_limit(a.options.threads);

    ProgressBar bar;
    a.options.progress = progress_bar_start(&bar, a.quiet);
    Image image = {0, 0, NULL};
    RenderStats stats;
    bool ok = render_image(scene, &a.options, &image, &stats, &error);
    progress_bar_end(&bar);
    ok = ok && save(&image, &a, &error);
    image_free(&image);
    scene_free(scene);
    if (!ok)
        return report_error(&error);
    if (!a.quiet) {
        report_steps(a.code);
        fprintf(stderr, "%s: %d×%d, %ld photons emitted, %zu stored; %.1f s photons, %.1f s map, %.1f s eye\n", a.out,
                a.options.settings.width, a.options.settings.height, stats.photons_emitted, stats.photons_stored,
                stats.photon_seconds, stats.build_seconds, stats.eye_seconds);
    }
    if (a.json)
        print_json(&stats);
    return 0;
}
