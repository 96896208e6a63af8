#include "cli/cli.h"
#include "photons/photon_file.h"

#include <getopt.h>
#include <stdio.h>

static const char help[] = "usage: photonlab photons SCENE -o OUT.ply|OUT.csv [flags]\n"
                           "\n"
                           "Writes every stored photon: position, direction it came from, power, colour, bounce. "
                           "MeshLab, Blender and CloudCompare\n"
                           "open the PLY; anything opens the CSV.\n"
                           "\n"
                           "  -o FILE        where to\n"
                           "  --photons N    photons to emit\n"
                           "  --seed S       another seed, another scatter\n"
                           "  --depth N      bounces after which a path is cut\n"
                           "  --threads T    0: all cores. The photons are the same whatever T\n"
                           "  --code DIR     play the steps built in DIR\n"
                           "  --steps LIST   2.3 or 2.4 for glossy surfaces, 1.5 or 3.4 for the photon's life\n"
                           "  --quiet        no progress and no summary\n"
                           "  --json         one line of JSON on standard output\n";

enum { PHOTONS = 256, SEED, DEPTH, THREADS, CODE, STEPS };

static const struct option flags[] = {
    {"photons", required_argument, NULL, PHOTONS},
    {"seed", required_argument, NULL, SEED},
    {"depth", required_argument, NULL, DEPTH},
    {"threads", required_argument, NULL, THREADS},
    {"code", required_argument, NULL, CODE},
    {"steps", required_argument, NULL, STEPS},
    {"quiet", no_argument, NULL, 'q'},
    {"json", no_argument, NULL, 'j'},
    {"output", required_argument, NULL, 'o'},
    {"help", no_argument, NULL, 'h'},
    {NULL, 0, NULL, 0},
};

typedef struct {
    const char *scene, *out, *code;
    long photons; // 0: as the scene says
    int depth;    // 0: as the scene says
    bool quiet, json;
    StepChoice play;
    PhotonPassOptions options;
} Arguments;

static bool parse_flag(int flag, Arguments *a)
{
    Error error = {""};
    switch (flag) {
    case 'o':
        a->out = optarg;
        return photon_file_path_is_known(optarg, &error) || (report_usage("photons", "%s", error.message), false);
    case PHOTONS:
        return parse_long("photons", "--photons", optarg, 1, MOST_PHOTONS, &a->photons);
    case SEED:
        return parse_seed("photons", "--seed", optarg, &a->options.seed);
    case DEPTH:
        return parse_int("photons", "--depth", optarg, 1, MOST_DEPTH, &a->depth);
    case THREADS:
        return parse_int("photons", "--threads", optarg, 0, MOST_THREADS, &a->options.threads);
    case CODE:
        a->code = optarg;
        return true;
    case STEPS:
        return step_choice_parse(optarg, &a->play, &error) || (report_usage("photons", "%s", error.message), false);
    case 'q':
        a->quiet = true;
        return true;
    case 'j':
        a->json = true;
        return true;
    }
    return false;
}

// 0 when the arguments are right; -1 when help was printed; otherwise the exit code.
static int parse(int count, char **arguments, Arguments *a)
{
    *a = (Arguments){.options = {.seed = 1, .keep = KEEP_ALL}};
    optind = 1;
    for (int flag; (flag = getopt_long(count, arguments, "o:h", flags, NULL)) != -1;) {
        if (flag == 'h') {
            fputs(help, stdout);
            return -1;
        }
        if (flag == '?')
            return report_usage("photons", "see above");
        if (!parse_flag(flag, a))
            return EXIT_USAGE;
    }
    if (optind + 1 != count)
        return report_usage("photons", "expected one scene file, found %d", count - optind);
    a->scene = arguments[optind];
    return a->out ? 0 : report_usage("photons", "say where to write the photons: -o OUT.ply");
}

static void print_json(const PhotonPass *pass)
{
    printf("{\"photons_emitted\":%ld,\"photons_stored\":%zu,\"rays\":%llu,\"seconds\":%.6f,\"redraw_caps\":%ld,",
           pass->emitted, pass->stored, (unsigned long long)pass->segments, pass->seconds, redraw_cap_count());
    print_ledger_json(&pass->ledger);
    printf("}\n");
}

int command_photons(int count, char **arguments)
{
    Arguments a;
    int wrong = parse(count, arguments, &a);
    if (wrong)
        return wrong < 0 ? 0 : wrong;
    Error error = {""};
    Scene *scene = NULL;
    if (!steps_load(a.code, &error) || !(scene = scene_load(a.scene, &error)))
        return report_error(&error);
    a.options.photons = a.photons ? a.photons : scene->settings.photons;
    a.options.depth = a.depth ? a.depth : scene->settings.depth;
    a.options.glossy = a.play.glossy;
    a.options.loop = a.play.loop;
    steps_play(a.play);
    parallel_limit(a.options.threads);

    ProgressBar bar;
    a.options.progress = progress_bar_start(&bar, a.quiet);
    PhotonPass pass;
    bool ok = photon_pass_run(scene, &a.options, &pass, &error);
    progress_bar_end(&bar);
    ok = ok && photon_file_write(pass.rest.photons, pass.rest.count, a.out, &error);
    scene_free(scene);
    if (!ok)
        return report_error(&error);
    if (!a.quiet) {
        report_steps(a.code);
        fprintf(stderr, "%s: %zu photons stored of %ld emitted; %.1f s\n", a.out, pass.stored, pass.emitted,
                pass.seconds);
    }
    if (a.json)
        print_json(&pass);
    photon_pass_free(&pass);
    return 0;
}
