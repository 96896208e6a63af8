#include "photons/pass/trace_internal.h"
#include "base/array.h"
#include "base/parallel.h"
#include "steps/steps.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#define CHUNK        4096 // paths a thread takes at a time
#define CHUNKS_TRIED 64   // after so many it is known how much memory all will take

static void close_path(PhotonTrace *trace)
{
    for (int c = 0; c < 3; c++) {
        double chance = trace->path_chance[c];
        trace->ledger.chance[c] += chance;
        trace->ledger.chance_error[c] += chance * chance;
        trace->path_chance[c] = 0.0;
    }
}

static void trace_chunk(PhotonTrace *trace, const LightChance *chances, long first, long last)
{
    const Scene *scene = trace->scene;
    const PhotonPassOptions *options = trace->options;
    bool spectral = options->play.loop == LOOP_WAVELENGTH;
    void (*trace_path)(PhotonTrace *, Photon, Rng *) = spectral ? steps.trace_photon_at_wavelength
                                                       : options->play.loop == LOOP_PLAIN
                                                           ? steps.trace_photon
                                                           : steps.trace_photon_in_colour;
    double first_place = (double)(hash_u64(options->seed) >> 11) * 0x1p-53;
    for (long i = first; i < last; i++) {
        if (options->recorder)
            options->recorder->path(options->recorder->user, i);
        Rng rng = rng_create(options->seed, (uint64_t)i);
        size_t l = light_pick(chances, scene->light_count, &rng);
        // By steps of the golden ratio, successive photons have wavelengths that lie well apart.
        Photon photon = spectral
                            ? light_emit_at_wavelength(&scene->lights[l], first_place + (double)i * 0.6180339887498949,
                                                       options->hero, &rng)
                            : light_emit(&scene->lights[l], &rng);
        float share = (float)(1.0 / ((double)options->photons * (double)chances[l].probability));
        photon.power = colour_scale(photon.power, share);
        photon.from = scene->lights[l].primitive;
        ledger_add_power(trace->ledger.emitted, photon.power);
        trace_path(trace, photon, &rng);
        close_path(trace);
    }
}

static void ledger_add(Ledger *sum, const Ledger *part)
{
    for (size_t i = 0; i < sizeof *sum / sizeof(double); i++) // it holds nothing else
        ((double *)sum)[i] += ((const double *)part)[i];
}

void unsound_paths_add(UnsoundPaths *sum, const UnsoundPaths *part)
{
    if (sum->total == 0)
        sum->length = part->length;
    sum->total += part->total;
    for (int i = 0; i < MATERIAL_TYPES; i++)
        sum->at[i] += part->at[i];
}

// Turns the squares into the standard error of the sum.
static void close_books(PhotonPass *pass)
{
    for (int c = 0; c < 3; c++) {
        double n = (double)pass->emitted;
        double mean = pass->ledger.chance[c] / n;
        double variance = pass->ledger.chance_error[c] / n - mean * mean;
        pass->ledger.chance_error[c] = sqrt(fmax(0.0, variance) * n);
    }
}

// A pass while it goes on. Who traced the next chunk in the order takes all that are traced from there on, finds places in
// the joined arrays for their photons, and copies these while others trace and copy.
typedef struct {
    const Scene *scene;
    const PhotonPassOptions *options;
    LightChance *chances;
    PhotonPass *pass;
    PhotonTrace *chunks;
    long all, traced, joined; // chunks
    int copying;              // threads
    size_t caustics, caustic_room, rest_room;
    bool part_caustics, enough;
} PassState;

// Room for all photons and for what follows, going by those of the first chunks?
static bool all_will_fit(const PassState *now)
{
    const PhotonPassOptions *options = now->options;
    double times = (double)now->all / (double)now->joined, photons = times * (double)now->pass->stored;
    double following =
        options->room + photons * options->room_a_photon + times * (double)now->caustics * options->room_a_caustic;
    return array_has_room(fmax(photons * (double)sizeof(StoredPhoton), following));
}

// Makes room for `count` photons more and, going by those so far, for all that will come: what of a large array is not
// used takes no memory. An array that was too small moves when nobody copies into it.
static bool make_room(PassState *now, PhotonArray *array, size_t count, size_t *room)
{
    if (array->photons && array->count + count <= *room)
        return true;
    for (int copying = 1; copying;) // in order with what they read and write, which `seq_cst` says
#pragma omp atomic read seq_cst
        copying = now->copying;
    *room = (size_t)(1.05 * (double)(array->count + count) * (double)now->all / (double)(now->joined + 1)) + 1;
    StoredPhoton *photons = array_allocate(*room * sizeof *photons);
    if (photons && array->count)
        memcpy(photons, array->photons, array->count * sizeof *photons);
    free(array->photons);
    array->photons = photons;
    return photons != NULL;
}

// Adds the next chunk's books, and finds its photons a place.
static bool join(PassState *now)
{
    PhotonPass *pass = now->pass;
    PhotonTrace *chunk = &now->chunks[now->joined];
    size_t apart = now->part_caustics ? chunk->caustics : 0, rest = chunk->count - apart;
    if (chunk->out_of_memory || !make_room(now, &pass->caustic, apart, &now->caustic_room) ||
        !make_room(now, &pass->rest, rest, &now->rest_room))
        return false;
    chunk->first_caustic = pass->caustic.count;
    chunk->first_rest = pass->rest.count;
    pass->caustic.count += apart;
    pass->rest.count += rest;
    pass->stored += chunk->count;
    now->caustics += chunk->caustics;
    ledger_add(&pass->ledger, &chunk->ledger);
    pass->segments += chunk->segments;
    unsound_paths_add(&pass->unsound, &chunk->unsound);
    now->joined++;
    return now->joined != (now->all < CHUNKS_TRIED ? now->all : CHUNKS_TRIED) || all_will_fit(now);
}

// Joins all chunks that are traced up to the first that is not: those from *first on.
static void join_traced(PassState *now, long latest, const PhotonTrace *trace, long *first, long *last)
{
    bool enough = now->enough;
    now->chunks[latest] = *trace; // not before: neighbours in the array share cache lines
    *first = now->joined;
    while (enough && now->joined < now->all && now->chunks[now->joined].traced)
        enough = join(now);
    *last = enough ? now->joined : *first; // what will not be needed is not copied
    if (*last > *first)
#pragma omp atomic
        now->copying++;
#pragma omp atomic write
    now->enough = enough;
    progress_report(&now->options->progress, "photons", (double)++now->traced / (double)now->all);
}

static void copy(PassState *now, PhotonTrace *chunk)
{
    StoredPhoton *to_caustic = now->pass->caustic.photons + chunk->first_caustic;
    StoredPhoton *to_rest = now->pass->rest.photons + chunk->first_rest;
    for (size_t i = 0; i < chunk->count; i++) {
        bool caustic = now->part_caustics && chunk->photons[i].path == PATH_CAUSTIC;
        *(caustic ? to_caustic++ : to_rest++) = chunk->photons[i];
    }
}

// What one thread traces, up to the first lack of memory. The memory of a chunk that it has copied serves
// it again: what the system has to find and clear for photons that are only copied on would cost a tenth of the pass.
static void trace_some(PassState *now)
{
    long end = now->options->first + now->pass->emitted;
    PhotonTrace spare = {.photons = NULL};
#pragma omp for schedule(dynamic)
    for (long i = 0; i < now->all; i++) {
        bool going;
#pragma omp atomic read
        going = now->enough;
        if (!going)
            continue;
        PhotonTrace trace = {.scene = now->scene, .options = now->options, .traced = true};
        trace.photons = spare.photons;
        trace.capacity = spare.capacity;
        spare = (PhotonTrace){.photons = NULL};
        long first = now->options->first + i * CHUNK, last;
        trace_chunk(&trace, now->chances, first, first + CHUNK < end ? first + CHUNK : end);
#pragma omp critical(photon_pass_join)
        join_traced(now, i, &trace, &first, &last);
        for (long j = first; j < last; j++) {
            PhotonTrace *chunk = &now->chunks[j];
            copy(now, chunk);
            free(spare.photons);
            spare = *chunk;
            chunk->photons = NULL;
        }
        if (last > first)
#pragma omp atomic update seq_cst
            now->copying--;
    }
    free(spare.photons);
}

bool photon_pass_run(const Scene *scene, const PhotonPassOptions *options, PhotonPass *pass, Error *error)
{
    *pass = (PhotonPass){.emitted = (options->last > 0 ? options->last : options->photons) - options->first};
    double start = clock_seconds();
    PassState now = {.scene = scene, .options = options, .pass = pass, .all = (pass->emitted + CHUNK - 1) / CHUNK};
    now.part_caustics = (options->keep & KEEP_CAUSTIC) && !(options->keep & KEEP_DIRECT);
    now.chunks = calloc((size_t)now.all, sizeof *now.chunks);
    now.chances = light_chances(scene);
    now.enough = now.chunks && now.chances;
    if (now.enough)
#pragma omp parallel num_threads(parallel_threads(options->threads))
        trace_some(&now);
    bool ok = now.enough;
    close_books(pass);
    for (long i = 0; now.chunks && i < now.all; i++)
        free(now.chunks[i].photons);
    free(now.chunks);
    free(now.chances);
    pass->seconds = clock_seconds() - start;
    if (!ok) {
        photon_pass_free(pass);
        return error_set(error, "not enough memory for the photons of %ld paths; use fewer", options->photons);
    }
    return true;
}

void photon_pass_free(PhotonPass *pass)
{
    free(pass->caustic.photons);
    free(pass->rest.photons);
    pass->caustic = pass->rest = (PhotonArray){NULL, 0};
}
