// From what GLFW tells to the window's queue of events.
#include "preview/window_internal.h"

#define glfw window_glfw

static Window *window_of(GLFWwindow *handle)
{
    return glfw.glfwGetWindowUserPointer(handle);
}

// A movement is added to the last event where that is the same movement: a slow frame must not leave a long queue.
static bool add_to_last(Window *window, const WindowEvent *event)
{
    if (window->waiting == 0)
        return false;
    WindowEvent *last = &window->events[(window->oldest + window->waiting - 1) % MOST_EVENTS];
    if (event->type == WINDOW_EVENT_KEY || last->type != event->type || last->button != event->button ||
        last->shift != event->shift)
        return false;
    last->x += event->x;
    last->y += event->y;
    return true;
}

static void put_event(Window *window, WindowEvent event)
{
    if (add_to_last(window, &event) || window->waiting == MOST_EVENTS) // nobody has asked for a long time
        return;
    window->events[(window->oldest + window->waiting++) % MOST_EVENTS] = event;
}

bool window_next_event(Window *window, WindowEvent *event)
{
    if (window->waiting == 0)
        return false;
    *event = window->events[window->oldest];
    window->oldest = (window->oldest + 1) % MOST_EVENTS;
    window->waiting--;
    return true;
}

static void put_key(Window *window, int key)
{
    put_event(window,
              (WindowEvent){.type = WINDOW_EVENT_KEY, .key = key, .shift = window->shift, .repeat = window->repeat});
}

static void on_key(GLFWwindow *handle, int key, int scancode, int action, int modifiers)
{
    (void)scancode;
    static const int SILENT[][2] = {{GLFW_KEY_LEFT, WINDOW_LEFT}, {GLFW_KEY_RIGHT, WINDOW_RIGHT},
                                    {GLFW_KEY_UP, WINDOW_UP},     {GLFW_KEY_DOWN, WINDOW_DOWN},
                                    {GLFW_KEY_TAB, WINDOW_TAB},   {GLFW_KEY_ESCAPE, WINDOW_ESCAPE}};
    Window *window = window_of(handle);
    if (action == GLFW_RELEASE)
        return;
    window->last_key = key;
    window->shift = modifiers & GLFW_MOD_SHIFT;
    window->repeat = action == GLFW_REPEAT;
    for (size_t i = 0; i < sizeof SILENT / sizeof *SILENT; i++)
        if (key == SILENT[i][0])
            put_key(window, SILENT[i][1]);
}

// Comes after on_key for the same key.
static void on_character(GLFWwindow *handle, unsigned character)
{
    Window *window = window_of(handle);
    int key = (int)character;
    if (character > 126) { // a keyboard that writes another script: the letter that is printed there in Latin
        if (window->last_key < GLFW_KEY_A || window->last_key > GLFW_KEY_Z)
            return;
        key = window->last_key;
    }
    if (key >= 'A' && key <= 'Z')
        key += 'a' - 'A';
    put_key(window, key == '=' ? '+' : key);
}

static void on_button(GLFWwindow *handle, int button, int action, int modifiers)
{
    Window *window = window_of(handle);
    if (action == GLFW_PRESS && window->button < 0 && button <= GLFW_MOUSE_BUTTON_MIDDLE) {
        window->button = button;
        window->drag_shift = modifiers & GLFW_MOD_SHIFT;
    } else if (action == GLFW_RELEASE && button == window->button) {
        window->button = -1;
    }
}

// The mouse comes in units of the screen, of which a fine display has fewer than pixels.
static void on_movement(GLFWwindow *handle, double x, double y)
{
    Window *window = window_of(handle);
    double right = x - window->x, down = y - window->y;
    bool known = window->mouse_known;
    window->x = x;
    window->y = y;
    window->mouse_known = true;
    if (window->button < 0 || !known)
        return;
    int width, height, pixels_across, pixels_down;
    glfw.glfwGetWindowSize(handle, &width, &height);
    glfw.glfwGetFramebufferSize(handle, &pixels_across, &pixels_down);
    if (width < 1 || height < 1)
        return;
    put_event(window, (WindowEvent){.type = WINDOW_EVENT_DRAG,
                                    .button = window->button,
                                    .shift = window->drag_shift,
                                    .x = (float)(right * pixels_across / width),
                                    .y = (float)(down * pixels_down / height)});
}

static void on_scroll(GLFWwindow *handle, double x, double y)
{
    put_event(window_of(handle), (WindowEvent){.type = WINDOW_EVENT_SCROLL, .x = (float)x, .y = (float)y});
}

static void on_size(GLFWwindow *handle, int width, int height)
{
    (void)width, (void)height;
    put_event(window_of(handle), (WindowEvent){.type = WINDOW_EVENT_RESIZE});
}

static void on_refresh(GLFWwindow *handle)
{
    put_event(window_of(handle), (WindowEvent){.type = WINDOW_EVENT_REFRESH});
}

static void on_close(GLFWwindow *handle)
{
    put_event(window_of(handle), (WindowEvent){.type = WINDOW_EVENT_CLOSE});
}

void window_listen(Window *window)
{
    window->button = -1;
    glfw.glfwSetWindowUserPointer(window->handle, window);
    glfw.glfwSetKeyCallback(window->handle, on_key);
    glfw.glfwSetCharCallback(window->handle, on_character);
    glfw.glfwSetMouseButtonCallback(window->handle, on_button);
    glfw.glfwSetCursorPosCallback(window->handle, on_movement);
    glfw.glfwSetScrollCallback(window->handle, on_scroll);
    glfw.glfwSetFramebufferSizeCallback(window->handle, on_size);
    glfw.glfwSetWindowRefreshCallback(window->handle, on_refresh);
    glfw.glfwSetWindowCloseCallback(window->handle, on_close);
}
