// The window's state, and what keys and mouse do to it.
#ifndef PHOTONLAB_PREVIEW_APP_H
#define PHOTONLAB_PREVIEW_APP_H

#include "preview/snapshot.h"
#include "preview/window.h"

typedef struct {
    const Scene *scene;
    const PreviewOptions *options;
    Window *window;
    Canvas *canvas;
    Session session;
    View view;
    int width, height; // of the framebuffer, pixels

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
#define REST_SECONDS  0.05  // without a movement: all of them

bool app_start(App *app, const Scene *scene, const PreviewOptions *options, Broker *broker, Window *window,
               Error *error);
void app_end(App *app);

// key: a lower-case character or WINDOW_….
void app_key(App *app, int key);
// Pixels, of the mouse; button 0 left, 1 right, 2 middle.
void app_drag(App *app, int button, bool shift, float right, float down);
void app_scroll(App *app, float notches); // > 0: nearer
void app_resize(App *app);
void app_moved(App *app); // to be called when the camera did

// The answer to a save is wanted soon: a fair part of its photons first, all of them in the next frame.
void app_hurry(App *app, double now);
// A part of the photons has to do, since the camera moves, light flies, or the rest of them is still traced.
bool app_is_hurried(const App *app);
// m/s, of slow light: it takes some ten seconds through the scene.
double app_light_speed(const App *app);
// Turns on while --orbit lasts; prints "orbit: F frames a second, with N photons drawn" at its end.
void app_turn_by_itself(App *app, double now);
// After a frame: prints "rest: T s until all N photons were drawn" for the first that follows --orbit.
void app_note_rest(App *app, bool all_drawn);

#endif
