// Each ray adds its own share of π.
#include "photonlab.h"

Colour gather_hemisphere(GatherTrace *trace, const Hit *hit, Hemisphere *seen, Rng *rng)
{
    const float share = PI / (float)(GATHER_RINGS * GATHER_SECTORS);
    Frame frame = frame_about(hit->normal);
    Colour irradiance = {0, 0, 0};
    int ring = 0, sector = 0;
    while (ring < GATHER_RINGS) {
        Vec3 up = steps.gather_direction(ring, sector, rng);
        Ray ray = {hit->position, frame_to_world(&frame, up), hit->primitive};
        Colour radiance = gather_send(trace, ray, rng);
        irradiance = colour_add(irradiance, colour_scale(radiance, share));
        seen->distance[ring][sector] = gather_distance(trace);
        seen->radiance[ring][sector] = radiance;
        if (++sector == GATHER_SECTORS) {
            sector = 0;
            ring++;
        }
    }
    return irradiance;
}
