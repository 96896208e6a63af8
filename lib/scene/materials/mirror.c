// A perfect mirror, which may be coloured.
#include "math/ray.h"
#include "scene/material_kind.h"

static bool build(SceneEntry *entry, Material *material)
{
    material->specular = scene_colour(entry, "reflectance");
    return true;
}

static const SceneKeys keys = {
    {"reflectance", KEY_COLOUR, "[1, 1, 1]", RANGE_SHARE, "ρ_s: the share of light that is reflected"},
};

MATERIAL_KIND(mirror) = {
    .scene = {"mirror", "mirror", "A perfect mirror.", keys,
              "{name: mirror, type: mirror, reflectance: [0.9, 0.9, 0.9]}"},
    .build = build,
    .type = MATERIAL_MIRROR,
    .optics = OPTICS_MIRROR,
    .turn = mirror_direction,
    .line = {200, 205, 225, 170},
};
