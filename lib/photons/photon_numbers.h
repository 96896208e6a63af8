// Photons at rest as plain numbers, as the judge gets them from the probe and shows them by `photonlab preview
// --photons-file`: a file holds a line, a head and the photons in the order of their paths, as they come off this
// machine.
#pragma once

#include "base/error.h"
#include "photons/photon.h"

#include <stddef.h>

typedef struct {
    float stored;  // photons that came to rest; fewer may follow
    float emitted; // paths
    float unsound; // see PhotonPass
} PhotonNumbersHead;

typedef struct {
    float position[3]; // m
    float from[3];     // unit vector to where it came from
    float power[3];    // W per channel
    float colour;      // PhotonColour
    float bounce;      // surfaces met before, 255 at most
    float path;        // PhotonPath
    float material;    // its number in the scene
    float emission;    // which of the emitted paths it belongs to
    float flown;       // m since the light
} PhotonNumbers;

PhotonNumbers photon_numbers(const StoredPhoton *photon, long emission, float flown);

// Are colour, bounce, path and material what a scene of so many materials has? That is the library's doing, whatever steps
// make of place, direction and power.
bool photon_numbers_are_sound(const PhotonNumbers *numbers, size_t materials);
// Is it a whole number from 0, and less than that?
bool photon_number_is_whole(float value, double below);

// The photon; false when it is none that can be drawn.
bool photon_from_numbers(const PhotonNumbers *numbers, size_t materials, StoredPhoton *photon);

bool photon_numbers_write(const char *path, const PhotonNumbersHead *head, const PhotonNumbers *photons, size_t count,
                          Error *error);
// NULL, with an error, for a file that is not well formed. The caller frees the photons.
PhotonNumbers *photon_numbers_read(const char *path, PhotonNumbersHead *head, size_t *count, Error *error);
