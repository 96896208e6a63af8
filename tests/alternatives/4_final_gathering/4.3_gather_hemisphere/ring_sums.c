// Ring by ring, in double precision; turned by hand.
#include "photonlab.h"

Colour gather_hemisphere(GatherTrace *trace, const Hit *hit, Hemisphere *seen, Rng *rng)
{
    double total[3] = {0.0, 0.0, 0.0};
    const Frame f = frame_about(hit->normal);
    for (int j = 0; j != GATHER_RINGS; ++j) {
        double of_ring[3] = {0.0, 0.0, 0.0};
        for (int k = 0; k != GATHER_SECTORS; ++k) {
            Vec3 local = steps.gather_direction(j, k, rng);
            Vec3 d = vec3_add(vec3_scale(f.tangent, local.x), vec3_scale(f.bitangent, local.y));
            d = vec3_along(d, f.normal, local.z);
            Colour *kept = &seen->radiance[j][k];
            *kept = gather_send(trace, (Ray){hit->position, vec3_normalize(d), hit->primitive}, rng);
            seen->distance[j][k] = gather_distance(trace);
            for (int c = 0; c < 3; c++)
                of_ring[c] += (double)colour_channel(*kept, c) / GATHER_SECTORS;
        }
        for (int c = 0; c < 3; c++)
            total[c] += 3.14159265358979 * of_ring[c] / GATHER_RINGS;
    }
    return colour((float)total[0], (float)total[1], (float)total[2]);
}
