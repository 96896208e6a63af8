// What a `scatter` case gives: a head, then as many photons as were asked for, in the order of their paths; behind the last
// one all is 0.
#ifndef PHOTONLAB_CLI_PROBE_SCATTER_H
#define PHOTONLAB_CLI_PROBE_SCATTER_H

#include "photons/photon_numbers.h"

#define SCATTER_HEAD         (sizeof(PhotonNumbersHead) / sizeof(float))
#define SCATTER_NUMBERS      (sizeof(PhotonNumbers) / sizeof(float))
#define SCATTER_MOST_PHOTONS 1000000L

#endif
