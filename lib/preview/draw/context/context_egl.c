// EGL without a display: Mesa's surfaceless platform, or else whatever display EGL has by default.
#include "preview/draw/context/context_internal.h"
#include "preview/draw/context/library.h"

#include <stddef.h>
#include <stdint.h>

#define EGL_FUNCTIONS(X)                                                                                               \
    X(void *, eglGetDisplay, (void *native))                                                                           \
    X(unsigned, eglInitialize, (void *display, int *major, int *minor))                                                \
    X(unsigned, eglTerminate, (void *display))                                                                         \
    X(unsigned, eglBindAPI, (unsigned api))                                                                            \
    X(unsigned, eglChooseConfig, (void *display, const int *attributes, void **configs, int size, int *count))         \
    X(void *, eglCreateContext, (void *display, void *config, void *sharing, const int *attributes))                   \
    X(unsigned, eglDestroyContext, (void *display, void *context))                                                     \
    X(void *, eglCreatePbufferSurface, (void *display, void *config, const int *attributes))                           \
    X(unsigned, eglMakeCurrent, (void *display, void *draw, void *read, void *context))                                \
    X(int, eglGetError, (void))                                                                                        \
    X(void *, eglGetProcAddress, (const char *name))

// The library's, once it is loaded.
#define EGL_MEMBER(result, name, parameters) result(*name) parameters;
static struct {
    EGL_FUNCTIONS(EGL_MEMBER)
    void *(*get_platform_display)(unsigned platform, void *native, const void *attributes); // NULL: it has none
} egl;

// EGL's numbers, of configurations and surfaces, of contexts, of the rest.
enum { EGL_NONE = 0x3038, EGL_SURFACE_TYPE = 0x3033, EGL_RENDERABLE_TYPE = 0x3040, EGL_HEIGHT = 0x3056, EGL_WIDTH };
enum { MAJOR_VERSION = 0x3098, MINOR_VERSION = 0x30FB, PROFILE_MASK = 0x30FD };
enum { EGL_OPENGL_API = 0x30A2, EGL_PLATFORM_SURFACELESS_MESA = 0x31DD };
enum { EGL_PBUFFER_BIT = 1, EGL_OPENGL_BIT = 8, CORE_PROFILE_BIT = 1 };

static bool load(Error *error)
{
    static const char *const FILES[] = {"libEGL.so.1", "libEGL.so", NULL};
#define EGL_FUNCTION(result, name, parameters) {#name, &egl.name},
    static const LibraryFunction FUNCTIONS[] = {EGL_FUNCTIONS(EGL_FUNCTION){NULL, NULL}};
    const char *missing;
    if (!library_load("egl", FILES, FUNCTIONS, &missing))
        return error_set(error, missing ? "libEGL is too old" : "there is no libEGL");
    void *address = egl.eglGetProcAddress("eglGetPlatformDisplayEXT");
    library_address_to_function(address ? address : egl.eglGetProcAddress("eglGetPlatformDisplay"),
                                &egl.get_platform_display);
    return true;
}

static void *address_of(const char *name)
{
    return egl.eglGetProcAddress(name);
}

// With no configuration first: the canvas needs none. Where the driver insists, one that can have a small surface.
static bool make_present(Context *context)
{
    static const int VERSION[] = {MAJOR_VERSION, 3, MINOR_VERSION, 3, PROFILE_MASK, CORE_PROFILE_BIT, EGL_NONE};
    static const int WISH[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    static const int SIZE[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    void *display = context->display, *config = NULL;
    for (int attempt = 0; attempt < 2; attempt++) {
        int count = 0;
        if (attempt == 1 && (!egl.eglChooseConfig(display, WISH, &config, 1, &count) || count < 1))
            return false;
        void *surface = attempt == 1 ? egl.eglCreatePbufferSurface(display, config, SIZE) : NULL;
        context->handle = egl.eglCreateContext(display, config, NULL, VERSION);
        if (context->handle && egl.eglMakeCurrent(display, surface, surface, context->handle))
            return true;
        if (context->handle)
            egl.eglDestroyContext(display, context->handle);
    }
    return false;
}

// Tries one display.
static bool try_display(Context *context, void *display)
{
    int major, minor;
    context->display = display;
    if (!display || !egl.eglInitialize(display, &major, &minor))
        return false;
    if (egl.eglBindAPI(EGL_OPENGL_API) && make_present(context))
        return true;
    egl.eglTerminate(display);
    return false;
}

// The display stays: ending it unloads the driver, whose threads and exit handlers may not be done.
static void end(Context *context)
{
    egl.eglMakeCurrent(context->display, NULL, NULL, NULL);
    egl.eglDestroyContext(context->display, context->handle);
}

bool context_start_egl(Context *context, Error *error)
{
    if (!load(error))
        return false;
    context->loader = address_of;
    context->end = end;
    if (egl.get_platform_display &&
        try_display(context, egl.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL)))
        return true;
    if (try_display(context, egl.eglGetDisplay(NULL)))
        return true;
    return error_set(error, "libEGL finds no driver with OpenGL 3.3 (error 0x%x)", (unsigned)egl.eglGetError());
}
