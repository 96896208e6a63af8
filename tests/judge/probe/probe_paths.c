// `paths`, `picture` and `passes` cases: a step at work in a scene, among the reference's others.
#include "judge/probe/probe.h"
#include "judge/probe/probe_sizes.h"

#include "photons/pass/photon_pass.h"
#include "render/passes/passes.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#define PATHS_REPEATED 64

typedef struct {
    Scene *scene;
    long width, height, photons, batches, k, depth;
    StepChoice play;
    uint64_t seed;
    long passes; // 0: a picture by itself
    bool by_pixel;
} SceneCase;

static bool read_common(ProbeLine *line, SceneCase *c)
{
    c->depth = probe_whole(line, 1, 1000);
    const char *steps_text = probe_word(line);
    c->seed = probe_seed(line);
    if (line->broken || !probe_at_end(line))
        return error_set(line->error, "expected SCENE, numbers, STEPS and SEED");
    return step_choice_parse(steps_text, &c->play, line->error);
}

static void add_vec3(double sum[3], Vec3 v)
{
    sum[0] += (double)v.x;
    sum[1] += (double)v.y;
    sum[2] += (double)v.z;
}

static void add_stored(BatchSum *sum, const StoredPhoton *photon)
{
    sum->count += 1.0;
    for (int c = 0; c < 3; c++)
        sum->flux[c] += (double)colour_channel(photon->power, c);
    add_vec3(sum->place, photon->position);
    add_vec3(sum->from, stored_photon_wi(photon));
}

// Single wavelengths have colours with channels below 0.
static void count_stored(Batch *batch, const StoredPhoton *photon, bool spectral)
{
    bool sound = photon->material < BATCH_MATERIALS && (spectral || photon->colour < BATCH_COLOURS) &&
                 photon->path < BATCH_PATHS;
    for (int c = 0; c < 3; c++) {
        float flux = colour_channel(photon->power, c);
        sound = sound && flux >= (spectral ? -FLT_MAX : 0.0f) && flux < INFINITY;
    }
    if (!sound) {
        batch->unusual += 1.0;
        return;
    }
    add_stored(&batch->stored[photon->material][spectral ? WHITE : photon->colour], photon);
    add_stored(&batch->bounces[photon->bounce < BATCH_BOUNCES ? photon->bounce : BATCH_BOUNCES - 1], photon);
    batch->paths[photon->path] += 1.0;
}

static void sum_up(const PhotonPass *pass, StepChoice play, Batch *batch)
{
    *batch = (Batch){.segments = (double)pass->segments, .unsound = (double)pass->unsound.total};
    const Ledger *ledger = &pass->ledger;
    memcpy(batch->emitted, ledger->emitted, sizeof batch->emitted);
    memcpy(batch->absorbed, ledger->absorbed, sizeof batch->absorbed);
    memcpy(batch->escaped, ledger->escaped, sizeof batch->escaped);
    memcpy(batch->cut, ledger->cut, sizeof batch->cut);
    memcpy(batch->chance, ledger->chance, sizeof batch->chance);
    memcpy(batch->chance_error, ledger->chance_error, sizeof batch->chance_error);
    for (size_t i = 0; i < pass->rest.count; i++)
        count_stored(batch, &pass->rest.photons[i], play.loop == LOOP_WAVELENGTH);
}

static bool run_batch(const SceneCase *c, long i, long paths, ProbeOutput *output, Error *error)
{
    PhotonPassOptions options = {.photons = c->photons,
                                 .last = paths < c->photons ? paths : c->photons,
                                 .depth = (int)c->depth,
                                 .seed = hash_u64(c->seed + (uint64_t)i),
                                 .threads = 1,
                                 .keep = KEEP_ALL,
                                 .play = c->play};
    PhotonPass pass;
    if (!photon_pass_run(c->scene, &options, &pass, error))
        return false;
    Batch batch;
    sum_up(&pass, c->play, &batch);
    photon_pass_free(&pass);
    double values[BATCH_NUMBERS];
    memcpy(values, &batch, sizeof batch);
    for (size_t j = 0; j < BATCH_NUMBERS; j++)
        probe_put(output, (float)values[j]);
    return true;
}

// A few paths, twice: are they the same again?
static bool repeats(const SceneCase *c, Error *error)
{
    ProbeOutput first = {0}, again = {0};
    bool ok = run_batch(c, 0, PATHS_REPEATED, &first, error) && run_batch(c, 0, PATHS_REPEATED, &again, error) &&
              probe_same_again(&first, &again, error);
    free(first.values);
    free(again.values);
    return ok;
}

static bool run_batches(const SceneCase *c, ProbeOutput *output, Error *error)
{
    bool ok = repeats(c, error);
    for (long i = 0; ok && i < c->batches; i++)
        ok = run_batch(c, i, c->photons, output, error);
    return ok;
}

bool probe_paths(ProbeLine *line, ProbeOutput *output)
{
    SceneCase c = {0};
    const char *path = probe_word(line);
    c.photons = probe_whole(line, 1, 10000000);
    c.batches = probe_whole(line, 1, 10000);
    if (!read_common(line, &c) || !(c.scene = probe_scene(path, line->error)))
        return false;
    steps_play(c.play);
    bool ok = run_batches(&c, output, line->error);
    scene_free(c.scene);
    return ok;
}

static bool draw_by_passes(const SceneCase *c, const RenderOptions *options, Image *image, RenderStats *stats,
                           Error *error)
{
    Passes passes = {.alpha = PASS_ALPHA, .last = (int)c->passes, .by_pixel = c->by_pixel};
    bool ok = passes_run(c->scene, options, &passes, stats, error) && passes_picture(&passes, image, error);
    passes_free(&passes);
    return ok;
}

static bool draw(SceneCase *c, ProbeLine *line, ProbeOutput *output)
{
    Integrator integrator;
    if (!integrator_parse(probe_word(line), &integrator))
        return error_set(line->error, "expected an integrator");
    const char *path = probe_word(line);
    c->width = probe_whole(line, 1, 1024);
    c->height = probe_whole(line, 1, 1024);
    c->photons = probe_whole(line, 1, 10000000);
    c->k = probe_whole(line, 1, 10000);
    if (!read_common(line, c) || !(c->scene = probe_scene(path, line->error)))
        return false;
    RenderOptions options = {.integrator = integrator,
                             .settings = c->scene->settings,
                             .seed = c->seed,
                             .threads = 1,
                             .play = c->play,
                             .glass_sides = 2};
    options.settings.width = (int)c->width;
    options.settings.height = (int)c->height;
    options.settings.samples = 1;
    options.settings.photons = c->photons;
    options.settings.k = (int)c->k;
    options.settings.depth = (int)c->depth;
    Image image = {0, 0, NULL};
    RenderStats stats;
    bool ok = c->passes > 0 ? draw_by_passes(c, &options, &image, &stats, line->error)
                            : render_image(c->scene, &options, &image, &stats, line->error);
    for (long i = 0; ok && i < c->width * c->height; i++)
        probe_put_colour(output, image.pixels[i]);
    image_free(&image);
    scene_free(c->scene);
    return ok;
}

bool probe_picture(ProbeLine *line, ProbeOutput *output)
{
    return draw(&(SceneCase){0}, line, output);
}

bool probe_passes(ProbeLine *line, ProbeOutput *output)
{
    SceneCase c = {.passes = probe_whole(line, 1, 1000)};
    const char *radii = probe_word(line);
    c.by_pixel = strcmp(radii, "pixel") == 0;
    if (!c.by_pixel && strcmp(radii, "pass") != 0)
        return error_set(line->error, "expected `pass` or `pixel` behind the number of passes");
    return draw(&c, line, output);
}
