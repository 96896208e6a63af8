// What the files of the views share.
#pragma once

#include "math/frame.h"
#include "photons/photon_map.h"
#include "preview/view/view.h"

// Vertices on their way to a buffer. Grows; what comes when memory is short is left out.
struct Vertices {
    Vertex *items;
    size_t count, capacity;
};

void vertices_free(Vertices *list);
bool vertices_reserve(Vertices *list, size_t more); // where many are to come, so that it need not grow
void vertices_point(Vertices *list, Vec3 at, Rgba colour);
void vertices_line(Vertices *list, Vec3 from, Vec3 to, Rgba colour);
void vertices_fading(Vertices *list, Vec3 from, Vec3 to, Rgba start, Rgba end);
// A circle of this radius, about the centre, through `across` and `along` (unit, at right angles).
void vertices_circle(Vertices *list, Vec3 centre, Vec3 across, Vec3 along, float radius, Rgba colour);
void vertices_box(Vertices *list, Box box, Rgba colour);
// Uploads the vertices, and frees them.
void vertices_upload(Vertices *list, Canvas *canvas, VertexBuffer *buffer);

#define MOST_LISTS 3

// What a view has made of the data.
typedef struct {
    double key[5 + MOST_SETTINGS]; // all that it depends on
    VertexBuffer lists[MOST_LISTS];
    void *found; // ViewType.found_size bytes
} Made;

struct ViewData {
    Canvas *canvas;
    const Scene *scene;
    Recording recording;
    PhotonMap *map; // of its photons, once a view has made it; NULL: none
    Findings findings[RUN_RENDER];
    int come[RUN_RENDER]; // how many recordings and findings there have been
    float power;          // W: a bright photon's
    VertexBuffer wires;
    Made made[VIEW_COUNT];
};

// Where one half is drawn.
struct Pane {
    const View *view;
    ViewData *data;
    int left, width, height; // pixels; from the canvas's top
    float scale;             // of points
};

// Everything is moved by so many pixels: lines drawn twice are twice as wide.
void pane_look(const Pane *pane, const Orbit *orbit, Box box, float right, float down);
void pane_look_at_scene(const Pane *pane);
// From above, all of the box, which lies on the plane z = 0; as the view is framed. How many pixels it is high.
float pane_look_at_sheet(const Pane *pane, Box box);
// Nearer and to the side, as the view says, from where a view with no place in the scene is seen at first.
void pane_frame(const Framing *framing, Orbit *orbit);
// A list of the view's.
void pane_draw(const Pane *pane, int list, DrawStyle style);

void wireframe_draw(const Pane *pane, float strength); // 0…1
void wireframe_build(const Scene *scene, Vertices *list);

// ", yours": who plays this step.
const char *whose_step(const ViewData *data, const char *id);

// The value, or the other end of low…high where it is past one.
double wrap(double value, double low, double high);

// ---- points ----
// Factor on colours such that so many photons over so many pixels make a picture of middle brightness.
float points_exposure(size_t count, float pixels, float point_size);
// A list's first photons, over so many pixels; `strength` 1: of middle brightness.
void pane_draw_points(const Pane *pane, int list, size_t count, float area, float strength);
// How many of so many photons are drawn.
size_t points_drawn(const View *view, size_t count);
// Of the scene's photons, pixels that they are spread over.
float points_area(const Pane *pane);
Rgba points_colour(const ViewData *data, ColourMode mode, const StoredPhoton *photon);

// ---- paths ----
// The chosen path's legs; *count 0 when it has none.
const PathLeg *path_legs(const Recording *recording, long path, size_t *count);
// The part that has been flown, 0…1.
float leg_flown(const PathLeg *leg, double flight);

// ---- lobe ----
// What step 2.3, 2.4 or 1.3 should do: directions about the normal +z, with the mirror direction in the xz plane.
typedef struct {
    float exponent;
    Vec3 mirror; // the mirror direction
    bool diffuse;
    StepChoice play;
    LobeTable table; // of the exponent
    float peak;      // the highest density: it reaches out to 1
} Lobe;
// `angle` of the mirror direction to the normal, degrees.
Lobe lobe_of(float exponent, float angle, bool diffuse, StepChoice play);
float lobe_density(const Lobe *lobe, Vec3 direction); // over directions, 1/sr
// What an estimate from the disk of radius r about a direction comes to where samples are right, 1/sr; *share of them lies in it.
float lobe_expected(const Lobe *lobe, Vec3 direction, float r, float *share);
// As it stands before the viewer: up is the normal, +y, and the mirror direction lies on the side of +x.
Vec3 lobe_upright(Vec3 local);
// Samples that were absorbed, point into the surface, or are not of length 1.
typedef struct {
    size_t absorbed, below, not_unit;
} LobeCounts;
// A point for each sample that is up to it, upright.
#define LOBE_NEAREST 1000 // samples in an estimate: 3.2 % of noise
void lobe_cloud(const Lobe *lobe, const Findings *samples, LobeCounts *counts, Vertices *list);

// ---- screen ----
int screen_busiest(const Scene *scene, const Recording *recording); // −1: there is none
// Where a photon lies on a flat, 0…1 each; false when it is not on it.
bool screen_place(const Flat *flat, uint8_t material, const StoredPhoton *photon, float tolerance, float *u, float *v);

// ---- tree ----
// Box of the photons that cell i of 2^level holds.
Box tree_cell(const PhotonMap *map, int level, size_t i, size_t *count);
int tree_depth(const PhotonMap *map);

// ---- colours ----
extern const Rgba COLOUR_OF_LIGHTS, COLOUR_OF_TEXT;
Rgba palette_photon(int colour);
Rgba palette_bounce(int bounce);
Rgba palette_material(int material);
Rgba palette_hue(float hue); // 0…1
Rgba rgba_fade(Rgba colour, float alpha);
Rgba rgba_of_power(Colour power, float full); // `full` W shows at full brightness
const char *photon_colour_name(int colour);
#define BOUNCE_COLOURS 8

#define MOST_ENTRIES 12
struct Legend {
    struct {
        Rgba colour;
        char text[40];
    } entries[MOST_ENTRIES];
    int count;
};
// Those past MOST_ENTRIES are left out.
void legend_add(Legend *legend, Rgba colour, const char *format, ...) PRINTF_LIKE(3, 4);
// ViewType.legend of views whose colours are View.colour, or wavelengths.
void legend_of_photons(const View *view, const ViewData *data, Legend *legend);
void legend_of_wavelengths(const View *view, const ViewData *data, Legend *legend);

// ---- words ----
float view_scale(const Canvas *canvas, const View *view);
// Breaks lines at spaces so that they fit; returns how many there are. At most `most`: the last then ends in "..".
int overlay_wrap(const char *text, float scale, float width, int most, char *wrapped, size_t size);
void overlay_draw(Canvas *canvas, const View *view, const ViewData *yours, const Captions *captions);
void panel_draw(Canvas *canvas, const View *view, const ViewData *yours, const Captions *captions);
