// A window on the screen with OpenGL in it, by GLFW, which is looked for at run time.
#pragma once

#include "preview/draw/canvas.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

// clang-format off
#define GLFW_FUNCTIONS(X) \
    X(glfwCreateWindow) X(glfwDestroyWindow) X(glfwGetError) X(glfwGetFramebufferSize) X(glfwGetProcAddress) \
    X(glfwGetWindowContentScale) X(glfwGetWindowSize) X(glfwGetWindowUserPointer) X(glfwInit) X(glfwMakeContextCurrent) X(glfwPollEvents) \
    X(glfwSetCharCallback) X(glfwSetCursorPosCallback) X(glfwSetFramebufferSizeCallback) X(glfwSetKeyCallback) \
    X(glfwSetMouseButtonCallback) X(glfwSetScrollCallback) X(glfwSetWindowCloseCallback) \
    X(glfwSetWindowRefreshCallback) X(glfwSetWindowUserPointer) X(glfwSwapBuffers) X(glfwSwapInterval) \
    X(glfwTerminate) X(glfwWaitEventsTimeout) X(glfwWindowHint)
// clang-format on

// GLFW's functions under their own names: glfw.glfwInit(). Filled by the first window_create.
#define GLFW_MEMBER(name) __typeof__(&name) name;
typedef struct {
    GLFW_FUNCTIONS(GLFW_MEMBER)
} Glfw;
#undef GLFW_MEMBER
extern Glfw glfw;

typedef GLFWwindow Window;

// One window at a time; all calls from the thread that made it. Without a title it is never shown, but drawn by the same
// OpenGL. The context (3.3 core) is present from here on. The error says why there is none: no display, no GLFW (and what
// to install), no OpenGL 3.3.
Window *window_create(const char *title, int width, int height, Error *error);
void window_free(Window *window);
float window_scale(Window *window); // of words, on this monitor: 1 where they are as large as at 96 dots an inch

GlLoader window_loader(void); // of the context that is present
