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
    int width, height; // of the framebuffer, pixels

    int key;               // that was pressed last
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

// key: a lower-case character or WINDOW_…; `repeat`: it is still held down.
void app_key(App *app, int key, bool repeat);
const char *app_key_list(void); // what each key does, in lines
// Pixels, of the mouse; button 0 left, 1 right, 2 middle.
void app_drag(App *app, int button, bool shift, float right, float down);
void app_scroll(App *app, float notches); // > 0: nearer
void app_resize(App *app);
void app_moved(App *app); // to be called when the camera did

// Turns on while --orbit lasts; prints "orbit: F frames a second, with N photons drawn" at its end.
void app_turn_by_itself(App *app, double now);
// After a frame: prints "rest: T s until all N photons were drawn" for the first that follows --orbit.
void app_note_rest(App *app, bool all_drawn);

#endif
