#include "photons/gather.h"

size_t gather_near(const PhotonMap *map, Vec3 point, Gather *gather, float *radius)
{
    float radius2 = gather->radius * gather->radius;
    size_t found = photon_map_nearest(map, point, gather->k, &radius2, gather->near);
    if (!isfinite(radius2)) {
        radius2 = 0.0f;
        for (size_t i = 0; i < found; i++)
            radius2 = fmaxf(radius2, gather->near[i].distance2);
    }
    *radius = sqrtf(radius2);
    gather->reach = *radius;
    return found;
}
