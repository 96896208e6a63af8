// What the two kinds of context share.
#ifndef PHOTONLAB_PREVIEW_CONTEXT_INTERNAL_H
#define PHOTONLAB_PREVIEW_CONTEXT_INTERNAL_H

#include "preview/draw/context/context.h"

struct Context {
    GlLoader loader;
    void (*end)(Context *context);     // of what the kind made
    void *handle;                      // OSMesaContext or EGLContext
    void *display;                     // EGL's
    unsigned char pixels[4 * 16 * 16]; // OSMesa wants a picture to draw into; the canvas has its own
};

// Fill the context and make it present. False with a reason that can stand after "OSMesa: " or "EGL: ".
bool context_start_osmesa(Context *context, Error *error);
bool context_start_egl(Context *context, Error *error);

#endif
