// OSMesa: Mesa's software OpenGL that draws into memory.
#include "preview/draw/context/context_internal.h"
#include "preview/draw/context/library.h"

#include <stddef.h>

// The library's, once it is loaded.
static struct {
    void *(*create)(const int *attributes, void *sharing);
    unsigned char (*make_current)(void *context, void *pixels, unsigned type, int width, int height);
    void *(*address)(const char *name);
    void (*destroy)(void *context);
} mesa;

static bool load(Error *error)
{
    static const char *const FILES[] = {"libOSMesa.so.8",
                                        "libOSMesa.so.6",
                                        "libOSMesa.so",
                                        "libOSMesa.8.dylib",
                                        "libOSMesa.dylib",
                                        "/opt/homebrew/lib/libOSMesa.8.dylib",
                                        "/usr/local/lib/libOSMesa.8.dylib",
                                        NULL};
    static const LibraryFunction FUNCTIONS[] = {{"OSMesaCreateContextAttribs", &mesa.create},
                                                {"OSMesaMakeCurrent", &mesa.make_current},
                                                {"OSMesaGetProcAddress", &mesa.address},
                                                {"OSMesaDestroyContext", &mesa.destroy},
                                                {NULL, NULL}};
    const char *missing;
    return library_load("osmesa", FILES, FUNCTIONS, &missing) ||
           error_set(error, missing ? "libOSMesa is too old" : "there is no libOSMesa");
}

static void *address_of(const char *name)
{
    return mesa.address(name);
}

static void end(Context *context)
{
    mesa.make_current(NULL, NULL, 0, 0, 0);
    mesa.destroy(context->handle);
}

bool context_start_osmesa(Context *context, Error *error)
{
    enum { FORMAT = 0x22, PROFILE = 0x33, CORE = 0x34, MAJOR = 0x36, MINOR = 0x37 }; // OSMesa's numbers
    enum { RGBA = 0x1908, UNSIGNED_BYTE = 0x1401 };                                  // OpenGL's
    static const int ATTRIBUTES[] = {FORMAT, RGBA, PROFILE, CORE, MAJOR, 3, MINOR, 3, 0, 0};
    if (!load(error))
        return false;
    context->handle = mesa.create(ATTRIBUTES, NULL);
    if (!context->handle)
        return error_set(error, "libOSMesa has no OpenGL 3.3");
    if (!mesa.make_current(context->handle, context->pixels, UNSIGNED_BYTE, 16, 16)) {
        mesa.destroy(context->handle);
        return error_set(error, "libOSMesa gives no context");
    }
    context->loader = address_of;
    context->end = end;
    return true;
}
