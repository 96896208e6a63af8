// A perfect mirror, which may be coloured.
#include "scene/mirror.h"
#include "scene/material.h"

static Colour albedo(const Material *material, GlossyModel model, float cos_wi)
{
    (void)model;
    (void)cos_wi;
    return material->specular;
}

MATERIAL_KIND(mirror) = {
    .name = "mirror",
    .type = MATERIAL_MIRROR,
    .optics = OPTICS_MIRROR,
    .albedo = albedo,
    .turn = mirror_direction,
    .line = {200, 205, 225, 170},
};
