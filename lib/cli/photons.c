#include "cli/cli.h"
#include "cli/guard.h"
#include "base/file.h"
#include "photons/photon_file.h"

#include <stdio.h>

static const char help[] =
    "usage: photonlab photons SCENE -o OUT.ply|OUT.csv [flags]\n"
    "\n"
    "Writes every stored photon: position, direction it came from, power, colour, bounce. MeshLab, Blender and CloudCompare\n"
    "open the PLY; anything opens the CSV.\n"
    "\n"
    "  -o FILE        where to\n"
    "  --photons N    photons to emit\n"
    "  --seed S       another seed, another scatter\n"
    "  --depth N      bounces after which a path is cut\n"
    "  --threads T    0: all cores. The photons are the same whatever T\n"
    "  --code DIR     play the steps built in DIR\n"
    "  --steps LIST   2.3 or 2.4 for glossy surfaces, 1.5, 3.4 or 6.4 for the photon's life\n"
    "  --spectral     photons of single wavelengths, as step 6.4 has them\n"
    "  --quiet        no progress and no summary\n"
    "  --json         one line of JSON on standard output\n";

typedef struct {
    const char *scene, *out, *code, *steps;
    long photons; // 0: as the scene says
    int depth;    // 0: as the scene says
    bool quiet, json, spectral;
    PhotonPassOptions options;
} Arguments;

// 0 when the arguments are right, otherwise the exit code or HELP_SHOWN.
static int parse(int count, char **arguments, Arguments *a)
{
    *a = (Arguments){.options = {.seed = 1, .keep = KEEP_ALL}};
    const Flag flags[] = {
        {"o", FLAG_TEXT, &a->out, 0, 0},
        {"photons", FLAG_LONG, &a->photons, 1, MOST_PHOTONS},
        {"seed", FLAG_SEED, &a->options.seed, 0, 0},
        {"depth", FLAG_INT, &a->depth, 1, MOST_DEPTH},
        {"threads", FLAG_INT, &a->options.threads, 0, MOST_THREADS},
        {"code", FLAG_TEXT, &a->code, 0, 0},
        {"steps", FLAG_TEXT, &a->steps, 0, 0},
        {"spectral", FLAG_PRESENT, &a->spectral, 0, 0},
        {"quiet", FLAG_PRESENT, &a->quiet, 0, 0},
        {"json", FLAG_PRESENT, &a->json, 0, 0},
    };
    int wrong =
        command_line_parse(&(CommandLine){"photonlab photons", help, "one scene file", flags, FLAG_COUNT(flags), 1, 1},
                           count, arguments, &a->scene);
    if (wrong)
        return wrong;
    if (!a->out)
        return report_usage("photonlab photons", "say where to write the photons: -o OUT.ply");
    Error error = {""};
    if (!photon_file_path_is_known(a->out, &error) ||
        (a->steps && !step_choice_parse(a->steps, &a->options.play, &error)))
        return report_usage("photonlab photons", "%s", error.message);
    return 0;
}

static void print_json(const PhotonPass *pass)
{
    printf("{\"photons_emitted\":%ld,\"photons_stored\":%zu,\"rays\":%llu,\"seconds\":%.6f,\"redraw_caps\":%ld,"
           "\"unsound\":%ld,",
           pass->emitted, pass->stored, (unsigned long long)pass->segments, pass->seconds, redraw_cap_count(),
           pass->unsound.total);
    print_ledger_json(&pass->ledger);
    printf("}\n");
}

int command_photons(int count, char **arguments)
{
    Arguments a;
    int wrong = parse(count, arguments, &a);
    if (wrong)
        return wrong == HELP_SHOWN ? 0 : wrong;
    guard_begin(a.code, a.options.threads);
    Error error = {""};
    Scene *scene = NULL;
    if (!file_may_write(a.out, &error) || !steps_load(a.code, &error) || !(scene = scene_load(a.scene, &error)))
        return report_error(&error);
    a.options.photons = a.photons ? a.photons : scene->settings.photons;
    a.options.depth = a.depth ? a.depth : scene->settings.depth;
    choose_steps(a.code, a.steps, a.spectral, scene, &a.options.play);
    if (a.code && !a.quiet)
        report_steps(a.options.play, false);
    steps_play(a.options.play);
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
        report_oddities(&pass.ledger, pass.emitted, &pass.unsound);
        fprintf(stderr, "%s: %zu photons stored of %ld emitted; %.1f s\n", a.out, pass.stored, pass.emitted,
                pass.seconds);
    }
    if (a.json)
        print_json(&pass);
    photon_pass_free(&pass);
    return 0;
}
