//1 factor_2_missing    taken away once
//2 wrong_way_round     as for a direction that points away from the surface
//3 plus_for_minus      added
//4 -                   the absolute value of the cosine
//5 normal_alone        gives the normal
//11 -                   halfway between direction and normal
//12 -                   only the side along the surface is kept
#include "photonlab.h"
Vec3 reflect(Vec3 D, Vec3 N)
{
    double c = (double)(D.x * N.x) + (double)(D.y * N.y) + (double)(D.z * N.z), f = MISTAKE == 1 ? 1.0 : 2.0;
    if (MISTAKE == 3)
        c = -c;
    if (MISTAKE == 4)
        c = fabs(c);
    Vec3 out;
    out.x = (float)(D.x - f * c * N.x), out.y = (float)(D.y - f * c * N.y), out.z = (float)(D.z - f * c * N.z);
    if (MISTAKE == 2)
        out.x = -out.x, out.y = -out.y, out.z = -out.z;
    if (MISTAKE == 11)
        return vec3_normalize(vec3_add(D, N));
    if (MISTAKE == 12)
        return vec3_normalize(vec3_sub(D, vec3_scale(N, (float)c)));
    return MISTAKE == 5 ? N : out;
}
