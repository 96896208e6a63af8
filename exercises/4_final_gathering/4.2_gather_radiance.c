// Step 4.2: what a gather ray brings. Contract: lib/steps/4_final_gathering.h
#include "photonlab.h"

Colour gather_radiance(GatherTrace *trace, Ray ray, Rng *rng)
{
    todo("4.2"), (void)trace, (void)ray, (void)rng; // take this line away when you start

    // 1. Follow the ray from surface to surface, until it leaves the scene or meets a lamp, which shadow rays have counted.

    // 2. At a rough surface, take the light that leaves it, by the irradiance kept there.

    // 3. A mirror turns the ray and takes its share.

    // 4. Glass reflects it as well, or lets it through, by Fresnel's share. Radiance is squeezed in the denser side.

    // 5. Go on from here.

    return colour(0, 0, 0);
}
