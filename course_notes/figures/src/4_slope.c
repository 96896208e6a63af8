// Interpolation under a ceiling that is bright to the left of x = 0 and black to its right, 1 m above the floor:
//   4_slope OUT.dat OUT.txt
// OUT.dat: x, irradiance by the formula, interpolated with gradients, without; then the places of the estimates.
#include "render/final_gather.h"
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

enum { ESTIMATES = 9, PLACES = 321 };
static const float SPACING = 0.45f, ACCURACY = 0.35f;

// In place of step 4.3: what rays find under that ceiling.
static Colour look_up(GatherTrace *trace, const Hit *hit, Hemisphere *seen, Rng *rng)
{
    (void)trace;
    float sum = 0.0f;
    Frame frame = frame_about(hit->normal);
    for (int j = 0; j < GATHER_RINGS; j++)
        for (int k = 0; k < GATHER_SECTORS; k++) {
            Vec3 d = frame_to_world(&frame, steps.gather_direction(j, k, rng));
            float radiance = hit->position.x + d.x / d.z < 0.0f ? 1.0f : 0.0f;
            seen->distance[j][k] = 1.0f / d.z;
            seen->radiance[j][k] = colour_grey(radiance);
            sum += radiance;
        }
    return colour_grey(sum * PI / (GATHER_RINGS * GATHER_SECTORS));
}

// Half the sky, seen past an edge: π/2·(1 − sin of the edge's angle to the normal).
static double truth(double x)
{
    return M_PI / 2.0 * (1.0 - x / sqrt(1.0 + x * x));
}

int main(int count, char **names)
{
    Error error = {""};
    FILE *data = count == 3 ? fopen(names[1], "w") : NULL, *text = count == 3 ? fopen(names[2], "w") : NULL;
    Eye *eye = calloc(1, sizeof *eye);
    if (!data || !text || !eye || !steps_load(NULL, &error)) {
        fprintf(stderr, "usage: 4_slope OUT.dat OUT.txt %s\n", error.message);
        return 1;
    }
    steps.gather_hemisphere = look_up;
    FinalGather final = {.pixel = 0.05f};
    eye->final = &final;
    eye->rng = rng_create(2, 1);
    IrradianceEstimate estimates[2][ESTIMATES];
    const IrradianceEstimate *near[2][ESTIMATES];
    for (int i = 0; i < ESTIMATES; i++) {
        Hit hit = {.position = vec3(SPACING * (float)(i - ESTIMATES / 2), 0, 0), .normal = vec3(0, 0, 1)};
        irradiance_estimate_make(eye, &hit, hit.normal, 1.0f, &estimates[0][i]);
        estimates[1][i] = estimates[0][i];
        for (int c = 0; c < 3; c++)
            estimates[1][i].translation[c] = vec3(0, 0, 0);
        near[0][i] = &estimates[0][i];
        near[1][i] = &estimates[1][i];
    }
    double squares[2] = {0.0, 0.0};
    for (int i = 0; i < PLACES; i++) {
        double x = -1.6 + 3.2 * i / (PLACES - 1);
        fprintf(data, "%.3f %.5f", x, truth(x));
        for (int way = 0; way < 2; way++) {
            Colour found = colour_grey(0.0f);
            steps.interpolate_irradiance(near[way], ESTIMATES, vec3((float)x, 0, 0), vec3(0, 0, 1), ACCURACY, &found);
            fprintf(data, " %.5f", (double)found.g);
            squares[way] += pow((double)found.g - truth(x), 2.0) / PLACES;
        }
        fprintf(data, "\n");
    }
    fprintf(data, "\n\n");
    for (int i = 0; i < ESTIMATES; i++)
        fprintf(data, "%.3f %.5f\n", (double)estimates[0][i].position.x, (double)estimates[0][i].irradiance.g);
    // By the formula dE/dx = −π/2·(1 + x²)^(−3/2): −π/2 in the middle.
    fprintf(text, "slope_middle %.3f\nslope_middle_formula %.3f\n",
            (double)estimates[0][ESTIMATES / 2].translation[1].x, -M_PI / 2.0);
    fprintf(text, "rms_percent_with %.2f\nrms_percent_without %.2f\n", 100.0 * sqrt(squares[0]) / M_PI,
            100.0 * sqrt(squares[1]) / M_PI);
    fprintf(text, "gain %.1f\n", sqrt(squares[1] / squares[0]));
    free(eye);
    return fclose(data) == 0 && fclose(text) == 0 ? 0 : 1;
}
