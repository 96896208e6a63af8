#include "scene/file/scene_section.h"

#include "base/array.h"
#include "base/text.h"

bool scene_add_flat(SceneEntry *entry, Flat flat)
{
    Scene *scene = entry->file->scene;
    if (!array_reserve(&scene->flats, scene->flat_count + 1, &entry->file->flat_capacity, sizeof flat))
        return scene_out_of_memory(entry->file);
    scene->flats[scene->flat_count++] = flat;
    return true;
}

bool scene_add_sphere(SceneEntry *entry, Sphere sphere)
{
    Scene *scene = entry->file->scene;
    scene->spheres[scene->sphere_count++] = sphere;
    return true;
}

bool scene_check_edges(const SceneEntry *entry, const char *key, Vec3 edge_u, Vec3 edge_v)
{
    return !flat_is_degenerate(edge_u, edge_v) ||
           scene_fault(entry, key,
                       "edge_u (%g, %g, %g) and edge_v (%g, %g, %g) are zero or parallel; expected two sides "
                       "that span an area",
                       edge_u.x, edge_u.y, edge_u.z, edge_v.x, edge_v.y, edge_v.z);
}

Vec3 scene_rotate(Vec3 p, int axis, float degrees)
{
    float c = cosf(degrees * (PI / 180.0f)), s = sinf(degrees * (PI / 180.0f));
    if (axis == 0)
        return vec3(p.x, c * p.y - s * p.z, s * p.y + c * p.z);
    if (axis == 1)
        return vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
    return vec3(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
}

static bool build_sphere(SceneEntry *entry, uint32_t material)
{
    return scene_add_sphere(entry, (Sphere){scene_three(entry, "centre"), scene_number(entry, "radius"), material});
}

static bool build_rectangle(SceneEntry *entry, uint32_t material)
{
    Flat flat = {.origin = scene_three(entry, "corner"), .material = material};
    flat.edge_u = scene_three(entry, "edge_u");
    flat.edge_v = scene_three(entry, "edge_v");
    return scene_check_edges(entry, "edge_v", flat.edge_u, flat.edge_v) && scene_add_flat(entry, flat);
}

static bool build_box(SceneEntry *entry, uint32_t material)
{
    Vec3 low = scene_three(entry, "low"), high = scene_three(entry, "high");
    Vec3 size = vec3_sub(high, low), centre = vec3_scale(vec3_add(low, high), 0.5f);
    for (int i = 0; i < 3; i++)
        if (vec3_component(size, i) < SCENE_SMALLEST_LENGTH)
            return scene_fault(entry, "high", "high is not above low in %c (%g to %g); expected a larger number",
                               "xyz"[i], vec3_component(low, i), vec3_component(high, i));
    float angle = scene_number(entry, "rotate_y");
    Vec3 edges[3] = {scene_rotate(vec3(size.x, 0, 0), 1, angle), vec3(0, size.y, 0),
                     scene_rotate(vec3(0, 0, size.z), 1, angle)};
    Vec3 corner = vec3_add(centre, scene_rotate(vec3_sub(low, centre), 1, angle));
    for (int i = 0; i < 3; i++) {
        // The edges are right-handed: edge j × edge k points along edge i, out of the far face and into the near one.
        Vec3 j = edges[(i + 1) % 3], k = edges[(i + 2) % 3];
        Flat near_face = {corner, k, j, material, 0, 0, {0, 0, 0}};
        Flat far_face = {vec3_add(corner, edges[i]), j, k, material, 0, 0, {0, 0, 0}};
        if (!scene_check_edges(entry, "high", j, k) || !scene_add_flat(entry, near_face) ||
            !scene_add_flat(entry, far_face))
            return false;
    }
    return true;
}

static bool build_prism(SceneEntry *entry, uint32_t material)
{
    Vec3 axis = scene_three(entry, "axis"), down = scene_three(entry, "down");
    if (flat_is_degenerate(axis, down))
        return scene_fault(entry, "down",
                           "axis and down are zero or parallel; expected the edge's direction and one away from it");
    axis = vec3_normalize(axis);
    down = vec3_normalize(vec3_sub(down, vec3_scale(axis, vec3_dot(axis, down))));
    Vec3 sideways = vec3_cross(axis, down);
    float half_angle = 0.5f * scene_number(entry, "angle") * (PI / 180.0f);
    Vec3 height = vec3_scale(down, scene_number(entry, "side") * cosf(half_angle));
    Vec3 half_base = vec3_scale(sideways, scene_number(entry, "side") * sinf(half_angle));
    Vec3 along = vec3_scale(axis, scene_number(entry, "length"));
    Vec3 apex = vec3_along(scene_three(entry, "apex"), along, -0.5f);
    Vec3 side_1 = vec3_add(height, half_base), side_2 = vec3_sub(height, half_base);
    // axis, down and sideways are right-handed; so all edge_u × edge_v below point out of the glass.
    Flat faces[5] = {
        {apex, along, side_1, material, 0, 0, {0, 0, 0}},
        {apex, side_2, along, material, 0, 0, {0, 0, 0}},
        {vec3_add(apex, side_2), vec3_sub(side_1, side_2), along, material, 0, 0, {0, 0, 0}},
        {apex, side_1, side_2, material, 0, 1, {0, 0, 0}},
        {vec3_add(apex, along), side_2, side_1, material, 0, 1, {0, 0, 0}},
    };
    for (int i = 0; i < 5; i++) {
        if (flat_is_degenerate(faces[i].edge_u, faces[i].edge_v))
            return scene_fault(entry, "angle",
                               "this prism is too thin to have an inside; expected larger angle, side or length");
        if (!scene_add_flat(entry, faces[i]))
            return false;
    }
    return true;
}

#define MATERIAL_ROW {"material", KEY_WORD, KEY_REQUIRED, RANGE_NAME, "the name of its material"}

static const SceneKeys sphere_keys = {
    {"centre", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "the centre"},
    {"radius", KEY_NUMBER, KEY_REQUIRED, RANGE_LENGTH, "the radius"},
    MATERIAL_ROW,
};
static const SceneKeys rectangle_keys = {
    {"corner", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "a corner"},
    {"edge_u", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "a side, from the corner"},
    {"edge_v", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "the other side; edge_u × edge_v points to its outside"},
    MATERIAL_ROW,
};
static const SceneKeys box_keys = {
    {"low", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "its least x, y and z"},
    {"high", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "its largest"},
    MATERIAL_ROW,
    {"rotate_y", KEY_NUMBER, "0", RANGE_DEGREES,
     "turns the box about the upright line through its middle, counter-clockwise seen from above"},
};
static const SceneKeys prism_keys = {
    {"apex", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "the middle of its upper edge"},
    {"axis", KEY_THREE, KEY_REQUIRED, RANGE_ANY, "which way this edge runs; any length"},
    {"down", KEY_THREE, KEY_REQUIRED, RANGE_ANY,
     "from the edge to the middle of the base; only what is at right angles to axis counts"},
    {"angle", KEY_NUMBER, KEY_REQUIRED, RANGE_ANGLE, "between the two faces that meet in the edge"},
    {"side", KEY_NUMBER, KEY_REQUIRED, RANGE_LENGTH, "how far these faces go from the edge"},
    {"length", KEY_NUMBER, KEY_REQUIRED, RANGE_LENGTH, "length of the edge"},
    MATERIAL_ROW,
};
static const SceneKeys mesh_keys = {
    {"file", KEY_WORD, KEY_REQUIRED, RANGE(1, 1023, "characters"),
     "an OBJ file; the path begins at the scene's folder"},
    {"material", KEY_WORD, KEY_OPTIONAL, RANGE_NAME, "the material of faces for which the file gives none by usemtl"},
    {"scale", KEY_NUMBER, "1", RANGE_FACTOR, "first the mesh is made so much larger"},
    {"rotate", KEY_THREE, "[0, 0, 0]", RANGE_DEGREES,
     "then turned about the x axis, the y axis and the z axis, in this order, counter-clockwise seen against the axis"},
    {"translate", KEY_THREE, "[0, 0, 0]", RANGE_METRES, "then moved"},
};

typedef struct {
    SceneType type;
    bool (*build)(SceneEntry *entry, uint32_t material);
} ShapeKind;

static const ShapeKind kinds[] = {
    {{"sphere", "sphere", "A sphere.", sphere_keys,
      "{type: sphere, centre: [0.4, -0.65, 0.25], radius: 0.35, material: clear}"},
     build_sphere},
    {{"rectangle", "rectangle", "A parallelogram: a corner, and the two sides that leave it.", rectangle_keys,
      "{type: rectangle, corner: [-1, -1, -1], edge_u: [0, 0, 2], edge_v: [2, 0, 0], material: white}"},
     build_rectangle},
    {{"box", "box", "A box, by its lowest and its highest corner.", box_keys,
      "{type: box, low: [0.1, -1, -0.2], high: [0.5, 0.2, 0.2], rotate_y: 18, material: white}"},
     build_box},
    {{"prism", "prism", "A prism over a triangle with two equal sides, which meet in its upper edge.", prism_keys,
      "{type: prism, apex: [0, 0.5, 0], axis: [0, 0, 1], down: [0, -1, 0], angle: 60, side: 0.4, length: 0.6, material: clear}"},
     build_prism},
    {{"mesh", "mesh",
      "Polygons from a Wavefront OBJ file. Their corner normals, if there are any, bend what mirrors and glass do.",
      mesh_keys, "{type: mesh, file: meshes/diamond.obj, material: clear, scale: 0.5, rotate: [0, 30, 0]}"},
     scene_build_mesh},
};

static const SceneType *type_at(size_t i)
{
    return i < sizeof kinds / sizeof kinds[0] ? &kinds[i].type : NULL;
}

static bool build(SceneEntry *entry)
{
    const char *name = scene_word(entry, "material");
    size_t material = NO_MATERIAL;
    if (name && !text_find_name(name, scene_material_name, entry->file, &material))
        return scene_fault(entry, "material", "there is no material '%s'; %s", name,
                           text_suggest(name, scene_material_name, entry->file).text);
    return kinds[entry->type_number].build(entry, (uint32_t)material);
}

static const SceneKeys keys = {{"type", KEY_TYPE, KEY_REQUIRED, RANGE_ANY, "one of the types below"}};

const SceneSection shape_section = {"shapes", "What light falls on.", MAX_SHAPES, false, keys, NULL, type_at, build};
