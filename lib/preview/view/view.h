// What the preview shows, and how it is drawn: from photons to vertices. Nothing here knows a window or a process.
#pragma once

#include "preview/draw/canvas.h"
#include "preview/record/recording.h"
#include "preview/record/verdicts.h"
#include "scene/scene.h"

typedef enum {
#define VIEW(kind, name) VIEW_##kind,
#include "preview/view/views.def"
#undef VIEW
    VIEW_COUNT
} ViewKind;

typedef enum { COLOUR_POWER, COLOUR_PHOTON, COLOUR_BOUNCE, COLOUR_MATERIAL } ColourMode;
#define COLOUR_COUNT 4
extern const char *const colour_names[COLOUR_COUNT + 1], *const view_names[VIEW_COUNT + 1]; // for flags; end with NULL

// Of views that have no place in the scene: how many times nearer than at first, and how far to the side, in heights of
// the picture as it was at first.
typedef struct {
    float zoom, right, up;
} Framing;
#define LEAST_ZOOM 0.01f
#define MOST_ZOOM  1e4f

// What a view lets one choose: a flag of `photonlab preview`, and a number in View.settings.
#define MOST_SETTINGS 4
typedef struct {
    const char *flag; // "exponent" for --exponent
    enum { SETTING_WHOLE, SETTING_NUMBER, SETTING_SWITCH } kind;
    double start;      // without the flag. Below `low`: nothing is chosen
    double low, high;  // that the flag takes
    char key;          // of a switch: turns it on and off
    const char *words; // about the key
} ViewSetting;
enum { LOBE_EXPONENT, LOBE_ANGLE, LOBE_DIFFUSE }; // VIEW_LOBE's, which its samples depend on

// All that decides what a picture looks like, apart from the photons.
typedef struct {
    ViewKind kind;
    ColourMode colour;
    Orbit orbit;
    Framing framing;
    bool split;         // the reference beside the student's
    bool wireframe;     // of the scene
    double flight;      // photons are drawn that have flown no farther, m; negative: all
    size_t most_points; // drawn; 0: all
    bool help;          // the list of keys
    float exposure;     // of photons and pictures, stops: one more is twice as bright
    float panel;        // width of the column of words beside the picture, ems; 0: there is none, and no words
    float scale;        // of words, as canvas_text has it; 0: by the picture's size
    double settings[VIEW_COUNT][MOST_SETTINGS];
} View;

// What one half of the picture shows, the student's data or the reference's, and the vertices made of it.
typedef struct ViewData ViewData;
ViewData *view_data_create(Canvas *canvas, const Scene *scene);
void view_data_free(ViewData *data);
void view_data_record(ViewData *data, Recording recording);           // takes it over
const Recording *view_data_recording(const ViewData *data);           // empty (count 0) at first
void view_data_find(ViewData *data, RunKind kind, Findings findings); // takes them over

typedef struct Pane Pane;
typedef struct Legend Legend;
typedef struct Vertices Vertices;

// One view; the list of them is views.def. What may be left out says so.
typedef struct {
    const char *help;   // in `photonlab preview --help`: what it shows, and its flags; lines
    const char *arrows; // what ←/→ and ↑/↓ choose, for the list of keys; with `choose`, or NULL
    enum {
        IN_THE_SCENE, // among its wires, from the camera's place
        ON_A_STAND,   // alone; turned as the scene is, and moved by View.framing
        ON_A_SHEET    // alone; moved by View.framing
    } place;
    float wires;                         // IN_THE_SCENE: how bright the scene's wires are, 0…1
    bool in_flight;                      // shows photons on their way: slow light has a meaning
    RunKind shows;                       // RUN_PHOTONS, or the findings that it needs
    ViewSetting settings[MOST_SETTINGS]; // those with a flag; may be none
    // What is shown, as lists of vertices; again when there is other data, or other settings, colours or flight.
    void (*build)(const View *view, ViewData *data, Vertices *lists);
    void (*draw)(const Pane *pane); // draws the lists that `build` made
    // Lines about what is shown: "photon 17, bounce 2 of 5, red, 0.0012 W". After `draw`.
    void (*describe)(const View *view, const ViewData *data, char *text, size_t size);
    // What the colours mean, by legend_add. NULL: nothing.
    void (*legend)(const View *view, const ViewData *data, Legend *legend);
    // An arrow: `step` is 1 or −1, `sideways` for ←/→. NULL: there is nothing to choose.
    void (*choose)(View *view, const ViewData *data, bool sideways, int step);
    size_t found_size; // of what `build` finds out: Made.found, zeroed at first; may be 0
} ViewType;

extern const ViewType *const view_types[VIEW_COUNT];
static inline const ViewType *view_type(const View *view)
{
    return view_types[view->kind];
}

View view_default(const Scene *scene);
static inline float view_brightness(const View *view)
{
    return exp2f(view->exposure);
}
#define MOST_EXPOSURE 12.0f

#define NARROW_PANEL 21.0f // ems
#define WIDE_PANEL   30.0f

// Whose mark in the panel stands at this pixel; −1: no step's.
int panel_step_at(Canvas *canvas, const View *view, float x, float y);

// The pixels of the canvas that the picture has, left of the panel.
typedef struct {
    int width, height;
} Area;
Area view_area(const Canvas *canvas, const View *view);
#define FRAMING_DEFAULT ((Framing){1.0f, 0.0f, 0.0f})

// As who holds the scene, or the sheet, moves it: in heights of the picture, to the right and down. Turned is what can be
// turned; the rest is moved.
void view_turn(View *view, float right, float down);
void view_move(View *view, float right, float down);
void view_zoom(View *view, float factor);                      // of the distance
void view_frame(View *view, const Scene *scene, float aspect); // all of it fits

// A picture, RGBA rows from the top; NULL: none.
typedef struct {
    const uint8_t *rgba;
    int columns, rows;
} Picture;

// What is said beside the picture. How it is said, the panel decides.
typedef struct {
    const char *status;       // photons, bounces, time, who plays what, last build; NULL: none
    const char *banner;       // faults; NULL or "": none
    bool banner_is_old;       // a newer build is under way
    const Verdicts *verdicts; // NULL: nobody judges
    const char *source;       // the folder of the steps' files
    const char *help;         // lines of keys; shown when view->help
    const char *rendered;     // about the pictures
    Picture pictures[2];      // in place of the photons, yours and the reference's
} Captions;

// Draws everything; `reference` is needed for a split view only. Leaves the finished picture in the canvas.
void view_draw(Canvas *canvas, const View *view, ViewData *yours, ViewData *reference, const Captions *captions);
