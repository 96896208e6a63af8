// `scatter` cases: the photons of one pass, one by one.
#include "judge/probe/probe.h"
#include "judge/probe/probe_sizes.h"

#include "photons/pass/photon_pass.h"

#include <string.h>

typedef struct {
    ProbeOutput *output;
    long path, stored, most;
} Record;

static void begin_path(void *user, long path)
{
    ((Record *)user)->path = path;
}

static void put_all(ProbeOutput *output, const void *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++)
        probe_put(output, ((const float *)numbers)[i]);
}

static void put_stored(void *user, const StoredPhoton *photon, float flown)
{
    Record *record = user;
    PhotonNumbers numbers = photon_numbers(photon, record->path, flown);
    if (record->stored++ < record->most)
        put_all(record->output, &numbers, SCATTER_NUMBERS);
}

static void pass_over(void *user, const Photon *photon, const Hit *hit)
{
    (void)user, (void)photon, (void)hit;
}

static bool run_pass(const Scene *scene, PhotonPassOptions *options, long most, ProbeOutput *output, Error *error)
{
    Record record = {output, 0, 0, most};
    PhotonRecorder recorder = {&record, begin_path, put_stored, pass_over};
    PhotonNumbersHead head = {0.0f, 0.0f, 0.0f};
    options->recorder = &recorder;
    size_t start = output->count;
    put_all(output, &head, SCATTER_HEAD);
    PhotonPass pass;
    if (!photon_pass_run(scene, options, &pass, error))
        return false;
    photon_pass_free(&pass);
    while (!output->out_of_memory && output->count < start + SCATTER_HEAD + (size_t)most * SCATTER_NUMBERS)
        probe_put(output, 0.0f);
    if (output->out_of_memory)
        return true; // the caller tells of a broken line
    head = (PhotonNumbersHead){(float)record.stored, (float)pass.emitted, (float)pass.unsound.total};
    memcpy(output->values + start, &head, sizeof head);
    return true;
}

bool probe_scatter(ProbeLine *line, ProbeOutput *output)
{
    const char *path = probe_word(line);
    PhotonPassOptions options = {.threads = 1, .keep = KEEP_ALL};
    options.photons = probe_whole(line, 1, 10000000);
    long most = probe_whole(line, 1, SCATTER_MOST_PHOTONS);
    options.depth = (int)probe_whole(line, 1, 1000);
    const char *steps_text = probe_word(line);
    options.seed = probe_seed(line);
    if (line->broken || !probe_at_end(line))
        return error_set(line->error, "expected SCENE PHOTONS ROOM DEPTH STEPS SEED");
    Scene *scene = step_choice_parse(steps_text, &options.play, line->error) ? probe_scene(path, line->error) : NULL;
    if (!scene)
        return false;
    steps_play(options.play);
    bool ok = run_pass(scene, &options, most, output, line->error);
    scene_free(scene);
    return ok;
}
