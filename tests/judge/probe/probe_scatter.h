// What a `scatter` case gives: SCATTER_HEAD numbers, then as many photons as there is room for, in the order of their
// paths; behind the last one all is 0. Written by probe_scatter.c; read by the judge, and by `photonlab preview
// --photons-file`, whose files hold SCATTER_MAGIC, the head and the photons without the empty room.
#ifndef PHOTONLAB_CLI_PROBE_SCATTER_H
#define PHOTONLAB_CLI_PROBE_SCATTER_H

#define SCATTER_MAGIC "photonlab scatter 1\n"

enum {
    SCATTER_STORED,  // photons that came to rest, though there may have been no room for all
    SCATTER_EMITTED, // paths
    SCATTER_UNSOUND, // see PhotonPass
    SCATTER_HEAD
};

enum {
    SCATTER_POSITION = 0, // m
    SCATTER_FROM = 3,     // unit vector to where it came from
    SCATTER_POWER = 6,    // W per channel
    SCATTER_COLOUR = 9,   // PhotonColour
    SCATTER_BOUNCE,       // surfaces met before, 255 at most
    SCATTER_PATH,         // PhotonPath
    SCATTER_MATERIAL,     // its number in the scene
    SCATTER_EMISSION,     // which of the emitted paths it belongs to
    SCATTER_FLOWN,        // m since the light
    SCATTER_NUMBERS
};

#define SCATTER_MOST_ROOM 1000000L // photons

#endif
