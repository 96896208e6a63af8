// A window on the screen with OpenGL in it, by GLFW, which is looked for at run time.
#ifndef PHOTONLAB_PREVIEW_WINDOW_H
#define PHOTONLAB_PREVIEW_WINDOW_H

#include "preview/draw/canvas.h"

typedef struct Window Window;

// One window at a time; all calls from the thread that made it. Without a title it is never shown, but drawn by the same
// OpenGL. The context (3.3 core) is present from here on. The error says why there is none: no display, no GLFW (and what
// to install), no OpenGL 3.3.
Window *window_create(const char *title, int width, int height, Error *error);
void window_free(Window *window);

GlLoader window_loader(void);                                                // of the context that is present
void window_framebuffer_size(const Window *window, int *width, int *height); // pixels; 0 when it is an icon

typedef enum {
    WINDOW_EVENT_KEY,
    WINDOW_EVENT_DRAG,   // the mouse moved with a button down
    WINDOW_EVENT_SCROLL, // the wheel, or two fingers
    WINDOW_EVENT_RESIZE,
    WINDOW_EVENT_REFRESH, // what was shown is lost: draw again
    WINDOW_EVENT_CLOSE
} WindowEventType;

// Keys that write nothing; others are the character written: small ASCII letters, digits, '+', '-', ' ', … by the user's
// own keyboard layout. '=' comes as '+', for it is the same key on many keyboards.
enum { WINDOW_LEFT = 256, WINDOW_RIGHT, WINDOW_UP, WINDOW_DOWN, WINDOW_ESCAPE, WINDOW_TAB };

typedef struct {
    WindowEventType type;
    int key;     // KEY
    bool repeat; // KEY: it is still held down
    bool shift;  // KEY, DRAG: the shift key was down
    int button;  // DRAG: 0 left, 1 right, 2 middle
    float x, y;  // DRAG: pixels of the framebuffer to the right and down; SCROLL: y > 0 away from the user
} WindowEvent;

// Sleeps until there is an event or the time is up; 0 takes what has come without waiting.
void window_wait(Window *window, double seconds);
// The oldest event. False when there is none. Movements that follow each other come as one.
bool window_next_event(Window *window, WindowEvent *event);

void window_swap(Window *window); // shows what canvas_present has put there

#endif
