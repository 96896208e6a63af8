// What GLFW tells of keys and mouse, while it waits or polls.
#include "preview/app.h"
#include "base/parallel.h"

#include <math.h>
#include <stdio.h>

void app_moved(App *app)
{
    app->dirty = true;
    app->moved_at = clock_seconds();
    app->moving = true;
}

static App *app_of(Window *window)
{
    return glfw.glfwGetWindowUserPointer(window);
}

static void on_key(Window *window, int key, int scancode, int action, int modifiers)
{
    (void)scancode, (void)modifiers;
    App *app = app_of(window);
    if (action == GLFW_RELEASE)
        return;
    app->last_key = key;
    app->repeat = action == GLFW_REPEAT;
    if (key >= GLFW_KEY_ESCAPE) // it writes nothing
        app_key(app, key);
}

// Comes after on_key for the same key: by the user's own keyboard layout.
static void on_character(Window *window, unsigned character)
{
    App *app = app_of(window);
    int key = (int)character;
    if (character > 126) { // a keyboard that writes another script: the letter that is printed there in Latin
        if (app->last_key < GLFW_KEY_A || app->last_key > GLFW_KEY_Z)
            return;
        key = app->last_key;
    }
    if (key >= 'A' && key <= 'Z')
        key += 'a' - 'A';
    app_key(app, key == '=' ? '+' : key); // one key on many keyboards
}

// The mouse comes in units of the screen, of which a fine display has fewer than pixels.
static void pixels_of(App *app, double *x, double *y)
{
    int width, height;
    glfw.glfwGetWindowSize(app->window, &width, &height);
    *x *= width > 0 ? (double)app->width / width : 0.0;
    *y *= height > 0 ? (double)app->height / height : 0.0;
}

static int step_under_mouse(App *app)
{
    double x = app->mouse_x, y = app->mouse_y;
    pixels_of(app, &x, &y);
    const Coach *coach = &app->session.coach;
    int step = coach->judging ? panel_step_at(app->canvas, &app->view, (float)x, (float)y) : -1;
    return step < (int)coach->verdicts.count ? step : -1;
}

static void on_button(Window *window, int button, int action, int modifiers)
{
    App *app = app_of(window);
    int step = action == GLFW_PRESS && button == GLFW_MOUSE_BUTTON_LEFT ? step_under_mouse(app) : -1;
    if (step >= 0) {
        session_show_step(&app->session, coach_go_to(&app->session.coach, (size_t)step));
        app->dirty = true;
    } else if (action == GLFW_PRESS && app->button < 0 && button <= GLFW_MOUSE_BUTTON_MIDDLE) {
        app->button = button;
        app->drag_shift = modifiers & GLFW_MOD_SHIFT;
    } else if (action == GLFW_RELEASE && button == app->button) {
        app->button = -1;
    }
}

// Pixels.
static void drag(App *app, float right, float down)
{
    right /= (float)app->height;
    down /= (float)app->height;
    if (app->button == 0 && !app->drag_shift)
        view_turn(&app->view, right, down);
    else
        view_move(&app->view, right, down);
    app_moved(app);
}

static void on_movement(Window *window, double x, double y)
{
    App *app = app_of(window);
    double right = x - app->mouse_x, down = y - app->mouse_y;
    bool known = app->mouse_known;
    app->mouse_x = x;
    app->mouse_y = y;
    app->mouse_known = true;
    pixels_of(app, &right, &down);
    if (app->button >= 0 && known)
        drag(app, (float)right, (float)down);
}

// Away from the user: nearer to the scene.
static void on_scroll(Window *window, double right, double up)
{
    (void)right;
    App *app = app_of(window);
    view_zoom(&app->view, powf(0.9f, (float)up));
    app_moved(app);
}

static void on_size(Window *window, int width, int height)
{
    App *app = app_of(window);
    Error error = {""};
    app->width = width;
    app->height = height;
    app->view.scale = window_scale(window); // it may have moved to another monitor
    if (width > 0 && height > 0 && !canvas_resize(app->canvas, width, height, &error))
        fprintf(stderr, "%s\n", error.message);
    app->dirty = true;
}

// What was shown is lost.
static void on_refresh(Window *window)
{
    app_of(window)->dirty = true;
}

static void on_close(Window *window)
{
    app_of(window)->quit = true;
}

void app_listen(App *app)
{
    app->button = -1;
    glfw.glfwSetWindowUserPointer(app->window, app);
    glfw.glfwSetKeyCallback(app->window, on_key);
    glfw.glfwSetCharCallback(app->window, on_character);
    glfw.glfwSetMouseButtonCallback(app->window, on_button);
    glfw.glfwSetCursorPosCallback(app->window, on_movement);
    glfw.glfwSetScrollCallback(app->window, on_scroll);
    glfw.glfwSetFramebufferSizeCallback(app->window, on_size);
    glfw.glfwSetWindowRefreshCallback(app->window, on_refresh);
    glfw.glfwSetWindowCloseCallback(app->window, on_close);
}
