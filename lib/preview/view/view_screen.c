// Arrivals on one surface, flattened to a plane.
#include "preview/view/view_internal.h"

#include <stdio.h>
#include <stdlib.h>

enum { SURFACE };         // settings: its number, −1: the one with the most arrivals
enum { EDGES, ARRIVALS }; // lists
typedef struct {
    int surface; // that is shown, −1: none
    Box box;     // of its sheet
} Found;

#define LOOKED_AT 30000 // photons, when the busiest surface is looked for

bool screen_place(const Flat *flat, uint8_t material, const StoredPhoton *photon, float tolerance, float *u, float *v)
{
    if (photon->material != material)
        return false;
    Vec3 normal = vec3_cross(flat->edge_u, flat->edge_v), at = vec3_sub(photon->position, flat->origin);
    float area2 = vec3_dot(normal, normal);
    float away = vec3_dot(at, normal);
    if (!(away * away <= tolerance * tolerance * area2))
        return false;
    *u = vec3_dot(vec3_cross(at, flat->edge_v), normal) / area2;
    *v = vec3_dot(vec3_cross(flat->edge_u, at), normal) / area2;
    float slack = 1e-4f, sum = flat->is_triangle ? *u + *v : fmaxf(*u, *v);
    return *u >= -slack && *v >= -slack && sum <= 1.0f + slack;
}

// What a photon lies on: what the ray meets that comes the photon's last small way again. NO_PRIMITIVE: nothing.
static uint32_t landed_on(const Scene *scene, const StoredPhoton *photon, float reach)
{
    Hit hit;
    Vec3 wi = stored_photon_wi(photon);
    Ray ray = {vec3_along(photon->position, wi, reach), vec3_negate(wi), NO_PRIMITIVE};
    return scene_intersect(scene, &ray, &hit) && hit.distance <= 2.0f * reach ? hit.primitive : NO_PRIMITIVE;
}

int screen_busiest(const Scene *scene, const Recording *recording)
{
    size_t *landed = calloc(scene->flat_count + 1, sizeof *landed);
    size_t coloured = 0;
    float reach = 1e-4f * box_diagonal(bvh_bounds(scene->bvh));
    for (size_t i = 0; i < recording->count; i++)
        coloured += recording->photons[i].at.colour != WHITE;
    size_t wanted = coloured ? coloured : recording->count, stride = wanted / LOOKED_AT + 1, met = 0;
    for (size_t i = 0; landed && i < recording->count; i++) {
        const StoredPhoton *photon = &recording->photons[i].at;
        if ((coloured && photon->colour == WHITE) || met++ % stride != 0)
            continue;
        uint32_t primitive = landed_on(scene, photon, reach);
        if (primitive < scene->flat_count)
            landed[primitive]++;
    }
    size_t best = 0;
    for (size_t i = 0; landed && i < scene->flat_count; i++)
        best = landed[i] > landed[best] ? i : best;
    int busiest = landed && landed[best] > 0 ? (int)best : -1;
    free(landed);
    return busiest;
}

// NULL: there is none.
static const Flat *flat_shown(const ViewData *data)
{
    const Found *found = data->made[VIEW_SCREEN].found;
    bool known = found->surface >= 0 && (size_t)found->surface < data->scene->flat_count;
    return known ? &data->scene->flats[found->surface] : NULL;
}

// Lying on the plane z = 0, the longer edge to the right, the middle at the origin.
typedef struct {
    Vec3 u, v;
} Sheet;

static Sheet sheet_of(const Flat *flat)
{
    float across = vec3_length(flat->edge_u), along = vec3_length(flat->edge_v);
    float slant = vec3_dot(flat->edge_u, flat->edge_v) / fmaxf(across * along, 1e-30f);
    float upright = sqrtf(fmaxf(1.0f - slant * slant, 0.0f));
    if (across >= along)
        return (Sheet){vec3(across, 0, 0), vec3(along * slant, along * upright, 0)};
    return (Sheet){vec3(across * slant, across * upright, 0), vec3(along, 0, 0)};
}

static Vec3 sheet_point(const Sheet *sheet, float u, float v)
{
    return vec3_add(vec3_scale(sheet->u, u - 0.5f), vec3_scale(sheet->v, v - 0.5f));
}

static void build(const View *view, ViewData *data, Vertices *lists)
{
    Found *found = data->made[VIEW_SCREEN].found;
    int wanted = (int)view->settings[VIEW_SCREEN][SURFACE];
    *found = (Found){wanted < 0 ? screen_busiest(data->scene, &data->recording) : wanted, box_empty()};
    const Flat *flat = flat_shown(data);
    if (!flat)
        return;
    Sheet sheet = sheet_of(flat);
    Vec3 corners[4] = {sheet_point(&sheet, 0, 0), sheet_point(&sheet, 1, 0), sheet_point(&sheet, 1, 1),
                       sheet_point(&sheet, 0, 1)};
    for (int i = 0; i < 4; i++)
        box_add_point(&found->box, corners[i]);
    int count = flat->is_triangle ? 3 : 4;
    if (flat->is_triangle)
        corners[2] = corners[3];
    for (int i = 0; i < count; i++)
        vertices_line(&lists[EDGES], corners[i], corners[(i + 1) % count], (Rgba){150, 160, 180, 255});
    float tolerance = 1e-4f * box_diagonal(bvh_bounds(data->scene->bvh)), u, v;
    for (size_t i = 0; i < data->recording.count; i++) {
        const StoredPhoton *photon = &data->recording.photons[i].at;
        if (screen_place(flat, (uint8_t)flat->material, photon, tolerance, &u, &v))
            vertices_point(&lists[ARRIVALS], sheet_point(&sheet, u, v), points_colour(data, view->colour, photon));
    }
}

static void draw(const Pane *pane)
{
    const Made *made = &pane->data->made[VIEW_SCREEN];
    if (!flat_shown(pane->data))
        return;
    Box box = ((const Found *)made->found)->box;
    float high = pane_look_at_sheet(pane, box);
    pane_draw(pane, EDGES, (DrawStyle){.kind = DRAW_LINES});
    float area = high * high * (box.high.x - box.low.x) / (box.high.y - box.low.y);
    size_t drawn = points_drawn(pane->view, made->lists[ARRIVALS].count);
    pane_draw_points(pane, ARRIVALS, drawn, area, view_brightness(pane->view));
}

static void describe(const View *view, const ViewData *data, char *text, size_t size)
{
    const Scene *scene = data->scene;
    const Made *made = &data->made[VIEW_SCREEN];
    const Flat *flat = flat_shown(data);
    int surface = ((const Found *)made->found)->surface;
    if (!flat) {
        snprintf(text, size, surface < 0 ? "no photon has landed on a flat surface" : "the scene has %zu flat surfaces",
                 scene->flat_count);
        return;
    }
    float across = vec3_length(flat->edge_u), along = vec3_length(flat->edge_v);
    snprintf(text, size, "surface %d, %s, %.3g x %.3g m: %zu photons%s", surface, scene->materials[flat->material].name,
             (double)fmaxf(across, along), (double)fminf(across, along), made->lists[ARRIVALS].count,
             view->settings[VIEW_SCREEN][SURFACE] < 0.0 ? " (the busiest)" : "");
}

static void choose(View *view, const ViewData *data, bool sideways, int step)
{
    double *surface = &view->settings[VIEW_SCREEN][SURFACE];
    if (sideways)
        *surface = wrap(*surface + step, -1.0, (double)data->scene->flat_count - 1.0);
}

const ViewType view_screen = {
    .help = "arrivals on one flat surface; --surface I\n",
    .arrows = "surface",
    .place = ON_A_SHEET,
    .settings = {{.flag = "surface", .kind = SETTING_WHOLE, .start = -1, .low = 0, .high = 1e9}},
    .build = build,
    .draw = draw,
    .describe = describe,
    .legend = legend_of_photons,
    .choose = choose,
    .found_size = sizeof(Found),
};
