// The library as a module for browsers. An instance holds one scene, its photons and one picture; what it exports is
// called from photonlab.js, and web/README.md tells how.
#pragma once

#include "preview/record/rendered.h"
#include "preview/run/run.h"
#include "preview/view/view.h"

#include <string.h>

// A function for JavaScript. What it gives back as text stays until the next call.
#define EXPORT(name) __attribute__((export_name(#name))) name

// One that JavaScript gives.
#define IMPORT(name) __attribute__((import_module("env"), import_name(#name))) name

typedef struct {
    Scene *scene;     // NULL: none yet
    RunRequest asked; // what decides which photons there are; kind, camera and lobe are the view's when it runs
    int k;            // of estimates in rendered pictures,
    float radius;     // and their largest radius, m; 0: no limit
    bool play_chosen; // asked.play; otherwise what the student's code has
    View view;
    Recording collected; // so far; there is room for so many:
    size_t photon_capacity, leg_capacity;
    Findings finding; // on its way
    size_t finding_bytes, finding_capacity;
    Rendered rendered;
    bool show_rendered; // in place of the photons
    Canvas *canvas;     // NULL: nothing was drawn yet
    ViewData *data;     // of the scene
    Error error;
    char text[16384];
} Page;
extern Page page;

// Forgets what was found by runs of this kind; true.
bool web_begin(int kind);

// Appends to page.text, within quotes, what somebody may have written: names of materials, say.
void web_append_quoted(const char *words);

// The functions that gl.js gives, by name; NULL where it gives none of this name.
void *web_gl(const char *name);

// From now on points are added up by a loop of the module where WebGL runs in software.
void web_draw_points(Canvas *canvas);

// A run was heard of just now; it is given so many seconds until it is heard of again. See guard.c.
void web_alive(double given);
