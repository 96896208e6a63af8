// Step 3.4: the life of a photon, as a recursion that carries its colour. Contract: lib/steps/3_colour_dispersion.h
#include "photonlab.h"

// Glass: the photon flies on reflected, or refracted and perhaps split.
static void meet_glass(PhotonTrace *trace, Photon photon, const Hit *hit, Rng *rng)
{
    (void)trace, (void)photon, (void)hit, (void)rng; // take this line away when you start

    // 4. Find the share that each channel reflects. White light has three indices, a coloured photon its own.

    // 5. Reflect with the mean probability. Weights make up for the channels that would have had another. White stays
    // white.

    // 6. Otherwise refract: split white into its colours and follow each on its own way.
}

void trace_photon_in_colour(PhotonTrace *trace, Photon photon, Rng *rng)
{
    todo("3.4"), (void)meet_glass, (void)trace, (void)photon, (void)rng; // take this line away when you start

    // 1. Fly to the next surface; the recursion ends where the path does.

    // 2. Leave a copy on a rough surface.

    // 3. Do what the material does, as in the loop of step 1.5: your code there will do here.
}
