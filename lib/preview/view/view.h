// What the preview shows, and how it is drawn: from photons to vertices. Nothing here knows a window.
#ifndef PHOTONLAB_PREVIEW_VIEW_H
#define PHOTONLAB_PREVIEW_VIEW_H

#include "preview/draw/canvas.h"
#include "preview/record/recording.h"
#include "scene/scene.h"

typedef enum {
    VIEW_POINTS, // stored photons as points
    VIEW_PATHS,  // paths as lines; one of them chosen
    VIEW_LOBE,   // samples of the scatter step as a cloud over the lobe of the equation
    VIEW_SCREEN, // arrivals on one surface, flattened to a plane
    VIEW_TREE    // cells of the kd-tree
} ViewKind;
#define VIEW_COUNT 5

typedef enum { COLOUR_POWER, COLOUR_PHOTON, COLOUR_BOUNCE, COLOUR_MATERIAL } ColourMode;
#define COLOUR_COUNT 4

// Of the lobe and the screen, which have no place in the scene: how many times nearer than at first, and how far to the
// side, in heights of the picture as it was at first.
typedef struct {
    float zoom, right, up;
} Framing;
#define LEAST_ZOOM 0.01f
#define MOST_ZOOM  1e4f

// All that decides what a picture looks like, apart from the photons.
typedef struct {
    ViewKind kind;
    ColourMode colour;
    Orbit orbit;
    Framing framing;
    bool split;            // the reference beside the student's
    bool wireframe;        // of the scene
    long path;             // VIEW_PATHS: the chosen one, −1: all alike
    int bounce;            // of the chosen path, legs up to this one are bright; −1: all
    float exponent, angle; // VIEW_LOBE
    bool diffuse;          // VIEW_LOBE: the diffuse step in place of the glossy one
    int surface;           // VIEW_SCREEN: the surface's number, −1: the one with the most arrivals
    int level;             // VIEW_TREE: depth of the cells
    double flight;         // photons are drawn that have flown no farther, m; negative: all
    size_t most_points;    // drawn; 0: all
    bool help;             // the overlay of keys
} View;

View view_default(const Scene *scene);
#define FRAMING_DEFAULT ((Framing){1.0f, 0.0f, 0.0f})
bool view_is_framed(const View *view);                        // the lobe or the screen?
bool view_kind_parse(const char *name, ViewKind *kind);       // points, paths, lobe, screen, tree
bool colour_mode_parse(const char *name, ColourMode *colour); // power, photon, bounce, material
const char *view_kind_name(ViewKind kind);
const char *colour_mode_name(ColourMode colour);

// One side of the picture: the student's or the reference's data. Vertices are kept in batches until the data or what
// they depend on changes.
typedef struct Side Side;
Side *side_create(Canvas *canvas, const Scene *scene);
void side_free(Side *side);
void side_set_recording(Side *side, Recording recording); // takes it over
const Recording *side_recording(const Side *side);        // empty (count 0) at first
void side_set_lobe(Side *side, LobeSamples samples);      // takes it over

// What the text around the picture says.
typedef struct {
    const char *status; // at the bottom: photons, bounces, time, who plays what, last build; NULL: none
    const char *banner; // a fault, in red at the top; NULL: none
    const char *help;   // lines of keys; shown when view->help
    const char *left_title, *right_title; // of a split view
    const uint8_t *picture;               // RGBA rows from the top, shown in place of the photons; NULL: none
    int picture_columns, picture_rows;
    bool bare; // nothing but the picture: no text, no bars, no legend
} Captions;

// Draws everything; `reference` is needed for a split view only. Leaves the finished picture in the canvas.
void view_draw(Canvas *canvas, const Scene *scene, const View *view, Side *yours, Side *reference,
               const Captions *captions);
// Lines about the chosen path or surface for the overlay: "photon 17, bounce 2 of 5, red, 0.0012 W".
void view_describe(const View *view, const Scene *scene, const Side *yours, char *text, size_t size);

#endif
