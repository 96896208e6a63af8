#include "preview/draw/context/context.h"
#include "base/text.h"
#include "preview/draw/context/library.h"

#include <stdlib.h>
#include <string.h>

struct Context {
    GlLoader loader;
    void (*end)(Context *context);     // of what the kind made
    void *handle;                      // OSMesaContext or EGLContext
    void *display;                     // EGL's
    unsigned char pixels[4 * 16 * 16]; // OSMesa wants a picture to draw into; the canvas has its own
};

// ---- OSMesa: Mesa's software OpenGL that draws into memory ----

// The library's, once it is loaded.
static struct {
    void *(*create)(const int *attributes, void *sharing);
    unsigned char (*make_current)(void *context, void *pixels, unsigned type, int width, int height);
    void *(*address)(const char *name);
    void (*destroy)(void *context);
} mesa;

static const char *const MESA_FILES[] = {"libOSMesa.so.8",
                                         "libOSMesa.so.6",
                                         "libOSMesa.so",
                                         "libOSMesa.8.dylib",
                                         "libOSMesa.dylib",
                                         "/opt/homebrew/lib/libOSMesa.8.dylib",
                                         "/usr/local/lib/libOSMesa.8.dylib",
                                         NULL};
static const LibraryFunction MESA_FUNCTIONS[] = {{"OSMesaCreateContextAttribs", &mesa.create},
                                                 {"OSMesaMakeCurrent", &mesa.make_current},
                                                 {"OSMesaGetProcAddress", &mesa.address},
                                                 {"OSMesaDestroyContext", &mesa.destroy},
                                                 {NULL, NULL}};

static void end_osmesa(Context *context)
{
    mesa.make_current(NULL, NULL, 0, 0, 0);
    mesa.destroy(context->handle);
}

static bool start_osmesa(Context *context, Error *error)
{
    enum { FORMAT = 0x22, PROFILE = 0x33, CORE = 0x34, MAJOR = 0x36, MINOR = 0x37 }; // OSMesa's numbers
    enum { RGBA = 0x1908, UNSIGNED_BYTE = 0x1401 };                                  // OpenGL's
    static const int ATTRIBUTES[] = {FORMAT, RGBA, PROFILE, CORE, MAJOR, 3, MINOR, 3, 0, 0};
    context->loader = mesa.address;
    context->end = end_osmesa;
    context->handle = mesa.create(ATTRIBUTES, NULL);
    if (!context->handle)
        return error_set(error, "libOSMesa has no OpenGL 3.3");
    if (mesa.make_current(context->handle, context->pixels, UNSIGNED_BYTE, 16, 16))
        return true;
    mesa.destroy(context->handle);
    return error_set(error, "libOSMesa gives no context");
}

// ---- EGL without a display: Mesa's surfaceless platform, or else whatever display EGL has by default ----

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

static const char *const EGL_FILES[] = {"libEGL.so.1", "libEGL.so", NULL};
#define EGL_FUNCTION(result, name, parameters) {#name, &egl.name},
static const LibraryFunction EGL_LIBRARY[] = {EGL_FUNCTIONS(EGL_FUNCTION){NULL, NULL}};

static bool make_present(Context *context, void *config, void *surface)
{
    static const int VERSION[] = {MAJOR_VERSION, 3, MINOR_VERSION, 3, PROFILE_MASK, CORE_PROFILE_BIT, EGL_NONE};
    context->handle = egl.eglCreateContext(context->display, config, NULL, VERSION);
    if (context->handle && egl.eglMakeCurrent(context->display, surface, surface, context->handle))
        return true;
    if (context->handle)
        egl.eglDestroyContext(context->display, context->handle);
    return false;
}

// With no configuration first: the canvas needs none. Where the driver insists, one that can have a small surface.
static bool try_display(Context *context, void *display)
{
    static const int WISH[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    static const int SIZE[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    int major, minor, count = 0;
    void *config;
    context->display = display;
    if (!display || !egl.eglInitialize(display, &major, &minor))
        return false;
    if (egl.eglBindAPI(EGL_OPENGL_API) &&
        (make_present(context, NULL, NULL) ||
         (egl.eglChooseConfig(display, WISH, &config, 1, &count) && count > 0 &&
          make_present(context, config, egl.eglCreatePbufferSurface(display, config, SIZE)))))
        return true;
    egl.eglTerminate(display);
    return false;
}

// The display stays: ending it unloads the driver, whose threads and exit handlers may not be done.
static void end_egl(Context *context)
{
    egl.eglMakeCurrent(context->display, NULL, NULL, NULL);
    egl.eglDestroyContext(context->display, context->handle);
}

static bool start_egl(Context *context, Error *error)
{
    void *address = egl.eglGetProcAddress("eglGetPlatformDisplayEXT");
    address = address ? address : egl.eglGetProcAddress("eglGetPlatformDisplay");
    memcpy(&egl.get_platform_display, &address, sizeof address);
    context->loader = egl.eglGetProcAddress;
    context->end = end_egl;
    if (address && try_display(context, egl.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL)))
        return true;
    return try_display(context, egl.eglGetDisplay(NULL)) ||
           error_set(error, "libEGL finds no driver with OpenGL 3.3 (error 0x%x)", (unsigned)egl.eglGetError());
}

// In the order in which they are tried, which is ContextKind's.
static const struct {
    const char *name, *short_name, *install;
    const char *const *files;
    const LibraryFunction *functions;
    bool (*start)(Context *context, Error *error); // makes it present; once the library is loaded
} KINDS[] = {
    {"OSMesa", "osmesa",
     "Debian, Ubuntu: apt-get install libosmesa6; Fedora: dnf install mesa-libOSMesa; Arch: pacman -S mesa; macOS: brew "
     "install mesa",
     MESA_FILES, MESA_FUNCTIONS, start_osmesa},
    {"EGL", "egl",
     "Debian, Ubuntu: apt-get install libegl1 libgl1-mesa-dri; Fedora: dnf install mesa-libEGL mesa-dri-drivers; Arch: "
     "pacman -S mesa",
     EGL_FILES, EGL_LIBRARY, start_egl},
};

Context *context_create(ContextKind kind, Error *error)
{
    Context *context = calloc(1, sizeof *context);
    char reasons[sizeof error->message] = "";
    for (size_t i = 0; i < sizeof KINDS / sizeof *KINDS; i++) {
        Error reason = {""};
        const char *missing;
        if (kind != CONTEXT_ANY && kind != CONTEXT_ANY + 1 + i)
            continue;
        if (!library_load(KINDS[i].short_name, KINDS[i].files, KINDS[i].functions, &missing))
            error_set(&reason, missing ? "lib%s is too old" : "there is no lib%s", KINDS[i].name);
        else if (context && KINDS[i].start(context, &reason))
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
