//1 cosine_twice             times the cosine
//2 not_turned               about z
//3 two_pi                   2π
//4 distance_not_kept        no distances
//5 divided_by_rings         over the rings alone
//6 -                        the first sector is sent twice
//11 pi_missing               no π
//12 last_ring_left_out       one ring short
//13 -                        twice as much for the first ring
#include "photonlab.h"
Colour gather_hemisphere(GatherTrace *T, const Hit *hit, Hemisphere *out, Rng *rng)
{
    Frame f = frame_about(hit->normal);
    float R = 0.0f, G = 0.0f, B = 0.0f;
    for (int cell = 0; cell < GATHER_RINGS * GATHER_SECTORS; cell++) {
        int j = cell / GATHER_SECTORS, k = cell % GATHER_SECTORS;
        Vec3 local = steps.gather_direction(j, MISTAKE == 6 && k == 1 ? 0 : k, rng), d = frame_to_world(&f, local);
        Colour L = gather_send(T, (Ray){hit->position, MISTAKE == 2 ? local : d, hit->primitive}, rng);
        out->radiance[j][k] = L;
        if (MISTAKE != 4)
            out->distance[j][k] = gather_distance(T);
        if (MISTAKE == 12 && j == GATHER_RINGS - 1)
            continue;
        float w = MISTAKE == 13 && j == 0 ? 2.0f : MISTAKE == 1 ? local.z : 1.0f;
        R += w * L.r, G += w * L.g, B += w * L.b;
    }
    float n = MISTAKE == 5 ? GATHER_RINGS : GATHER_RINGS * GATHER_SECTORS, s = (MISTAKE == 3 ? 2.0f * PI : PI) / n;
    if (MISTAKE == 11)
        s /= PI;
    return colour(R * s, G * s, B * s);
}
