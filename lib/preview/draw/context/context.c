#include "preview/draw/context/context_internal.h"

#include <stdlib.h>

#define WHAT_TO_INSTALL                                                                                                \
    "install one of them: Debian, Ubuntu: apt-get install libosmesa6, or libegl1 libgl1-mesa-dri; "                    \
    "Fedora: dnf install mesa-libOSMesa, or mesa-libEGL mesa-dri-drivers; Arch: pacman -S mesa; "                      \
    "macOS: brew install mesa"

// The kinds that were asked for, in order, until one is there.
static bool start(Context *context, ContextKind kind, Error *error)
{
    Error osmesa = {""}, egl = {""};
    if (kind != CONTEXT_EGL && context_start_osmesa(context, &osmesa))
        return true;
    if (kind == CONTEXT_OSMESA)
        return error_set(error,
                         "OSMesa: %s; Debian, Ubuntu: apt-get install libosmesa6; Fedora: dnf install "
                         "mesa-libOSMesa; Arch: pacman -S mesa; macOS: brew install mesa",
                         osmesa.message);
    if (context_start_egl(context, &egl))
        return true;
    if (kind == CONTEXT_EGL)
        return error_set(error,
                         "EGL: %s; Debian, Ubuntu: apt-get install libegl1 libgl1-mesa-dri; Fedora: dnf install "
                         "mesa-libEGL mesa-dri-drivers; Arch: pacman -S mesa",
                         egl.message);
    return error_set(error, "no OpenGL to draw with, neither OSMesa (%s) nor EGL (%s); " WHAT_TO_INSTALL,
                     osmesa.message, egl.message);
}

Context *context_create(ContextKind kind, Error *error)
{
    Context *context = calloc(1, sizeof *context);
    if (!context)
        error_set(error, "not enough memory");
    else if (start(context, kind, error))
        return context;
    free(context);
    return NULL;
}

GlLoader context_loader(const Context *context)
{
    return context->loader;
}

void context_free(Context *context)
{
    if (context)
        context->end(context);
    free(context);
}
