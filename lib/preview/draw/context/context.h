// Places to draw without a window.
#pragma once

#include "preview/draw/canvas.h"

typedef enum { CONTEXT_ANY, CONTEXT_OSMESA, CONTEXT_EGL } ContextKind;

typedef struct Context Context;

// A present GL 3.3 core context without a display: OSMesa, after it EGL (surfaceless). Both are looked for at run time
// and never linked. The error says what to install where neither is found.
Context *context_create(ContextKind kind, Error *error);
GlLoader context_loader(const Context *context);
void context_free(Context *context);
