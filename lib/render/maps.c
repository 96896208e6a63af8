#include "render/maps.h"
#include "base/parallel.h"
#include "scene/material_kind.h"

#include <stdlib.h>

#define PLACES        8 // GATHER: one photon in so many lends its place to an estimate of irradiance
#define CAUSTIC_TIMES 8 // GATHER: as many photons for caustics alone

static PhotonMap *build_map(PhotonArray *photons, Error *error)
{
    PhotonMap *map = photon_map_build(photons->photons, photons->count, error);
    *photons = (PhotonArray){NULL, 0}; // the map has taken them over
    return map;
}

// Parts off places, whose photons no estimate may count: one of k that is there for certain would make each 1/k too
// bright. The others carry their flux.
static bool part(PhotonArray *photons, PhotonArray *places)
{
    StoredPhoton *all = photons->photons;
    places->photons = malloc((photons->count / PLACES + 1) * sizeof *places->photons);
    if (!places->photons)
        return false;
    size_t kept = 0;
    for (size_t i = 0; i < photons->count; i++) {
        if (i % PLACES == PLACES - 1) {
            places->photons[places->count++] = all[i];
            continue;
        }
        all[kept] = all[i];
        all[kept++].power = colour_scale(all[i].power, PLACES / (PLACES - 1.0f));
    }
    photons->count = kept;
    return true;
}

static bool build_ends(const Scene *scene, const RenderOptions *options, PhotonPass *pass, Maps *maps, Error *error)
{
    PhotonArray places = {NULL, 0};
    bool ok = part(&pass->rest, &places) || error_set(error, "not enough memory for %zu photons", pass->rest.count);
    maps->rest = ok ? build_map(&pass->rest, error) : NULL;
    if (maps->rest)
        maps->ends =
            irradiance_map_build(scene, maps->rest, places.photons, places.count, (size_t)options->settings.k, error);
    free(places.photons);
    return maps->ends != NULL;
}

// What maps and estimates will take beside the photons' arrays, with what the trees over them need.
static void reserve(const RenderOptions *options, PhotonPassOptions *pass)
{
    double threads = parallel_threads(options->threads);
    double a_photon = sizeof(StoredPhoton) + 8.0; // in its map
    bool gathers = options->integrator == INTEGRATOR_GATHER;
    pass->room = threads * (double)PHOTON_MAP_NEAREST_CAPACITY((size_t)options->settings.k) * sizeof(NearPhoton);
    pass->room_a_photon = a_photon + (gathers ? 3.0 * (double)sizeof(LocalIrradiance) : 0.0);
    pass->room_a_caustic = gathers ? 2.0 * CAUSTIC_TIMES * (double)sizeof(StoredPhoton) : 0.0;
    if (options->pass) // all of them may lie within its radius
        pass->room_a_photon += threads * 2.0 * (double)sizeof(NearPhoton);
}

static bool has_caustics(const Scene *scene)
{
    for (size_t i = 0; i < scene->material_count; i++) {
        MaterialOptics optics = material_kind(&scene->materials[i])->optics;
        if (optics == OPTICS_MIRROR || optics == OPTICS_GLASS)
            return true;
    }
    return false;
}

// Caustics are seen as the photons lie, with no gather ray between. So there are more of them, from a pass of their own.
static bool add_caustics(const Scene *scene, PhotonPassOptions options, PhotonPass *pass, RenderStats *stats,
                         Error *error)
{
    PhotonPass more;
    options.photons *= CAUSTIC_TIMES;
    options.room_a_photon = options.room_a_caustic = 0.0; // it was there for these
    options.keep = KEEP_CAUSTIC;
    if (!has_caustics(scene))
        return true;
    if (!photon_pass_run(scene, &options, &more, error))
        return false;
    stats->photon_rays += more.segments;
    stats->photon_seconds += more.seconds;
    free(pass->caustic.photons);
    pass->caustic = more.caustic;
    more.caustic = (PhotonArray){NULL, 0};
    photon_pass_free(&more);
    return true;
}

bool maps_make(const Scene *scene, const RenderOptions *options, Maps *maps, RenderStats *stats, Error *error)
{
    bool gathers = options->integrator == INTEGRATOR_GATHER;
    PhotonPassOptions pass_options = {
        .photons = options->settings.photons,
        .depth = options->settings.depth,
        .seed = options->seed,
        .threads = options->threads,
        .keep = options->integrator == INTEGRATOR_PHOTONS ? KEEP_CAUSTIC | KEEP_INDIRECT : KEEP_ALL,
        .play = options->play,
        .hero = options->hero,
        .progress = options->progress,
    };
    PhotonPass pass;
    steps_play(options->play);
    reserve(options, &pass_options);
    if (!photon_pass_run(scene, &pass_options, &pass, error))
        return false;
    stats->photons_emitted += pass.emitted;
    stats->photons_stored += pass.stored;
    stats->photon_rays += pass.segments;
    unsound_paths_add(&stats->unsound, &pass.unsound);
    stats->photon_seconds += pass.seconds;
    stats->ledger = pass.ledger;
    double start = clock_seconds();
    bool ok = !gathers || (build_ends(scene, options, &pass, maps, error) &&
                           add_caustics(scene, pass_options, &pass, stats, error));
    maps->caustic = ok ? build_map(&pass.caustic, error) : NULL;
    if (maps->caustic && !gathers)
        maps->rest = build_map(&pass.rest, error);
    stats->build_seconds += clock_seconds() - start;
    photon_pass_free(&pass);
    if (!maps->caustic || !maps->rest)
        return false;
    stats->map_bytes = photon_map_bytes(maps->caustic) + photon_map_bytes(maps->rest);
    if (gathers)
        stats->map_bytes += irradiance_map_bytes(maps->ends);
    return true;
}

void maps_free(Maps *maps)
{
    photon_map_free(maps->caustic);
    photon_map_free(maps->rest);
    irradiance_map_free(maps->ends);
}
