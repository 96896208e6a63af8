// All rays first, then the sum over what they brought.
#include "photonlab.h"

static Colour sum_up(const Hemisphere *seen)
{
    Colour sum = colour_grey(0.0f);
    for (int k = 0; k < GATHER_SECTORS; k++)
        for (int j = 0; j < GATHER_RINGS; j++)
            sum = colour_add(sum, seen->radiance[j][k]);
    return sum;
}

Colour gather_hemisphere(GatherTrace *trace, const Hit *hit, Hemisphere *seen, Rng *rng)
{
    Frame frame = frame_about(hit->normal);
    for (int j = 0; j < GATHER_RINGS; j++)
        for (int k = 0; k < GATHER_SECTORS; k++) {
            Ray ray = {.origin = hit->position, .from = hit->primitive};
            ray.direction = frame_to_world(&frame, steps.gather_direction(j, k, rng));
            seen->radiance[j][k] = gather_send(trace, ray, rng);
            seen->distance[j][k] = gather_distance(trace);
        }
    return colour_scale(colour_scale(sum_up(seen), PI / GATHER_RINGS), 1.0f / GATHER_SECTORS);
}
