// What right steps never do: how a person is told of it after a photon pass.
#ifndef PHOTONLAB_PHOTONS_ODDITIES_H
#define PHOTONLAB_PHOTONS_ODDITIES_H

#include "photons/photon_pass.h"

#include <stddef.h>

#define ODDITIES_SIZE 512 // bytes that all of them fit in

// Lobes redrawn too often, directions of no length, flux from nowhere: a line for each that is there, each with its
// newline; an empty text when all is well. `paths`: how many the ledger is of.
void oddities_describe(const Ledger *ledger, long paths, long unsound, long redraw_caps, char *text, size_t size);

#endif
