// The window's state, and what keys and mouse do to it.
#ifndef PHOTONLAB_PREVIEW_APP_H
#define PHOTONLAB_PREVIEW_APP_H

#include "preview/snapshot.h"
#include "preview/window.h"

typedef struct {
    const Scene *scene;
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

    bool turning; // --orbit: the camera turns by itself for a while, and tells how fast
    double turning_since;
    long frames, frames_at_start;
    bool orbit_done;
    bool wants_rest; // tell when all photons are drawn after that
} App;

#define MOVING_POINTS 50000 // photons drawn while the camera moves

void app_listen(App *app); // has GLFW call these:
void app_key(App *app, int key);
void app_drag(App *app, float right, float down); // pixels
void app_scroll(App *app, float notches);         // > 0: away from the user, nearer to the scene
void app_resize(App *app, int width, int height);

const char *app_key_list(void); // what each key does, in lines
void app_moved(App *app);       // to be called when the camera did

// Turns on while --orbit lasts; prints "orbit: F frames a second, with N photons drawn" at its end.
void app_turn_by_itself(App *app, double now);
// After a frame: prints "rest: T s until all N photons were drawn" for the first that follows --orbit.
void app_note_rest(App *app, bool all_drawn);

#endif
