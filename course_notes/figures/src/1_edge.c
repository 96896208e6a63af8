// The mean estimate across an edge of the light: 1_edge OUT.dat OUT.txt
// Photons lie at x > 0 only, 2000 to the square metre, irradiance 1 W/m². OUT.dat, one block per k: x, mean estimate.
// Left of 0 lies shadow, if the floor goes on there. OUT.txt: at the edge, and at a corner of the floor.
#include "1_plane.h"

enum { MAPS = 500, PLACES = 61, ROWS = 5, MOST_K = 400 };
static const double DENSITY = 2000.0;

static double lit_half(double x, double y)
{
    (void)y;
    return x > 0.0 ? 1.0 : 0.0;
}

static double lit_corner(double x, double y)
{
    return x > 0.0 && y > 0.0 ? 1.0 : 0.0;
}

static double place(int i)
{
    return 0.01 * (i - 30);
}

static void across(size_t k, Gather *gather, FILE *data, FILE *text)
{
    double sums[PLACES] = {0.0};
    double corner = 0.0;
    Rng rng = rng_create(9, k);
    for (int m = 0; m < MAPS; m++) {
        PhotonMap *map = plane_map(DENSITY, -1.0, 1.0, lit_half, &rng);
        gather->k = k;
        for (int i = 0; i < PLACES * ROWS; i++)
            sums[i % PLACES] += plane_estimate(map, place(i % PLACES), 0.25 * (i / PLACES - 2), gather) / (MAPS * ROWS);
        photon_map_free(map);
        map = plane_map(DENSITY, -1.0, 1.0, lit_corner, &rng);
        corner += plane_estimate(map, 0.0, 0.0, gather) / MAPS;
        photon_map_free(map);
    }
    for (int i = 0; i < PLACES; i++)
        fprintf(data, "%.3f %.4f\n", place(i), sums[i]);
    fprintf(data, "\n\n");
    fprintf(text, "edge_%zu %.3f\ncorner_%zu %.3f\n", k, sums[30], k, corner);
}

int main(int count, char **names)
{
    static NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(MOST_K)];
    Gather gather = {.radius = INFINITY, .near = near};
    Error error = {{0}};
    FILE *data = count == 3 ? fopen(names[1], "w") : NULL;
    FILE *text = count == 3 ? fopen(names[2], "w") : NULL;
    if (!data || !text || !steps_load(NULL, &error))
        give_up("usage: 1_edge OUT.dat OUT.txt");
    across(50, &gather, data, text);
    across(MOST_K, &gather, data, text);
    return fclose(data) | fclose(text);
}
