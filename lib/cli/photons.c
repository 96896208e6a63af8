#include "cli/cli.h"
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

static const char *file, *out, *code, *steps_text;
static bool quiet, json, spectral;
static PhotonPassOptions options = {.seed = 1, .keep = KEEP_ALL}; // 0 photons, depth 0: as the scene says
static const Flag flags[] = {
    {"o", FLAG_TEXT, &out, 0, 0},
    {"photons", FLAG_LONG, &options.photons, 1, MOST_PHOTONS},
    {"seed", FLAG_SEED, &options.seed, 0, 0},
    {"depth", FLAG_INT, &options.depth, 1, MOST_DEPTH},
    {"threads", FLAG_INT, &options.threads, 0, MOST_THREADS},
    {"code", FLAG_TEXT, &code, 0, 0},
    {"steps", FLAG_TEXT, &steps_text, 0, 0},
    {"spectral", FLAG_PRESENT, &spectral, 0, 0},
    {"quiet", FLAG_PRESENT, &quiet, 0, 0},
    {"json", FLAG_PRESENT, &json, 0, 0},
};

static void print_json(const PhotonPass *pass)
{
    printf("{\"photons_emitted\":%ld,\"photons_stored\":%zu,\"rays\":%llu,\"seconds\":%.6f,", pass->emitted,
           pass->stored, (unsigned long long)pass->segments, pass->seconds);
    print_ledger_json(&pass->ledger, &pass->unsound);
}

static int run(void)
{
    Error error = {""};
    Scene *scene = NULL;
    if (!out)
        return report_usage("photonlab photons", "say where to write the photons: -o OUT.ply");
    if (!photon_file_path_is_known(out, &error) ||
        (steps_text && !step_choice_parse(steps_text, &options.play, &error)))
        return report_usage("photonlab photons", "%s", error.message);
    guard_begin(code, options.threads);
    if (!file_may_write(out, &error) || !steps_load(code, &error) || !(scene = scene_load(file, &error)))
        return report_error(&error);
    options.photons = options.photons ? options.photons : scene->settings.photons;
    options.depth = options.depth ? options.depth : scene->settings.depth;
    choose_steps(code, steps_text, spectral, scene, &options.play);
    if (code && !quiet)
        report_steps(options.play, false);
    steps_play(options.play);
    parallel_limit(options.threads);

    options.progress = progress_bar_start(quiet);
    PhotonPass pass;
    bool ok = photon_pass_run(scene, &options, &pass, &error);
    progress_bar_end();
    ok = ok && photon_file_write(pass.rest.photons, pass.rest.count, out, &error);
    scene_free(scene);
    if (!ok)
        return report_error(&error);
    if (!quiet) {
        report_oddities(&pass.ledger, pass.emitted, &pass.unsound);
        fprintf(stderr, "%s: %zu photons stored of %ld emitted; %.1f s\n", out, pass.stored, pass.emitted,
                pass.seconds);
    }
    if (json)
        print_json(&pass);
    photon_pass_free(&pass);
    return 0;
}

const Command command_photons = {
    .words = "write the stored photons as a point cloud",
    .line = {"photonlab photons", help, "one scene file", flags, FLAG_COUNT(flags), 1, 1},
    .files = &file,
    .run = run,
};
