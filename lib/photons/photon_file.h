// Stored photons as a point cloud, for other programs to open.
#pragma once

#include "base/error.h"
#include "photons/photon.h"

#include <stddef.h>

// Writes .ply (binary, little-endian) or .csv by the path's ending. Per photon: position (m); nx, ny, nz: unit
// direction to where it came from; red, green, blue 0…255: its colour at full brightness, for viewers; power per
// channel (W); colour (0 white, 1 red, 2 green, 3 blue); path (0 direct, 1 caustic, 2 indirect); bounce: surfaces met
// before this one; material: its number in the scene.
bool photon_file_write(const StoredPhoton *photons, size_t count, const char *path, Error *error);

// True if the ending is known; otherwise an error naming those that are.
bool photon_file_path_is_known(const char *path, Error *error);
