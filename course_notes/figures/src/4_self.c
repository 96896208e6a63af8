// How much too bright an estimate is at the place of a photon that it counts itself: 4_self OUT.txt
// Photons lie evenly by chance on a plane, irradiance 1 W/m². For each k, by how many percent the mean estimate is off:
// at the places of photons of the map, and at those of photons that were left out of it.
#include "1_plane.h"

enum { MAPS = 40, PLACES = 4, SIZES = 3, MOST_K = 160 };
static const double DENSITY = 6000.0;
static const size_t sizes[SIZES] = {20, 60, MOST_K};

static double everywhere(double x, double y)
{
    (void)x;
    (void)y;
    return 1.0;
}

// Adds estimates at the photons of `places` that lie well inside.
static void add_estimates(const PhotonMap *map, const PhotonMap *places, Gather *gather, double *sum, long *count)
{
    const StoredPhoton *photons = photon_map_photons(places);
    for (size_t i = 0; i < photon_map_count(places); i += PLACES) {
        double x = (double)photons[i].position.x, y = (double)photons[i].position.y;
        if (fabs(x) > 0.7 || fabs(y) > 0.7)
            continue;
        *sum += plane_estimate(map, x, y, gather);
        ++*count;
    }
}

int main(int count, char **names)
{
    Error error = {""};
    FILE *text = count == 2 ? fopen(names[1], "w") : NULL;
    Gather gather = {.radius = INFINITY, .near = malloc(PHOTON_MAP_NEAREST_ROOM(MOST_K) * sizeof(NearPhoton))};
    if (!text || !gather.near || !steps_load(NULL, &error))
        give_up("usage: 4_self OUT.txt");
    double sums[SIZES][2] = {{0.0}};
    long counts[SIZES][2] = {{0}};
    for (int m = 0; m < MAPS; m++) {
        Rng rng = rng_create(5, (uint64_t)m);
        PhotonMap *map = plane_map(DENSITY, -1.0, 1.0, everywhere, &rng);
        PhotonMap *apart = plane_map(DENSITY / PLACES, -1.0, 1.0, everywhere, &rng);
        for (int i = 0; i < SIZES; i++) {
            gather.k = sizes[i];
            add_estimates(map, map, &gather, &sums[i][0], &counts[i][0]);
            add_estimates(map, apart, &gather, &sums[i][1], &counts[i][1]);
        }
        photon_map_free(map);
        photon_map_free(apart);
    }
    for (int i = 0; i < SIZES; i++) {
        fprintf(text, "counted_%zu %.2f\n", sizes[i], 100.0 * (sums[i][0] / (double)counts[i][0] - 1.0));
        fprintf(text, "apart_%zu %.2f\n", sizes[i], 100.0 * (sums[i][1] / (double)counts[i][1] - 1.0));
    }
    free(gather.near);
    return fclose(text) == 0 ? 0 : 1;
}
