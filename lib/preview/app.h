// The window's state, and what keys and mouse do to it.
#pragma once

#include "preview/session.h"
#include "preview/window.h"

typedef struct {
    const Scene *scene; // the session's, when it was last looked at
    int stage;          // likewise
    Orbit home;         // the scene's camera, or that of the flags
    Window *window;
    Canvas *canvas;
    Session session;
    View view;
    int width, height; // of the framebuffer, pixels; 0 when the window is an icon

    int key;                 // that is acted on: GLFW's number, or the lower-case character that it writes
    int last_key;            // GLFW's
    bool repeat;             // it is still held down
    int button;              // that drags: 0 left, 1 right, 2 middle; −1: none
    bool drag_shift;         // the shift key was down when that began
    bool mouse_known;        // since when it has been where it last was
    double mouse_x, mouse_y; // in GLFW's units

    bool dirty;            // something to draw
    bool moving;           // the camera moves, or has just done so: few points are drawn
    double moved_at;       // clock_seconds
    bool flying;           // slow light
    double flight_started; // clock_seconds
    bool quit;

    enum { NOT_TURNED, TURNING, TURNED, RESTED } orbit; // --orbit: the camera turns by itself for a while
    double turning_since;                               // clock_seconds
    long frames;                                        // that were drawn since then
} App;

void app_listen(App *app); // has GLFW call app_key, and do what the mouse says
void app_key(App *app, int key);
const char *app_key_list(void); // what each key does, in lines
void app_moved(App *app);       // to be called when the camera did
