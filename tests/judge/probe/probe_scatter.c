// `scatter` cases: the photons of one pass, one by one.
#include "judge/probe/probe.h"
#include "judge/probe/probe_scatter.h"

#include "photons/pass/photon_pass.h"

typedef struct {
    ProbeOutput *output;
    long path, stored, room;
} Record;

static void begin_path(void *user, long path)
{
    ((Record *)user)->path = path;
}

static void put_stored(void *user, const StoredPhoton *photon, float flown)
{
    Record *record = user;
    if (record->stored++ >= record->room)
        return;
    probe_put_vec3(record->output, photon->position);
    probe_put_vec3(record->output, stored_photon_wi(photon));
    probe_put_colour(record->output, photon->power);
    probe_put(record->output, (float)photon->colour);
    probe_put(record->output, (float)photon->bounce);
    probe_put(record->output, (float)photon->path);
    probe_put(record->output, (float)photon->material);
    probe_put(record->output, (float)record->path);
    probe_put(record->output, flown);
}

static void pass_over(void *user, const Photon *photon, const Hit *hit)
{
    (void)user, (void)photon, (void)hit;
}

static bool run_pass(const Scene *scene, PhotonPassOptions *options, long room, ProbeOutput *output, Error *error)
{
    Record record = {output, 0, 0, room};
    PhotonRecorder recorder = {&record, begin_path, put_stored, pass_over};
    options->recorder = &recorder;
    size_t head = output->count;
    for (int i = 0; i < SCATTER_HEAD; i++)
        probe_put(output, 0.0f);
    PhotonPass pass;
    if (!photon_pass_run(scene, options, &pass, error))
        return false;
    photon_pass_free(&pass);
    while (!output->out_of_memory && output->count < head + SCATTER_HEAD + (size_t)room * SCATTER_NUMBERS)
        probe_put(output, 0.0f);
    if (output->out_of_memory)
        return true; // said by the caller
    output->values[head + SCATTER_STORED] = (float)record.stored;
    output->values[head + SCATTER_EMITTED] = (float)pass.emitted;
    output->values[head + SCATTER_UNSOUND] = (float)pass.unsound.total;
    return true;
}

bool probe_scatter(ProbeLine *line, ProbeOutput *output, Error *error)
{
    const char *path = probe_word(line);
    PhotonPassOptions options = {.threads = 1, .keep = KEEP_ALL};
    options.photons = probe_whole(line, 1, 10000000);
    long room = probe_whole(line, 1, SCATTER_MOST_ROOM);
    options.depth = (int)probe_whole(line, 1, 1000);
    const char *steps_text = probe_word(line);
    options.seed = probe_seed(line);
    StepChoice play;
    if (line->broken || !probe_at_end(line))
        return error_set(error, "expected SCENE PHOTONS ROOM DEPTH STEPS SEED");
    Scene *scene = step_choice_parse(steps_text, &play, error) ? probe_scene(path, error) : NULL;
    if (!scene)
        return false;
    options.glossy = play.glossy;
    options.loop = play.loop;
    steps_play(play);
    bool ok = run_pass(scene, &options, room, output, error);
    scene_free(scene);
    return ok;
}
