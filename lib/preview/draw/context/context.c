#include "base/text.h"
#include "preview/draw/context/context_internal.h"

#include <stdlib.h>

// In the order in which they are tried.
static const struct {
    ContextKind kind;
    const char *name, *install;
    bool (*start)(Context *context, Error *error);
} KINDS[] = {
    {CONTEXT_OSMESA, "OSMesa",
     "Debian, Ubuntu: apt-get install libosmesa6; Fedora: dnf install mesa-libOSMesa; Arch: pacman -S mesa; macOS: brew "
     "install mesa",
     context_start_osmesa},
    {CONTEXT_EGL, "EGL",
     "Debian, Ubuntu: apt-get install libegl1 libgl1-mesa-dri; Fedora: dnf install mesa-libEGL mesa-dri-drivers; Arch: "
     "pacman -S mesa",
     context_start_egl},
};

Context *context_create(ContextKind kind, Error *error)
{
    Context *context = calloc(1, sizeof *context);
    char reasons[sizeof error->message] = "";
    for (size_t i = 0; i < sizeof KINDS / sizeof *KINDS; i++) {
        Error reason = {""};
        if (kind != CONTEXT_ANY && kind != KINDS[i].kind)
            continue;
        if (context && KINDS[i].start(context, &reason))
            return context;
        error_set(&reason, "not enough memory"); // unless there is another reason
        text_append(reasons, sizeof reasons, "%s%s: %s; %s", reasons[0] ? "; or " : "", KINDS[i].name, reason.message,
                    KINDS[i].install);
    }
    error_set(error, kind == CONTEXT_ANY ? "no OpenGL to draw with. %s" : "%s", reasons);
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
