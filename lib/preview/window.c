#include "preview/window.h"
#include "preview/draw/context/library.h"

#include <string.h>

Glfw glfw;

#define WHAT_TO_INSTALL                                                                                                \
    "Debian, Ubuntu: apt-get install libglfw3; Fedora: dnf install glfw; Arch: pacman -S glfw; macOS: brew install glfw"

static bool load(Error *error)
{
    static const char *const FILES[] = {"libglfw.so.3",
                                        "libglfw.so",
                                        "libglfw.3.dylib",
                                        "/opt/homebrew/lib/libglfw.3.dylib",
                                        "/usr/local/lib/libglfw.3.dylib",
                                        NULL};
#define ROW(name) {#name, &glfw.name},
    static const LibraryFunction FUNCTIONS[] = {GLFW_FUNCTIONS(ROW){NULL, NULL}};
#undef ROW
    const char *missing;
    if (library_load("glfw", FILES, FUNCTIONS, &missing))
        return true;
    if (!missing)
        return error_set(error, "there is no GLFW here; " WHAT_TO_INSTALL);
    return error_set(error, "this GLFW has no %s; the preview needs GLFW 3.3 or later", missing);
}

// What GLFW says about its last failure.
static const char *reason(void)
{
    const char *text = NULL;
    glfw.glfwGetError(&text);
    return text ? text : "for reasons that GLFW does not tell";
}

Window *window_create(const char *title, int width, int height, Error *error)
{
    if (!load(error))
        return NULL;
    if (!glfw.glfwInit()) {
        error_set(error, "no display: %s", reason());
        return NULL;
    }
    glfw.glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfw.glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfw.glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
#ifdef __APPLE__
    glfw.glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE); // the only kind that it has
#endif
    glfw.glfwWindowHint(GLFW_SAMPLES, 0);
    glfw.glfwWindowHint(GLFW_DEPTH_BITS, 0); // the canvas has its own
    glfw.glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfw.glfwWindowHint(GLFW_VISIBLE, title != NULL);
    glfw.glfwWindowHint(GLFW_SCALE_TO_MONITOR, title != NULL);
    Window *window = glfw.glfwCreateWindow(width, height, title ? title : "", NULL, NULL);
    if (!window) {
        error_set(error, "no window with OpenGL 3.3: %s", reason());
        glfw.glfwTerminate();
        return NULL;
    }
    glfw.glfwMakeContextCurrent(window);
    glfw.glfwSwapInterval(0); // frames are few, and waiting for the screen would only make the mouse lag
    return window;
}

void window_free(Window *window)
{
    if (!window)
        return;
    glfw.glfwDestroyWindow(window);
    glfw.glfwTerminate();
}

float window_scale(Window *window)
{
    float across = 1.0f, down = 1.0f;
    glfw.glfwGetWindowContentScale(window, &across, &down);
    return across >= 0.5f && across <= 8.0f ? across : 1.0f;
}

static void *address_of(const char *name)
{
    GLFWglproc function = glfw.glfwGetProcAddress(name);
    void *address;
    memcpy(&address, &function, sizeof address);
    return address;
}

GlLoader window_loader(void)
{
    return address_of;
}
