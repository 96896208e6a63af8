// Arrivals on one surface, flattened to a plane.
#include "preview/view/view_internal.h"

#include <stdlib.h>

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

// The flat that a photon lies on: what the ray meets that comes the photon's last small way again.
static bool landed_on(const Scene *scene, const StoredPhoton *photon, float reach, uint32_t *primitive)
{
    Hit hit;
    Vec3 wi = stored_photon_wi(photon);
    Ray ray = {vec3_along(photon->position, wi, reach), vec3_negate(wi), NO_PRIMITIVE};
    if (!scene_intersect(scene, &ray, &hit) || hit.distance > 2.0f * reach)
        return false;
    *primitive = hit.primitive;
    return true;
}

static float scene_size(const Scene *scene)
{
    Box box = bvh_bounds(scene->bvh);
    return vec3_length(vec3_sub(box.high, box.low));
}

int screen_busiest(const Scene *scene, const Recording *recording)
{
    size_t *landed = calloc(scene->flat_count + 1, sizeof *landed);
    size_t coloured = 0;
    float reach = 1e-4f * scene_size(scene);
    for (size_t i = 0; i < recording->count; i++)
        coloured += recording->photons[i].at.colour != WHITE;
    size_t wanted = coloured ? coloured : recording->count, stride = wanted / LOOKED_AT + 1, met = 0;
    for (size_t i = 0; landed && i < recording->count; i++) {
        const StoredPhoton *photon = &recording->photons[i].at;
        uint32_t primitive;
        if ((coloured && photon->colour == WHITE) || met++ % stride != 0)
            continue;
        if (landed_on(scene, photon, reach, &primitive) && primitive < scene->flat_count)
            landed[primitive]++;
    }
    int best = -1;
    size_t most = 0;
    for (size_t i = 0; landed && i < scene->flat_count; i++)
        if (landed[i] > most) {
            most = landed[i];
            best = (int)i;
        }
    free(landed);
    return best;
}

int screen_surface(Side *side, const View *view)
{
    if (view->surface >= 0)
        return view->surface < (int)side->scene->flat_count ? view->surface : -1;
    if (side->screen_surface == -2)
        side->screen_surface = screen_busiest(side->scene, &side->recording);
    return side->screen_surface;
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

static void build(Side *side, ColourMode mode, const Flat *flat)
{
    Vertices list = {.items = NULL};
    Sheet sheet = sheet_of(flat);
    Rgba edge = {150, 160, 180, 255};
    Vec3 corners[4] = {sheet_point(&sheet, 0, 0), sheet_point(&sheet, 1, 0), sheet_point(&sheet, 1, 1),
                       sheet_point(&sheet, 0, 1)};
    int count = flat->is_triangle ? 3 : 4;
    if (flat->is_triangle)
        corners[2] = corners[3];
    for (int i = 0; i < count; i++)
        vertices_line(&list, corners[i], corners[(i + 1) % count], edge);
    side->arrivals_inside = list.count; // where the points begin
    float tolerance = 1e-4f * scene_size(side->scene), u, v;
    for (size_t i = 0; i < side->recording.count; i++) {
        const StoredPhoton *photon = &side->recording.photons[i].at;
        if (screen_place(flat, (uint8_t)flat->material, photon, tolerance, &u, &v))
            vertices_point(&list, sheet_point(&sheet, u, v), points_colour(side, mode, photon));
    }
    side->arrivals = list.count - side->arrivals_inside;
    cache_fill(side->canvas, &side->screen, &list);
}

void view_screen_draw(const Pane *pane)
{
    Side *side = pane->side;
    const View *view = pane->view;
    int surface = screen_surface(side, view);
    if (surface < 0)
        return;
    const Flat *flat = &pane->scene->flats[surface];
    const double key[KEY_SIZE] = {view->colour, surface};
    if (!cache_is(&side->screen, key))
        build(side, view->colour, flat);
    Sheet sheet = sheet_of(flat);
    Box box = box_empty();
    for (int i = 0; i < 4; i++)
        box_add_point(&box, sheet_point(&sheet, (float)(i & 1), (float)(i >> 1)));
    Orbit orbit = {.vertical_fov = 20.0f};
    orbit_frame(&orbit, box, (float)pane->width / (float)pane->height);
    orbit.distance *= 1.25f; // room for the words
    pane_frame(&view->framing, &orbit);
    pane_look(pane, &orbit, box);
    batch_draw(pane->canvas, side->screen.batch, 0, side->arrivals_inside,
               &(DrawStyle){.kind = DRAW_LINES, .no_depth = true});
    float high = (box.high.y - box.low.y) / (2.0f * orbit.distance * tanf(10.0f * PI / 180.0f)) * (float)pane->height;
    float area = high * high * (box.high.x - box.low.x) / (box.high.y - box.low.y);
    size_t drawn = view->most_points && view->most_points < side->arrivals ? view->most_points : side->arrivals;
    float size = points_size(drawn, area, pane->scale);
    batch_draw(
        pane->canvas, side->screen.batch, side->arrivals_inside, drawn,
        &(DrawStyle){
            .additive = true, .no_depth = true, .point_size = size, .exposure = points_exposure(drawn, area, size)});
}
