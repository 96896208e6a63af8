// Has the recursion, which does the same work, do that of the loop.
#include "photonlab.h"

void trace_photon(PhotonTrace *trace, Photon photon, Rng *rng)
{
    steps.trace_photon_in_colour(trace, photon, rng);
}
