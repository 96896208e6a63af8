#include "photons/pass/trace_internal.h"
#include "base/array.h"
#include "base/parallel.h"
#include "steps/steps.h"

#include <stdint.h>
#include <stdlib.h>

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
    for (int c = 0; c < 3; c++) {
        sum->emitted[c] += part->emitted[c];
        sum->absorbed[c] += part->absorbed[c];
        sum->escaped[c] += part->escaped[c];
        sum->cut[c] += part->cut[c];
        sum->chance[c] += part->chance[c];
        sum->chance_error[c] += part->chance_error[c];
    }
}

void unsound_paths_add(UnsoundPaths *sum, const UnsoundPaths *part)
{
    if (sum->total == 0)
        sum->length = part->length;
    sum->total += part->total;
    for (int i = 0; i < MATERIAL_TYPES; i++)
        sum->at[i] += part->at[i];
}

// Sums the chunks' books in their order and turns the squares into the standard error of the sum.
static void close_books(PhotonPass *pass, const PhotonTrace *chunks, long chunk_count)
{
    for (long i = 0; i < chunk_count; i++) {
        ledger_add(&pass->ledger, &chunks[i].ledger);
        pass->segments += chunks[i].segments;
        unsound_paths_add(&pass->unsound, &chunks[i].unsound);
    }
    for (int c = 0; c < 3; c++) {
        double n = (double)pass->emitted;
        double mean = pass->ledger.chance[c] / n;
        double variance = pass->ledger.chance_error[c] / n - mean * mean;
        pass->ledger.chance_error[c] = sqrt(fmax(0.0, variance) * n);
    }
}

// Joins what the chunks stored, in their order. Each chunk is freed once copied, so that memory never holds all photons
// twice.
static bool merge(PhotonPass *pass, PhotonTrace *chunks, long chunk_count, const PhotonPassOptions *options)
{
    bool part_caustics = (options->keep & KEEP_CAUSTIC) && !(options->keep & KEEP_DIRECT);
    size_t total = 0;
    size_t caustics = 0;
    for (long i = 0; i < chunk_count; i++) { // where each chunk's photons start in either array
        chunks[i].first_caustic = caustics;
        chunks[i].first_rest = total - caustics;
        total += chunks[i].count;
        caustics += part_caustics ? chunks[i].caustics : 0;
    }
    pass->stored = total;
    pass->caustic = (PhotonArray){array_allocate((caustics + 1) * sizeof(StoredPhoton)), caustics};
    pass->rest = (PhotonArray){array_allocate((total - caustics + 1) * sizeof(StoredPhoton)), total - caustics};
    if (!pass->caustic.photons || !pass->rest.photons)
        return false;
#pragma omp parallel for schedule(dynamic) num_threads(parallel_threads(options->threads))
    for (long i = 0; i < chunk_count; i++) {
        StoredPhoton *to_caustic = pass->caustic.photons + chunks[i].first_caustic;
        StoredPhoton *to_rest = pass->rest.photons + chunks[i].first_rest;
        for (size_t j = 0; j < chunks[i].count; j++) {
            bool apart = part_caustics && chunks[i].photons[j].path == PATH_CAUSTIC;
            *(apart ? to_caustic++ : to_rest++) = chunks[i].photons[j];
        }
        free(chunks[i].photons);
        chunks[i].photons = NULL;
    }
    return true;
}

static long last_path(const PhotonPassOptions *options)
{
    return options->last > 0 ? options->last : options->photons;
}

// Room for all photons, in their chunks and joined, and for what follows, going by those of the first chunks?
static bool all_will_fit(const PhotonPassOptions *options, size_t stored, size_t caustics, double times)
{
    double photons = times * (double)stored, joining = 2.0 * photons * (double)sizeof(StoredPhoton);
    double following =
        options->room + photons * options->room_a_photon + times * (double)caustics * options->room_a_caustic;
    return array_has_room(fmax(joining, following));
}

// False at the first lack of memory: the rest is left out.
static bool trace_all(const Scene *scene, const PhotonPassOptions *options, const LightChance *chances,
                      PhotonTrace *chunks, long chunk_count)
{
    long done = 0;
    long end = last_path(options);
    size_t stored = 0, caustics = 0;
    bool enough = true;
#pragma omp parallel for schedule(dynamic) num_threads(parallel_threads(options->threads))
    for (long i = 0; i < chunk_count; i++) {
        bool going;
#pragma omp atomic read
        going = enough;
        if (!going)
            continue;
        PhotonTrace trace = {.scene = scene, .options = options};
        long first = options->first + i * CHUNK;
        long last = first + CHUNK < end ? first + CHUNK : end;
        trace_chunk(&trace, chances, first, last);
        chunks[i] = trace; // at the end: neighbours in the array share cache lines
#pragma omp critical(photon_pass_progress)
        {
            stored += trace.count;
            caustics += trace.caustics;
            bool known = ++done == (CHUNKS_TRIED < chunk_count ? CHUNKS_TRIED : chunk_count);
            double times = (double)chunk_count / (double)done;
            if (trace.out_of_memory || (known && !all_will_fit(options, stored, caustics, times)))
#pragma omp atomic write
                enough = false;
            progress_report(&options->progress, "photons", (double)done / (double)chunk_count);
        }
    }
    return enough;
}

bool photon_pass_run(const Scene *scene, const PhotonPassOptions *options, PhotonPass *pass, Error *error)
{
    *pass = (PhotonPass){.emitted = last_path(options) - options->first};
    double start = clock_seconds();
    long chunk_count = (pass->emitted + CHUNK - 1) / CHUNK;
    PhotonTrace *chunks = calloc((size_t)chunk_count, sizeof *chunks);
    LightChance *chances = light_chances(scene);
    bool ok = chunks && chances;
    if (ok) {
        ok = trace_all(scene, options, chances, chunks, chunk_count);
        close_books(pass, chunks, chunk_count);
        ok = ok && merge(pass, chunks, chunk_count, options);
        for (long i = 0; i < chunk_count; i++)
            free(chunks[i].photons);
    }
    free(chunks);
    free(chances);
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
