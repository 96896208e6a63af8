// What window.c and window_events.c share.
#ifndef PHOTONLAB_PREVIEW_WINDOW_INTERNAL_H
#define PHOTONLAB_PREVIEW_WINDOW_INTERNAL_H

#include "preview/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

// clang-format off
#define GLFW_FUNCTIONS(X) \
    X(glfwCreateWindow) X(glfwDestroyWindow) X(glfwGetError) X(glfwGetFramebufferSize) X(glfwGetProcAddress) \
    X(glfwGetWindowSize) X(glfwGetWindowUserPointer) X(glfwInit) X(glfwMakeContextCurrent) X(glfwPollEvents) \
    X(glfwSetCharCallback) X(glfwSetCursorPosCallback) X(glfwSetFramebufferSizeCallback) X(glfwSetKeyCallback) \
    X(glfwSetMouseButtonCallback) X(glfwSetScrollCallback) X(glfwSetWindowCloseCallback) \
    X(glfwSetWindowRefreshCallback) X(glfwSetWindowUserPointer) X(glfwSwapBuffers) X(glfwSwapInterval) \
    X(glfwTerminate) X(glfwWaitEventsTimeout) X(glfwWindowHint)
// clang-format on

// GLFW's functions under their own names: glfw.glfwInit().
#define GLFW_MEMBER(name) __typeof__(&name) name;
typedef struct {
    GLFW_FUNCTIONS(GLFW_MEMBER)
} Glfw;
#undef GLFW_MEMBER

extern Glfw window_glfw; // filled by the first window_create

#define MOST_EVENTS 256

struct Window {
    GLFWwindow *handle;
    WindowEvent events[MOST_EVENTS]; // a ring
    size_t oldest, waiting;
    int button; // that drags; −1: none
    bool drag_shift;
    bool mouse_known;
    double x, y; // of the mouse, where it last was
    int last_key;
    bool shift, repeat; // of the last key: a character comes without them
};

// Has GLFW tell the window what happens.
void window_listen(Window *window);

#endif
