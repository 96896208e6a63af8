// What strata gain: 4_strata OUT.dat OUT.txt
// OUT.dat: where directions stand over the unit disk, as many as a hemisphere has cells; those of chance, then those of
// step 4.1. OUT.txt: by how much an estimate of irradiance errs under several skies, either way.
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

enum { TRIALS = 2000, CELLS = GATHER_RINGS * GATHER_SECTORS };

typedef double (*Sky)(Vec3 direction);

static double even(Vec3 d)
{
    return 1.0 + 0.5 * (double)d.x;
}

// A bright wall to one side.
static double wall(Vec3 d)
{
    return d.x + 0.3f * d.y > 0.2f ? 1.0 : 0.1;
}

// One spot, 10° wide, 40° from the normal.
static double spot(Vec3 d)
{
    return 0.643f * d.x + 0.766f * d.z > 0.9962f ? 50.0 : 0.1;
}

// Each direction as bright as it likes: what is left when the map itself is blotchy, and finely so.
static double blotches(Vec3 d)
{
    uint64_t place = (uint64_t)((d.x + 1.0f) * 1000.0f) << 32 | (uint64_t)((d.y + 1.0f) * 1000.0f);
    return (double)(hash_u64(place) >> 40) / 16777216.0;
}

static Vec3 direction_of(int cell, bool by_chance, Rng *rng)
{
    return by_chance ? steps.scatter_diffuse(vec3(0, 0, 1), rng)
                     : steps.gather_direction(cell / GATHER_SECTORS, cell % GATHER_SECTORS, rng);
}

// The standard deviation of the estimate, in parts of its mean.
static double error_of(Sky sky, bool by_chance)
{
    Rng rng = rng_create(4, by_chance);
    double sum = 0.0, squares = 0.0;
    for (int t = 0; t < TRIALS; t++) {
        double estimate = 0.0;
        for (int i = 0; i < CELLS; i++)
            estimate += sky(direction_of(i, by_chance, &rng)) / CELLS;
        sum += estimate;
        squares += estimate * estimate;
    }
    double mean = sum / TRIALS;
    return sqrt(squares / TRIALS - mean * mean) / mean;
}

int main(int count, char **names)
{
    Error error = {""};
    FILE *data = count == 3 ? fopen(names[1], "w") : NULL, *text = count == 3 ? fopen(names[2], "w") : NULL;
    if (!data || !text || !steps_load(NULL, &error)) {
        fprintf(stderr, "usage: 4_strata OUT.dat OUT.txt %s\n", error.message);
        return 1;
    }
    for (int way = 1; way >= 0; way--) {
        Rng rng = rng_create(1, (uint64_t)way);
        for (int i = 0; i < CELLS; i++) {
            Vec3 d = direction_of(i, way == 1, &rng);
            fprintf(data, "%.4f %.4f\n", (double)d.x, (double)d.y);
        }
        fprintf(data, "\n\n");
    }
    static const struct {
        const char *name;
        Sky sky;
    } skies[] = {{"even", even}, {"wall", wall}, {"spot", spot}, {"blotches", blotches}};
    for (size_t i = 0; i < sizeof skies / sizeof *skies; i++) {
        double chance = error_of(skies[i].sky, true), strata = error_of(skies[i].sky, false);
        fprintf(text, "%s_chance_percent %.3f\n", skies[i].name, 100.0 * chance);
        fprintf(text, "%s_strata_percent %.3f\n", skies[i].name, 100.0 * strata);
        fprintf(text, "%s_gain %.2f\n", skies[i].name, chance * chance / (strata * strata));
    }
    return fclose(data) == 0 && fclose(text) == 0 ? 0 : 1;
}
