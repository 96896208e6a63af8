// Lambert: ρ_d/π into every direction.
#include "scene/material_kind.h"

static bool build(SceneEntry *entry, Material *material)
{
    material->diffuse = scene_colour(entry, "reflectance");
    return true;
}

static const SceneKeys keys = {
    {"reflectance", KEY_COLOUR, KEY_REQUIRED, RANGE_SHARE, "ρ_d: the share of light that is sent back"},
};

MATERIAL_KIND(diffuse) = {
    .scene = {"diffuse", "diffuse material", "Lambert: sends light evenly to all sides.", keys,
              "{name: chalk, type: diffuse, reflectance: [0.7, 0.7, 0.7]}"},
    .build = build,
    .type = MATERIAL_DIFFUSE,
    .optics = OPTICS_ROUGH,
    .line = {70, 70, 70, 160},
    .line_hue = 120,
};
