// One estimate by gather rays: its irradiance, how far it reaches, how it changes.
#include "math/frame.h"
#include "render/final_gather.h"

#include <math.h>

#define M GATHER_RINGS
#define N GATHER_SECTORS

// Between the samples (j, k) and (j2, k2): how much brighter, over the distance of what hides one behind the other.
static Colour step_between(const Hemisphere *seen, int j, int k, int j2, int k2, float shortest)
{
    float near = fmaxf(fminf(seen->distance[j][k], seen->distance[j2][k2]), shortest);
    return colour_scale(colour_sub(seen->radiance[j][k], seen->radiance[j2][k2]), 1.0f / near);
}

static void add_along(Vec3 gradient[3], Vec3 direction, Colour amount)
{
    for (int c = 0; c < 3; c++)
        gradient[c] = vec3_along(gradient[c], direction, colour_channel(amount, c));
}

// How irradiance changes, by the differences between neighbouring rays (Ward & Heckbert 1992). A ray that is much shorter
// than all others would say more than it knows: distances count from `shortest`.
static void find_gradients(const Hemisphere *seen, const Frame *frame, float shortest, IrradianceEstimate *estimate)
{
    for (int k = 0; k < N; k++) {
        float phi = 2.0f * PI * ((float)k + 0.5f) / N; // middle of the sector
        float edge = 2.0f * PI * (float)k / N;         // where it begins
        Colour turning = colour_grey(0.0f), outwards = colour_grey(0.0f), around = colour_grey(0.0f);
        for (int j = 0; j < M; j++) {
            float sin_mid = sqrtf(((float)j + 0.5f) / M), cos_mid = sqrtf(1.0f - sin_mid * sin_mid);
            float sin_low = sqrtf((float)j / M), cos_low = sqrtf(1.0f - sin_low * sin_low);
            float cos_high = sqrtf(1.0f - (float)(j + 1) / M);
            turning = colour_add(turning, colour_scale(seen->radiance[j][k], sin_mid / cos_mid * PI / (M * N)));
            if (j > 0)
                outwards = colour_add(outwards, colour_scale(step_between(seen, j, k, j - 1, k, shortest),
                                                             sin_low * cos_low * cos_low * 2.0f * PI / N));
            around = colour_add(around, colour_scale(step_between(seen, j, k, j, (k + N - 1) % N, shortest),
                                                     cos_mid * (cos_low - cos_high) / sin_mid));
        }
        add_along(estimate->rotation, frame_to_world(frame, vec3(-sinf(phi), cosf(phi), 0.0f)), turning);
        add_along(estimate->translation, frame_to_world(frame, vec3(cosf(phi), sinf(phi), 0.0f)), outwards);
        add_along(estimate->translation, frame_to_world(frame, vec3(-sinf(edge), cosf(edge), 0.0f)), around);
    }
}

void irradiance_estimate_make(Eye *eye, const Hit *hit, Vec3 wo, float distance, IrradianceEstimate *estimate)
{
    Hemisphere seen;
    float footprint = distance * eye->final->pixel; // m that a pixel covers there
    // In an edge, to within rounding, the point may lie behind the other surface. A little towards the eye there is space.
    Hit lifted = *hit;
    lifted.position = vec3_along(hit->position, wo, LIFT * footprint);
    radiance_cache_clear(&eye->caustic_cache); // what it holds hangs on who worked here before
    GatherTrace trace = {.eye = eye};
    *estimate = (IrradianceEstimate){.position = hit->position, .normal = hit->normal};
    estimate->irradiance = steps.gather_hemisphere(&trace, &lifted, &seen, &eye->rng);

    float shortest = SHORTEST * footprint / GATHER_ACCURACY;
    float reach = steps.irradiance_reach(&seen, shortest, LONGEST * shortest);
    Frame frame = frame_about(hit->normal);
    find_gradients(&seen, &frame, 0.2f * reach, estimate);
    // No farther than where it would have doubled or gone.
    for (int c = 0; c < 3; c++) {
        float slope = vec3_length(estimate->translation[c]);
        if (slope * reach > colour_channel(estimate->irradiance, c))
            reach = fmaxf(shortest, colour_channel(estimate->irradiance, c) / slope);
    }
    estimate->reach = reach;
}
