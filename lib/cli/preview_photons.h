// Photons out of a file, for `photonlab preview --photons-file`; see photon_numbers.h.
#ifndef PHOTONLAB_CLI_PREVIEW_PHOTONS_H
#define PHOTONLAB_CLI_PREVIEW_PHOTONS_H

#include "base/error.h"
#include "preview/record/recording.h"

// The file may hold anything: one that is not well formed is refused, photons that cannot be drawn (no numbers, no such
// material) are left out. Free with recording_free.
bool preview_photons_read(const char *path, const Scene *scene, Recording *recording, Error *error);

#endif
