#include "render/maps.h"
#include "base/parallel.h"

#include <stdlib.h>

#define PLACES 4 // GATHER: one photon in so many lends its place to an estimate of irradiance

static PhotonMap *build_map(PhotonArray *photons, Error *error)
{
    PhotonMap *map = photon_map_build(photons->photons, photons->count, error);
    *photons = (PhotonArray){NULL, 0}; // the map has taken them over
    return map;
}

// Caustic photons once more, for shadows to be sharp; and places, whose photons no estimate may count: one of k that is
// there for certain would make each 1/k too bright. The others carry their flux.
static bool part(PhotonPass *pass, PhotonArray *places)
{
    StoredPhoton *all = pass->rest.photons;
    StoredPhoton *caustic = malloc((pass->rest.count + 1) * sizeof *caustic);
    places->photons = malloc((pass->rest.count / PLACES + 1) * sizeof *places->photons);
    pass->caustic = (PhotonArray){caustic, 0};
    if (!caustic || !places->photons)
        return false;
    size_t kept = 0;
    for (size_t i = 0; i < pass->rest.count; i++) {
        if (all[i].path == PATH_CAUSTIC)
            caustic[pass->caustic.count++] = all[i];
        if (i % PLACES == PLACES - 1) {
            places->photons[places->count++] = all[i];
            continue;
        }
        all[kept] = all[i];
        all[kept++].power = colour_scale(all[i].power, PLACES / (PLACES - 1.0f));
    }
    pass->rest.count = kept;
    return true;
}

static bool build_ends(const Scene *scene, const RenderOptions *options, PhotonPass *pass, Maps *maps, Error *error)
{
    PhotonArray places = {NULL, 0};
    bool ok = part(pass, &places) || error_set(error, "not enough memory for %zu photons", pass->rest.count);
    PhotonMap *all = ok ? build_map(&pass->rest, error) : NULL;
    if (all)
        maps->ends = irradiance_map_build(scene, all, places.photons, places.count, (size_t)options->settings.k, error);
    free(places.photons);
    photon_map_free(all);
    return maps->ends != NULL;
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
    if (!photon_pass_run(scene, &pass_options, &pass, error))
        return false;
    stats->photons_emitted = pass.emitted;
    stats->photons_stored = pass.stored;
    stats->photon_rays = pass.segments;
    stats->unsound = pass.unsound;
    stats->photon_seconds = pass.seconds;
    stats->ledger = pass.ledger;
    double start = clock_seconds();
    bool ok = !gathers || build_ends(scene, options, &pass, maps, error);
    maps->caustic = ok ? build_map(&pass.caustic, error) : NULL;
    maps->rest = maps->caustic && !gathers ? build_map(&pass.rest, error) : NULL;
    stats->build_seconds = clock_seconds() - start;
    photon_pass_free(&pass);
    if (!maps->caustic || !(maps->rest || gathers))
        return false;
    stats->map_bytes =
        photon_map_bytes(maps->caustic) + (gathers ? irradiance_map_bytes(maps->ends) : photon_map_bytes(maps->rest));
    return true;
}

void maps_free(Maps *maps)
{
    photon_map_free(maps->caustic);
    photon_map_free(maps->rest);
    irradiance_map_free(maps->ends);
}
