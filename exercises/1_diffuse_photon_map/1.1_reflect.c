// Step 1.1: the mirror direction. Contract: lib/steps/1_diffuse_photon_map.h
#include "photonlab.h"

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    todo("1.1"), (void)normal; // take this line away when you start

    // 1. Find how far `direction` goes along the normal.

    // 2. Take that part away twice: once to lie in the surface, once more to come out mirrored.

    return direction;
}
