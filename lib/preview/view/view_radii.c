// The disks in which progressive photon mapping looks for photons, at points that the eye sees, as pass after pass shrinks
// them (Hachisuka et al. 2008): a map of radii. The photons are shared out among the passes.
#include "preview/view/view_internal.h"

#include <stdio.h>
#include <stdlib.h>

enum { PASS };  // settings: after so many
enum { DISKS }; // caches

#define PASSES 64
#define ACROSS 32 // points of the picture
#define DOWN   24
#define ALPHA  (2.0f / 3.0f)
#define FIRST  6 // photons of one pass in a disk at first, where as many lie as at a typical point

typedef struct {
    Vec3 position, normal;
    float count, radius[PASSES + 1]; // N; R after each number of passes
} Point;

typedef struct {
    Point *points; // NULL: none
    size_t count;
    int recording; // that they are of
} Found;

static void free_found(void *found)
{
    free(((Found *)found)->points);
}

// Rough surfaces that the scene's own camera sees straight.
static void find_points(const Scene *scene, Found *found)
{
    float aspect = (float)scene->settings.width / (float)scene->settings.height;
    found->count = 0;
    for (int i = 0; i < ACROSS * DOWN; i++) {
        Hit hit;
        float x = ((float)(i % ACROSS) + 0.5f) / ACROSS, y = ((float)(i / ACROSS) + 0.5f) / DOWN;
        Ray ray = camera_ray(&scene->camera, x, y, aspect);
        if (scene_intersect(scene, &ray, &hit) && material_is_rough(hit.material))
            found->points[found->count++] = (Point){.position = hit.position, .normal = hit.face_normal};
    }
}

// Of the recording, those that cannot be put into a map left out.
static PhotonMap *map_of_pass(const Recording *recording, int pass)
{
    size_t first = recording->count * (size_t)pass / PASSES, last = recording->count * (size_t)(pass + 1) / PASSES;
    StoredPhoton *photons = malloc((last - first + 1) * sizeof *photons);
    size_t count = 0;
    for (size_t i = first; photons && i < last; i++) {
        Vec3 p = recording->photons[i].at.position;
        if (fabsf(p.x) < 1e18f && fabsf(p.y) < 1e18f && fabsf(p.z) < 1e18f)
            photons[count++] = recording->photons[i].at;
    }
    return photons ? photon_map_build(photons, count, NULL) : NULL;
}

static int compare(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

static float first_radius(const Found *found, const PhotonMap *map)
{
    NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(FIRST)];
    float distance2[ACROSS * DOWN];
    size_t count = 0;
    for (size_t i = 0; i < found->count; i++) {
        float nearest2 = INFINITY;
        if (photon_map_nearest(map, found->points[i].position, FIRST, &nearest2, near) == FIRST)
            distance2[count++] = nearest2;
    }
    qsort(distance2, count, sizeof *distance2, compare);
    return count ? sqrtf(distance2[count / 2]) : 0.0f;
}

// The library's own rule: views play no step.
static void shrink(Point *point, int pass, size_t found)
{
    float kept = point->count + ALPHA * (float)found, all = point->count + (float)found;
    point->radius[pass + 1] = found ? point->radius[pass] * sqrtf(kept / all) : point->radius[pass];
    point->count = kept;
}

static void find_radii(const Recording *recording, Found *found)
{
    for (int pass = 0; pass < PASSES; pass++) {
        PhotonMap *map = map_of_pass(recording, pass);
        size_t most = map ? photon_map_count(map) : 0;
        NearPhoton *near = malloc(PHOTON_MAP_NEAREST_CAPACITY(most) * sizeof *near);
        float first = map && pass == 0 ? first_radius(found, map) : 0.0f;
        for (size_t i = 0; i < found->count; i++) {
            Point *point = &found->points[i];
            if (pass == 0)
                point->radius[0] = first;
            float radius2 = point->radius[pass] * point->radius[pass];
            shrink(point, pass, near && most ? photon_map_nearest(map, point->position, most, &radius2, near) : 0);
        }
        free(near);
        photon_map_free(map);
    }
}

// From red, as at first, to blue, a fifth of that and less.
static Rgba colour_of(float radius, float first)
{
    float shrunk = fminf(fmaxf(-logf(radius / first) / logf(5.0f), 0.0f), 1.0f);
    return palette_hue(0.66f * shrunk);
}

static void build(ViewData *data, const Found *found, int pass)
{
    Vertices list = {.items = NULL};
    for (size_t i = 0; i < found->count; i++) {
        const Point *point = &found->points[i];
        Frame frame = frame_about(point->normal);
        if (point->radius[0] > 0.0f)
            vertices_circle(&list, point->position, frame.tangent, frame.bitangent, point->radius[pass],
                            colour_of(point->radius[pass], point->radius[0]));
    }
    cache_fill(data->canvas, &data->caches[VIEW_RADII][DISKS], &list);
}

static int pass_of(const View *view)
{
    return (int)fmin(view->settings[VIEW_RADII][PASS], PASSES);
}

static void draw(const Pane *pane)
{
    ViewData *data = pane->data;
    Found *found = data->found[VIEW_RADII];
    Cache *disks = &data->caches[VIEW_RADII][DISKS];
    if (!found->points)
        found->points = calloc(ACROSS * DOWN, sizeof *found->points);
    if (!found->points)
        return;
    if (found->recording != data->recordings) {
        find_points(data->scene, found);
        find_radii(&data->recording, found);
        found->recording = data->recordings;
    }
    int pass = pass_of(pane->view);
    if (!cache_is(disks, (const double[KEY_SIZE]){data->recordings, pass}))
        build(data, found, pass);
    pane_look_at_scene(pane);
    pane_draw_cache(pane, disks, 0, disks->buffer.count, (DrawStyle){.kind = DRAW_LINES});
}

static void describe(const View *view, const ViewData *data, char *text, size_t size)
{
    const Found *found = data->found[VIEW_RADII];
    int pass = pass_of(view);
    float least = INFINITY, most = 0.0f;
    for (size_t i = 0; i < found->count; i++) {
        least = fminf(least, found->points[i].radius[pass]);
        most = fmaxf(most, found->points[i].radius[pass]);
    }
    if (!(most > 0.0f))
        snprintf(text, size, "no photons, no radii");
    else
        snprintf(text, size, "after %d of %d passes of %zu photons: radii from %.2g to %.2g m", pass, PASSES,
                 data->recording.count / PASSES, (double)least, (double)most);
}

static void legend(const View *view, const ViewData *data, Legend *legend)
{
    (void)view, (void)data;
    static const float shares[] = {1.0f, 0.8f, 0.6f, 0.4f, 0.2f};
    for (int i = 0; i < 5; i++)
        legend_add(legend, colour_of(shares[i], 1.0f), "%s%g", i == 0 ? "of the first radius: " : "",
                   (double)shares[i]);
}

static void choose(View *view, const ViewData *data, bool sideways, int step)
{
    (void)data;
    double *pass = &view->settings[VIEW_RADII][PASS];
    if (!sideways)
        *pass = fmin(fmax(*pass + step, 0.0), PASSES);
}

const ViewType view_radii = {
    .help = "disks that passes look for photons in, where the eye sees them; --pass N passes later\n",
    .arrows = "passes",
    .place = IN_THE_SCENE,
    .wires = 0.3f,
    .settings = {{.flag = "pass", .kind = SETTING_WHOLE, .start = 16, .low = 0, .high = PASSES}},
    .draw = draw,
    .describe = describe,
    .legend = legend,
    .choose = choose,
    .found_size = sizeof(Found),
    .free_found = free_found,
};
