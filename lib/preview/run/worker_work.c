// What a worker does, wherever it runs: photons and lobes here, the rest in files of their own.
#include "preview/run/worker.h"
#include "math/rng.h"

#include <string.h>

#define BATCH 2048
// A path that leaves more than this will never end; what comes after would only fill the memory until it is ended.
#define MOST_IN_PATH 100000

void worker_send(WireKind kind, const void *bytes, size_t size)
{
    worker_send_both(kind, bytes, size, NULL, 0);
}

static void send_books(const Worker *worker, WireKind kind)
{
    Recording books;
    memset(&books, 0, sizeof books);
    books.ledger = worker->pass.ledger;
    books.emitted = worker->pass.emitted;
    books.unsound = worker->pass.unsound;
    books.redraw_caps = redraw_cap_count();
    books.segments = worker->pass.segments;
    books.bounces = worker->bounces;
    memcpy(books.states, step_states, sizeof books.states);
    books.play = worker->play;
    worker_send(kind, &books, sizeof books);
}

typedef struct {
    Worker *worker;
    long first, last, path;
    float reach; // how far escaped photons are drawn, m: half across the scene
    long path_photons, path_legs;
    size_t photon_count, leg_count;
    RecordedPhoton photons[BATCH];
    PathLeg legs[BATCH];
} PhotonSender;

static void flush(WireKind kind, const void *items, size_t item_size, size_t *count)
{
    worker_send(kind, items, *count * item_size);
    *count = 0;
}

static void take_path(void *user, long path)
{
    PhotonSender *s = user;
    s->path = path;
    s->path_photons = s->path_legs = 0;
    worker_beat((double)(path - s->first) / (double)(s->last - s->first));
}

static void take_photon(void *user, const StoredPhoton *photon, float flown)
{
    PhotonSender *s = user;
    if (s->path_photons++ >= MOST_IN_PATH)
        return;
    s->photons[s->photon_count] = (RecordedPhoton){*photon, flown};
    if (++s->photon_count == BATCH)
        flush(WIRE_PHOTONS, s->photons, sizeof s->photons[0], &s->photon_count);
}

static void take_leg(void *user, const Photon *photon, const Hit *hit)
{
    PhotonSender *s = user;
    if (hit && photon->bounce + 1 > s->worker->bounces)
        s->worker->bounces = photon->bounce + 1;
    if (s->path >= s->worker->order->request.recorded || s->path_legs++ >= MOST_IN_PATH)
        return;
    float wave = photon->wavelength; // of preview's photons each has but one
    bool light = hit && hit->material->type == MATERIAL_LIGHT;
    s->legs[s->leg_count] = (PathLeg){
        .from = photon->position,
        .to = hit ? hit->position : vec3_along(photon->position, photon->direction, s->reach),
        .power = wave > 0.0f ? colour_scale(spectral_colour(wave), photon->power.r) : photon->power,
        .flown = photon->flown,
        .path = (uint32_t)s->path,
        .bounce = (uint16_t)(photon->bounce < 65535 ? photon->bounce : 65535),
        .colour = wave > 0.0f ? band_of_wavelength(wave) : (uint8_t)photon->colour,
        .end = (uint8_t)(!hit    ? LEG_ESCAPED
                         : light ? LEG_LIGHT
                                 : LEG_SURFACE),
    };
    if (++s->leg_count == BATCH)
        flush(WIRE_LEGS, s->legs, sizeof s->legs[0], &s->leg_count);
}

static bool trace_photons(Worker *worker, Error *error)
{
    static PhotonSender s;
    const RunRequest *request = &worker->order->request;
    int parts = worker->order->workers;
    s.worker = worker;
    s.first = request->photons / parts * worker->index;
    s.last = worker->index + 1 < parts ? request->photons / parts * (worker->index + 1) : request->photons;
    Box box = bvh_bounds(worker->scene->bvh);
    float across = vec3_length(vec3_sub(box.high, box.low));
    s.reach = across > 0.0f && across < 1e30f ? 0.5f * across : 1.0f;
    PhotonRecorder recorder = {&s, take_path, take_photon, take_leg};
    PhotonPassOptions options = {
        .photons = request->photons,
        .depth = request->depth > 0 ? request->depth : worker->scene->settings.depth,
        .seed = request->seed,
        .threads = 1,
        .keep = KEEP_ALL,
        .play = worker->play,
        .first = s.first,
        .last = s.last,
        .recorder = &recorder,
    };
    send_books(worker, WIRE_BEGUN);
    if (!photon_pass_run(worker->scene, &options, &worker->pass, error))
        return false;
    flush(WIRE_PHOTONS, s.photons, sizeof s.photons[0], &s.photon_count);
    flush(WIRE_LEGS, s.legs, sizeof s.legs[0], &s.leg_count);
    photon_pass_free(&worker->pass);
    return true;
}

static bool draw_lobe(Worker *worker, Error *error)
{
    (void)error;
    const RunRequest *request = &worker->order->request;
    float angle = request->angle * PI / 180.0f;
    Vec3 normal = vec3(0.0f, 0.0f, 1.0f), incoming = vec3(sinf(angle), 0.0f, -cosf(angle));
    LobeSample batch[BATCH];
    size_t count = 0;
    for (long i = 0; i < request->samples; i++) {
        Rng rng = rng_create(request->seed, (uint64_t)i);
        LobeSample *sample = &batch[count++];
        *sample = (LobeSample){{0.0f, 0.0f, 0.0f}, 1.0f};
        if (request->diffuse)
            sample->direction = steps.scatter_diffuse(normal, &rng);
        else if (!steps.scatter_glossy(incoming, normal, request->exponent, &rng, &sample->direction, &sample->weight))
            sample->weight = 0.0f;
        worker_beat((double)(i + 1) / (double)request->samples);
        if (count == BATCH || i + 1 == request->samples)
            flush(WIRE_FINDINGS, batch, sizeof batch[0], &count);
    }
    return true;
}

bool worker_work(Worker *worker, Error *error)
{
    static bool (*const WORK[])(Worker *, Error *) = {[RUN_PHOTONS] = trace_photons,
                                                      [RUN_LOBE] = draw_lobe,
                                                      [RUN_ESTIMATES] = worker_estimates,
                                                      [RUN_DISKS] = worker_disks,
                                                      [RUN_RENDER] = worker_render};
    const WireOrder *order = worker->order;
    if (!steps_load(order->code[0] ? order->code : NULL, error))
        return false;
    worker_beat(0.0);
    worker->play = order->request.play_is_given ? order->request.play : step_choice_for_student();
    bool asked_by_scene = !order->request.play_is_given && worker->scene->settings.spectral;
    if (order->request.spectral || asked_by_scene)
        worker->play.loop = LOOP_WAVELENGTH;
    steps_play(worker->play);
    if (!WORK[order->request.kind](worker, error))
        return false;
    send_books(worker, WIRE_DONE);
    return true;
}
