// The library as a module for browsers. An instance holds one scene, its photons and one picture; what it exports is
// called from photonlab.js, and web/README.md tells how.
#ifndef PHOTONLAB_WEB_H
#define PHOTONLAB_WEB_H

#include "preview/view/view.h"

#include <string.h>

// A function for JavaScript. What it gives back as text stays until the next call.
#define EXPORT(name) __attribute__((export_name(#name))) name

// All that decides which photons there are.
typedef struct {
    double photons, depth, seed; // whole numbers
    double recorded;             // paths whose legs are kept
    double spectral;             // photons of single wavelengths
    StepChoice play;
} PhotonSettings;

typedef struct {
    Scene *scene; // NULL: none yet
    PhotonSettings asked;
    Recording collected; // so far; its room is photon_capacity and leg_capacity
    size_t photon_capacity, leg_capacity;
    Canvas *canvas; // NULL: nothing was drawn yet
    ViewData *data; // of the scene
    View view;
    Error error;
    char text[16384];
} Page;
extern Page page;

// Every slot by the solutions; they are linked into the module.
void web_load_steps(void);

// Photons that were collected are of another setting.
void web_forget(void);

// The functions that gl.js gives, by name; NULL where it gives none of this name.
void *web_gl(const char *name);

#endif
