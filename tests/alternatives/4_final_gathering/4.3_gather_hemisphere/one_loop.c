// One loop over all cells, and a mean that grows.
#include "photonlab.h"

Colour gather_hemisphere(GatherTrace *trace, const Hit *hit, Hemisphere *seen, Rng *rng)
{
    Frame frame = frame_about(hit->normal);
    Colour mean = colour_grey(0.0f);
    for (int i = 0; i < GATHER_RINGS * GATHER_SECTORS; i++) {
        int ring = i / GATHER_SECTORS, sector = i % GATHER_SECTORS;
        Ray ray;
        ray.origin = hit->position;
        ray.from = hit->primitive;
        ray.direction = frame_to_world(&frame, steps.gather_direction(ring, sector, rng));
        Colour brought = gather_send(trace, ray, rng);
        seen->radiance[ring][sector] = brought;
        seen->distance[ring][sector] = gather_distance(trace);
        mean = colour_add(mean, colour_scale(colour_sub(brought, mean), 1.0f / (float)(i + 1)));
    }
    return colour_scale(mean, PI);
}
