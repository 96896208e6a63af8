// What the files of the view share.
#ifndef PHOTONLAB_PREVIEW_VIEW_INTERNAL_H
#define PHOTONLAB_PREVIEW_VIEW_INTERNAL_H

#include "math/frame.h"
#include "photons/photon_map.h"
#include "preview/view/view.h"

typedef struct {
    uint8_t r, g, b, a;
} Rgba;

// Vertices on their way to a batch. Grows; `lost` when memory was short, and then it takes no more.
typedef struct {
    Vertex *items;
    size_t count, room;
    bool lost;
} Vertices;

void vertices_free(Vertices *list);
bool vertices_reserve(Vertices *list, size_t more);
void vertices_point(Vertices *list, Vec3 at, Rgba colour);
void vertices_line(Vertices *list, Vec3 from, Vec3 to, Rgba colour);
void vertices_fading(Vertices *list, Vec3 from, Vec3 to, Rgba start, Rgba end);
// A circle of this radius, about the centre, through `across` and `along` (unit, at right angles).
void vertices_circle(Vertices *list, Vec3 centre, Vec3 across, Vec3 along, float radius, Rgba colour);
void vertices_box(Vertices *list, Box box, Rgba colour);

// A batch, and what it was made of.
#define KEY_SIZE 6
typedef struct {
    Batch *batch;
    bool valid;
    double key[KEY_SIZE];
} Cache;
// True when it was made of this already. Otherwise it counts as made of it from now on.
bool cache_is(Cache *cache, const double key[KEY_SIZE]);
// Uploads the vertices, and frees them.
void cache_fill(Canvas *canvas, Cache *cache, Vertices *list);

struct Side {
    Canvas *canvas;
    const Scene *scene;
    Recording recording;
    LobeSamples lobe;
    Cache wires, points, paths, screen, tree, tree_points, lobe_lines, lobe_points;
    float *flown;   // of the points, in their order, when they are sorted by it
    float power;    // W: a bright photon's
    PhotonMap *map; // NULL: not built
    int cell_level;
    size_t cells, largest_cell;
    int screen_surface; // the busiest; −2: not looked for yet
    size_t arrivals, arrivals_inside;
    size_t lobe_absorbed, lobe_below, lobe_long;
};

// Where one side is drawn.
typedef struct {
    Canvas *canvas;
    const Scene *scene;
    const View *view;
    Side *side;
    int left, top, width, height; // pixels
    float scale;                  // of the text, and of points
} Pane;

void pane_look(const Pane *pane, const Orbit *orbit, Box box);
// The same, everything moved by so many pixels: lines drawn twice are twice as wide.
void pane_look_beside(const Pane *pane, const Orbit *orbit, Box box, float right, float down);

// Nearer and to the side, as the view says, from where the lobe or the screen is seen at first.
void pane_frame(const Framing *framing, Orbit *orbit);

void view_points_draw(const Pane *pane);
void view_paths_draw(const Pane *pane);
void view_lobe_draw(const Pane *pane);
void view_screen_draw(const Pane *pane);
void view_tree_draw(const Pane *pane);
void wireframe_draw(const Pane *pane, float strength); // 0…1
void wireframe_build(const Scene *scene, Vertices *list);

// ---- points ----
// Factor on colours such that so many photons over so many pixels make a picture of middle brightness.
float points_exposure(size_t count, float pixels, float point_size);
float points_size(size_t count, float pixels, float scale);
// Of the scene's photons, pixels that they are spread over.
float points_area(const Pane *pane);
Rgba points_colour(const Side *side, ColourMode mode, const StoredPhoton *photon);

// ---- paths ----
// The chosen path's legs; *count 0 when it has none.
const PathLeg *path_legs(const Recording *recording, long path, size_t *count);
// The part that has been flown, 0…1.
float leg_flown(const PathLeg *leg, double flight);

// ---- lobe ----
// Density over directions, 1/sr, of the step that this view shows, in coordinates about the normal +z with the mirror
// direction in the xz plane. `table` is of view->exponent.
float lobe_density(const View *view, StepChoice play, const LobeTable *table, Vec3 direction);
Vec3 lobe_mirror(const View *view);
typedef struct {
    const View *view;
    StepChoice play;
    LobeTable *table; // of view->exponent; the caller frees it
    float peak;       // the highest density: it reaches out to 1
} Lobe;
bool lobe_prepare(const View *view, StepChoice play, Lobe *lobe); // false: no memory
// A point for each of the side's samples that is up to it, on the view's own stage: up is +y, the mirror direction lies
// on the side of +x. Counts what is wrong with the others: side->lobe_absorbed and so on.
void lobe_cloud(const Lobe *lobe, Side *side, Vertices *list);

// ---- screen ----
int screen_busiest(const Scene *scene, const Recording *recording); // −1: there is none
// Where a photon lies on a flat, 0…1 each; false when it is not on it.
bool screen_place(const Flat *flat, uint8_t material, const StoredPhoton *photon, float tolerance, float *u, float *v);
int screen_surface(Side *side, const View *view); // the one that is shown

// ---- tree ----
// Box of the photons that cell i of 2^level holds.
Box tree_cell(const PhotonMap *map, int level, size_t i, size_t *count);
int tree_depth(const PhotonMap *map);

// ---- colours ----
extern const Rgba COLOUR_OF_LIGHTS, COLOUR_OF_TEXT, COLOUR_OF_HINTS;
Rgba palette_photon(int colour);
Rgba palette_bounce(int bounce);
Rgba palette_material(int material);
Rgba palette_hue(float hue); // 0…1
Rgba rgba_fade(Rgba colour, float alpha);
Rgba rgba_of_power(Colour power, float full); // `full` W shows at full brightness
const char *photon_colour_name(int colour);
#define BOUNCE_COLOURS 8

// ---- words ----
float overlay_scale(const Canvas *canvas);
// Breaks lines at spaces so that they fit; returns how many there are. At most `most`: the last then ends in "..".
int overlay_wrap(const char *text, float scale, float width, int most, char *wrapped, size_t size);
// Text on a dark plate; (x, y) its top left corner. Returns the plate's height.
float overlay_plate(Canvas *canvas, float x, float y, float scale, Rgba ink, Rgba plate, const char *text);
void overlay_draw(Canvas *canvas, const View *view, const Scene *scene, Side *yours, const Captions *captions);
void legend_draw(Canvas *canvas, const View *view, const Scene *scene, const Side *side, float top);

#endif
