// Lambert: ρ_d/π into every direction.
#include "scene/material.h"

static Colour albedo(const Material *material, GlossyModel model, float cos_wi)
{
    (void)model;
    (void)cos_wi;
    return material->diffuse;
}

MATERIAL_KIND(diffuse) = {
    .name = "diffuse",
    .type = MATERIAL_DIFFUSE,
    .optics = OPTICS_ROUGH,
    .albedo = albedo,
    .line = {70, 70, 70, 160},
    .line_hue = 120,
};
