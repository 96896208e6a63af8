#include "scene/file/scene_section.h"

#include <stdio.h>
#include <stdlib.h>

// A Lambertian surface of area A and radiance L sends out Φ = πAL. The file gives one of the two. The surface shines by a
// material of its own, which stands after those of the file.
static bool set_emission(SceneEntry *entry, Light *light, uint32_t *material)
{
    Scene *scene = entry->file->scene;
    bool radiance = scene_given(entry, "radiance"), power = scene_given(entry, "power");
    if (radiance == power)
        return scene_fault(entry, NULL, "this light has %s; expected exactly one of radiance and power",
                           radiance ? "both radiance and power" : "neither radiance nor power");
    float power_of_radiance = PI * light->area;
    light->radiance = radiance ? scene_colour(entry, "radiance")
                               : colour_scale(scene_colour(entry, "power"), 1.0f / power_of_radiance);
    light->power = power ? scene_colour(entry, "power") : colour_scale(light->radiance, power_of_radiance);
    if (!(colour_max(light->radiance) < 1e18f && colour_max(light->power) < 1e18f))
        return scene_fault(entry, NULL, "this light of %g m² is too bright to reckon with; expected less power",
                           light->area);
    if (scene->material_count == MAX_MATERIALS)
        return scene_fault(entry, NULL,
                           "too many materials: each rectangle or sphere that shines counts as one; "
                           "expected at most %d",
                           MAX_MATERIALS);
    Material *own = &scene->materials[scene->material_count];
    *own = (Material){.type = MATERIAL_LIGHT, .radiance = light->radiance};
    snprintf(own->name, sizeof own->name, "light %zu", scene->light_count + 1);
    *material = (uint32_t)scene->material_count++;
    return true;
}

static bool build_rectangle(SceneEntry *entry, Light *light)
{
    light->position = scene_three(entry, "corner");
    light->edge_u = scene_three(entry, "edge_u");
    light->edge_v = scene_three(entry, "edge_v");
    if (!scene_check_edges(entry, "edge_v", light->edge_u, light->edge_v))
        return false;
    Vec3 normal = vec3_cross(light->edge_u, light->edge_v);
    light->area = vec3_length(normal);
    light->direction = vec3_scale(normal, 1.0f / light->area);
    light->primitive = (uint32_t)entry->file->scene->flat_count;
    Flat flat = {.origin = light->position, .edge_u = light->edge_u, .edge_v = light->edge_v};
    return set_emission(entry, light, &flat.material) && scene_add_flat(entry, flat);
}

static bool build_sphere(SceneEntry *entry, Light *light)
{
    light->position = scene_three(entry, "centre");
    light->radius = scene_number(entry, "radius");
    light->area = 4.0f * PI * light->radius * light->radius;
    light->primitive = (uint32_t)entry->file->scene->sphere_count;
    Sphere sphere = {.centre = light->position, .radius = light->radius};
    return set_emission(entry, light, &sphere.material) && scene_add_sphere(entry, sphere);
}

// Point, spot and beam have no surface.
static bool build_point(SceneEntry *entry, Light *light)
{
    light->position = scene_three(entry, "position");
    light->power = scene_colour(entry, "power");
    return true;
}

// Spot and beam point from their position to their target.
static bool aim(SceneEntry *entry, Light *light)
{
    build_point(entry, light);
    Vec3 way = vec3_sub(scene_three(entry, "target"), light->position);
    if (vec3_length(way) < SCENE_SMALLEST_LENGTH)
        return scene_fault(entry, "target", "the target is the light's position; expected another point");
    light->direction = vec3_normalize(way);
    return true;
}

static bool build_spot(SceneEntry *entry, Light *light)
{
    light->cos_cone = cosf(scene_number(entry, "angle") * (PI / 180.0f));
    return aim(entry, light);
}

static bool build_beam(SceneEntry *entry, Light *light)
{
    if (!aim(entry, light))
        return false;
    light->radius = scene_number(entry, "radius");
    // Across the beam: start from the axis that is least along it.
    Vec3 d = light->direction;
    bool x_least = fabsf(d.x) <= fabsf(d.y) && fabsf(d.x) <= fabsf(d.z);
    Vec3 axis = x_least ? vec3(1, 0, 0) : fabsf(d.y) <= fabsf(d.z) ? vec3(0, 1, 0) : vec3(0, 0, 1);
    light->edge_u = vec3_normalize(vec3_cross(axis, d));
    light->edge_v = vec3_cross(d, light->edge_u);
    return true;
}

#define RANGE_POWER    RANGE_TOLD(0, SCENE_LARGEST_NUMBER, "W", "0 or more")
#define RANGE_RADIANCE RANGE_TOLD(0, SCENE_LARGEST_NUMBER, "W/(m²·sr)", "0 or more")

static const SceneKeys rectangle_keys = {
    {"corner", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "a corner"},
    {"edge_u", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "a side, from the corner"},
    {"edge_v", KEY_THREE, KEY_REQUIRED, RANGE_METRES,
     "the other side; the light shines to where edge_u × edge_v points"},
    {"radiance", KEY_COLOUR, KEY_OPTIONAL, RANGE_RADIANCE, "what each of its points sends in each direction"},
    {"power", KEY_COLOUR, KEY_OPTIONAL, RANGE_POWER, "in place of radiance: all that it sends out, π·area·radiance"},
};
static const SceneKeys sphere_keys = {
    {"centre", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "the centre"},
    {"radius", KEY_NUMBER, KEY_REQUIRED, RANGE_LENGTH, "the radius"},
    {"radiance", KEY_COLOUR, KEY_OPTIONAL, RANGE_RADIANCE, "what each of its points sends in each direction"},
    {"power", KEY_COLOUR, KEY_OPTIONAL, RANGE_POWER, "in place of radiance: all that it sends out, π·area·radiance"},
};
static const SceneKeys point_keys = {
    {"position", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "where it is"},
    {"power", KEY_COLOUR, KEY_REQUIRED, RANGE_POWER, "all that it sends out"},
};
// Of a cone below 0.1°, 1 − cos is all rounding: its solid angle would be wrong, or 0.
static const SceneKeys spot_keys = {
    {"position", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "the tip of its cone"},
    {"target", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "a point on the cone's axis"},
    {"angle", KEY_NUMBER, KEY_REQUIRED, RANGE(0.1, 180, "degrees"), "between the axis and the cone's edge"},
    {"power", KEY_COLOUR, KEY_REQUIRED, RANGE_POWER, "all that it sends out"},
};
static const SceneKeys beam_keys = {
    {"position", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "the middle of the disk that sends out the beam"},
    {"target", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "a point that the beam's middle goes through"},
    {"radius", KEY_NUMBER, KEY_REQUIRED, RANGE_LENGTH, "the beam's radius"},
    {"power", KEY_COLOUR, KEY_REQUIRED, RANGE_POWER, "all that it sends out"},
};

typedef struct {
    SceneType type;
    bool (*build)(SceneEntry *entry, Light *light);
} LightKind;

static const LightKind kinds[] = {
    [LIGHT_RECTANGLE] =
        {{"rectangle", "rectangle light",
          "A parallelogram that shines to one side. Exactly one of `radiance` and `power`.", rectangle_keys,
          "{type: rectangle, corner: [-0.23, 0.99, -0.18], edge_u: [0.46, 0, 0], edge_v: [0, 0, 0.38], radiance: [15, 15, 15]}"},
         build_rectangle},
    [LIGHT_SPHERE] = {{"sphere", "sphere light", "A sphere that shines. Exactly one of `radiance` and `power`.",
                       sphere_keys, "{type: sphere, centre: [0, 0.8, 0], radius: 0.1, power: [8, 8, 8]}"},
                      build_sphere},
    [LIGHT_POINT] = {{"point", "point light", "A point that shines evenly to all sides.", point_keys,
                      "{type: point, position: [0, 0.8, 0], power: [8, 8, 8]}"},
                     build_point},
    [LIGHT_SPOT] = {{"spot", "spot light", "A point that shines evenly into a cone.", spot_keys,
                     "{type: spot, position: [0, 0.9, 0], target: [0, 0, 0], angle: 25, power: [2, 2, 2]}"},
                    build_spot},
    [LIGHT_BEAM] =
        {{"beam", "beam light",
          "Parallel rays from a disk, like a laser's. The beam itself cannot be seen: there is no dust in the air.",
          beam_keys,
          "{type: beam, position: [-0.9, 0, 0], target: [0, 0, 0], radius: 0.003, power: [0.02, 0.02, 0.02]}"},
         build_beam},
};

// The file's power, as the spectrum colours it: for red, green and blue without what lies below 0, and for wavelengths.
static bool set_spectrum(SceneEntry *entry, Light *light)
{
    Scene *scene = entry->file->scene;
    light->given_power = light->power;
    const char *words = scene_word(entry, "spectrum"), *why;
    if (words) {
        light->spectrum = malloc(sizeof *light->spectrum);
        if (!light->spectrum)
            return scene_out_of_memory(entry->file);
        if (!spectrum_parse(words, light->spectrum, &why))
            return scene_fault(entry, "spectrum", "no spectrum '%s': %s", words, why);
        Colour seen = spectrum_colour(light->spectrum, light->given_power, colour_grey(1.0f));
        light->power = colour(fmaxf(0.0f, seen.r), fmaxf(0.0f, seen.g), fmaxf(0.0f, seen.b));
    }
    float per_watt = light->area > 0.0f ? 1.0f / (PI * light->area) : 1.0f;
    if (words && light->area > 0.0f) {
        light->radiance = colour_scale(light->power, per_watt);
        scene->materials[scene->material_count - 1].radiance = light->radiance;
    }
    for (int c = 0; c < 3; c++) {
        Colour filter = colour_grey(0.0f);
        colour_set_channel(&filter, c, per_watt);
        light->behind[c] = spectrum_colour(light->spectrum, light->given_power, filter);
    }
    return true;
}

static const SceneType *type_at(size_t i)
{
    return i < sizeof kinds / sizeof kinds[0] ? &kinds[i].type : NULL;
}

static bool build(SceneEntry *entry)
{
    const LightKind *kind = &kinds[entry->type_number];
    const char *brightness = scene_given(entry, "power") ? "power" : "radiance";
    if (scene_given(entry, brightness) && colour_max(scene_colour(entry, brightness)) <= 0)
        return scene_fault(entry, brightness, "this light is dark; expected a number above 0");
    Light light = {.type = (LightType)entry->type_number, .primitive = NO_PRIMITIVE};
    bool ok = kind->build(entry, &light) && set_spectrum(entry, &light);
    entry->file->scene->lights[entry->file->scene->light_count++] = light; // in any case, so that its spectrum is freed
    return ok;
}

static const SceneKeys keys = {
    {"type", KEY_TYPE, KEY_REQUIRED, RANGE_ANY, "one of the types below"},
    {"spectrum", KEY_WORD, KEY_OPTIONAL, RANGE(1, 2000, "characters"),
     "how its energy is spread over 380 to 730 nm: `daylight` (D65), `sodium`, the nm of a single line, or pairs of nm and energy "
     "as in `\"400 0, 500 8, 700 18.4\"`; otherwise evenly. The power stays, and is told apart by `--spectral` alone"},
};

const SceneSection light_section = {"lights", "What gives light.", MAX_LIGHTS, true, keys, NULL, type_at, build};
