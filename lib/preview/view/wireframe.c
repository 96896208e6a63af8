// The scene as lines: edges of flats where the surface ends or bends, circles on spheres, lights in yellow.
#include "preview/view/view_internal.h"
#include "scene/material_kind.h"

#include <stdlib.h>
#include <string.h>

#define BEND_COSINE 0.9397f // 20 degrees: flatter edges of a mesh are not drawn
#define FLAT_COSINE 0.99999f
#define MOST_LINES  40000
#define MOST_HAIRS  3000 // edges of round meshes, which would not be seen at all: some, and faint
#define GRID        1e-5 // of the scene's size: corners nearer than this are one

typedef struct {
    uint64_t key; // of the two corners; 0: empty
    Vec3 from, to, normal;
    uint32_t material;
    bool drawn, curved; // curved: not drawn as an edge, but its faces do not lie in one plane
} Edge;

typedef struct {
    Edge *slots;
    size_t mask;
    Vec3 low;
    float cell;
} EdgeTable;

static uint64_t mix(uint64_t x)
{
    x ^= x >> 31;
    x *= 0x9e3779b97f4a7c15u;
    x ^= x >> 29;
    x *= 0xbf58476d1ce4e5b9u;
    return x ^ x >> 32;
}

static uint64_t corner_key(const EdgeTable *table, Vec3 p)
{
    uint64_t x = (uint64_t)llrintf((p.x - table->low.x) / table->cell);
    uint64_t y = (uint64_t)llrintf((p.y - table->low.y) / table->cell);
    uint64_t z = (uint64_t)llrintf((p.z - table->low.z) / table->cell);
    return mix(mix(mix(x) + y) + z) | 1;
}

// An edge met for the first time is drawn, until a second face lies in line with the first.
static void add_edge(EdgeTable *table, Vec3 from, Vec3 to, const Flat *flat, Vec3 normal)
{
    uint64_t key = (corner_key(table, from) + corner_key(table, to)) | 1; // the same from both ends
    size_t i = mix(key) & table->mask;
    while (table->slots[i].key && table->slots[i].key != key)
        i = (i + 1) & table->mask;
    Edge *edge = &table->slots[i];
    if (!edge->key)
        *edge = (Edge){key, from, to, normal, flat->material, true, false};
    else if (flat->is_triangle && fabsf(vec3_dot(edge->normal, normal)) > BEND_COSINE) {
        edge->drawn = false;
        edge->curved = fabsf(vec3_dot(edge->normal, normal)) < FLAT_COSINE;
    }
}

static void add_flat(EdgeTable *table, const Flat *flat)
{
    Vec3 normal = vec3_cross(flat->edge_u, flat->edge_v);
    float length = vec3_length(normal);
    normal = length > 0.0f ? vec3_scale(normal, 1.0f / length) : vec3(0, 0, 1);
    Vec3 u = vec3_add(flat->origin, flat->edge_u), v = vec3_add(flat->origin, flat->edge_v);
    Vec3 far_corner = vec3_add(u, flat->edge_v);
    add_edge(table, flat->origin, u, flat, normal);
    add_edge(table, flat->origin, v, flat, normal);
    add_edge(table, u, flat->is_triangle ? v : far_corner, flat, normal);
    if (!flat->is_triangle)
        add_edge(table, v, far_corner, flat, normal);
}

static Rgba material_line(const Material *material)
{
    const MaterialKind *kind = material_kind(material);
    const uint8_t *base = kind->line;
    Colour c = colour_scale(colour_add(material->diffuse, material->specular), kind->line_hue);
    float most = fmaxf(colour_max(colour_add(material->diffuse, material->specular)), 1e-3f);
    return (Rgba){(uint8_t)(base[0] + c.r / most), (uint8_t)(base[1] + c.g / most), (uint8_t)(base[2] + c.b / most),
                  base[3]};
}

static void add_flats(const Scene *scene, Vertices *list)
{
    size_t capacity = 16; // at most four edges a flat: never more than two thirds full
    while (capacity < scene->flat_count * 6)
        capacity *= 2;
    Box box = bvh_bounds(scene->bvh);
    float size = box_diagonal(box);
    EdgeTable table = {calloc(capacity, sizeof(Edge)), capacity - 1, box.low, fmaxf((float)GRID * size, 1e-30f)};
    if (!table.slots)
        return;
    for (size_t i = 0; i < scene->flat_count; i++)
        add_flat(&table, &scene->flats[i]);
    size_t drawn = 0, curved = 0, kept = 0, hairs = 0;
    for (size_t i = 0; i < capacity; i++) {
        drawn += table.slots[i].drawn;
        curved += table.slots[i].curved;
    }
    for (size_t i = 0; i < capacity; i++) {
        const Edge *edge = &table.slots[i];
        Rgba colour = material_line(&scene->materials[edge->material]);
        if (edge->drawn && kept++ % (drawn / MOST_LINES + 1) == 0)
            vertices_line(list, edge->from, edge->to, colour);
        else if (edge->curved && hairs++ % (curved / MOST_HAIRS + 1) == 0)
            vertices_line(list, edge->from, edge->to, rgba_fade(colour, 0.6f));
    }
    free(table.slots);
}

static void add_sphere(Vertices *list, Vec3 centre, float radius, Rgba colour)
{
    Vec3 x = vec3(1, 0, 0), y = vec3(0, 1, 0), z = vec3(0, 0, 1);
    vertices_circle(list, centre, x, y, radius, colour);
    vertices_circle(list, centre, y, z, radius, colour);
    vertices_circle(list, centre, z, x, radius, colour);
    float d = 0.70710678f;
    vertices_circle(list, centre, vec3(d, 0, d), y, radius, rgba_fade(colour, 0.5f));
    vertices_circle(list, centre, vec3(d, 0, -d), y, radius, rgba_fade(colour, 0.5f));
    for (int i = -1; i <= 1; i += 2)
        vertices_circle(list, vec3_along(centre, y, (float)i * d * radius), x, z, d * radius, rgba_fade(colour, 0.5f));
}

static void add_spot_or_beam(const Light *light, float reach, Vertices *list)
{
    Frame frame = frame_about(light->direction);
    bool beam = light->type == LIGHT_BEAM;
    float cosine = fminf(fmaxf(light->cos_cone, 0.02f), 1.0f);
    float radius = beam ? light->radius : 2.0f * reach * sqrtf(1.0f - cosine * cosine);
    Vec3 ring = beam ? light->position : vec3_along(light->position, light->direction, 2.0f * reach * cosine);
    Vec3 end = vec3_along(light->position, light->direction, 2.0f * reach);
    vertices_circle(list, ring, frame.tangent, frame.bitangent, radius, COLOUR_OF_LIGHTS);
    vertices_line(list, light->position, end, COLOUR_OF_LIGHTS);
    for (int i = 0; i < 4; i++) {
        Vec3 side = vec3_scale(i & 1 ? frame.bitangent : frame.tangent, i & 2 ? radius : -radius);
        Vec3 rim = vec3_add(ring, side);
        vertices_line(list, beam ? end : light->position, rim, rgba_fade(COLOUR_OF_LIGHTS, 0.7f));
    }
}

// Rectangles and spheres are drawn as surfaces.
static void add_light(const Light *light, float reach, Vertices *list)
{
    for (int axis = 0; axis < 3 && light->type == LIGHT_POINT; axis++) {
        Vec3 way = vec3(reach * (axis == 0), reach * (axis == 1), reach * (axis == 2));
        vertices_line(list, vec3_sub(light->position, way), vec3_add(light->position, way), COLOUR_OF_LIGHTS);
    }
    if (light->type == LIGHT_SPOT || light->type == LIGHT_BEAM)
        add_spot_or_beam(light, reach, list);
}

void wireframe_build(const Scene *scene, Vertices *list)
{
    Box box = bvh_bounds(scene->bvh);
    float size = box.low.x <= box.high.x ? box_diagonal(box) : 1.0f;
    if (scene->flat_count)
        add_flats(scene, list);
    for (size_t i = 0; i < scene->sphere_count && i < MOST_LINES / 500; i++)
        add_sphere(list, scene->spheres[i].centre, scene->spheres[i].radius,
                   material_line(&scene->materials[scene->spheres[i].material]));
    for (size_t i = 0; i < scene->light_count; i++)
        add_light(&scene->lights[i], 0.03f * size, list);
}

void wireframe_draw(const Pane *pane, float strength)
{
    ViewData *data = pane->data;
    VertexBuffer *wires = &data->wires;
    if (!wires->array) {
        Vertices list = {.items = NULL};
        wireframe_build(data->scene, &list);
        vertices_upload(&list, data->canvas, wires);
    }
    pane_look_at_scene(pane);
    vertex_buffer_draw(data->canvas, wires, 0, wires->count, &(DrawStyle){.kind = DRAW_LINES, .exposure = strength});
}
