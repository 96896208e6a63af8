// How far an estimate on the floor of a room reaches: 4_reach OUT.dat OUT.txt
// OUT.dat: distance to the left wall, then of the gather rays' lengths the harmonic mean (step 4.4), the mean, the
// shortest. The room is 2 m wide, high and deep.
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

// From a point on the floor in the middle of its depth, to walls at x = ±1, z = ±1 and the ceiling 2 m above.
static float flight(float x, Vec3 d)
{
    float across = ((d.x > 0.0f ? 1.0f : -1.0f) - x) / d.x;
    return fminf(fminf(across, 2.0f / d.z), 1.0f / fabsf(d.y));
}

int main(int count, char **names)
{
    Error error = {""};
    FILE *data = count == 3 ? fopen(names[1], "w") : NULL, *text = count == 3 ? fopen(names[2], "w") : NULL;
    if (!data || !text || !steps_load(NULL, &error)) {
        fprintf(stderr, "usage: 4_reach OUT.dat OUT.txt %s\n", error.message);
        return 1;
    }
    Hemisphere seen = {0};
    for (int i = 1; i < 200; i++) {
        float x = -1.0f + 0.01f * (float)i;
        Rng rng = rng_create(3, (uint64_t)i);
        double sum = 0.0, shortest = INFINITY;
        for (int j = 0; j < GATHER_RINGS; j++)
            for (int k = 0; k < GATHER_SECTORS; k++) {
                float r = flight(x, steps.gather_direction(j, k, &rng));
                seen.distance[j][k] = r;
                sum += (double)r;
                shortest = fmin(shortest, (double)r);
            }
        double harmonic = (double)steps.irradiance_reach(&seen, 0.0f, INFINITY),
               mean = sum / (GATHER_RINGS * GATHER_SECTORS);
        fprintf(data, "%.2f %.4f %.4f %.4f\n", 0.01 * i, harmonic, mean, shortest);
        if (i == 2 || i == 10 || i == 100)
            fprintf(text, "harmonic_cm_%d %.2f\nmean_%d %.3f\nshortest_cm_%d %.2f\n", i, 100.0 * harmonic, i, mean, i,
                    100.0 * shortest);
    }
    return fclose(data) == 0 && fclose(text) == 0 ? 0 : 1;
}
