// Clear glass: what is not reflected goes through.
#include "scene/material.h"

static Colour albedo(const Material *material, GlossyModel model, float cos_wi)
{
    (void)material;
    (void)model;
    (void)cos_wi;
    return colour_grey(1.0f);
}

MATERIAL_KIND(glass) = {
    .name = "glass",
    .type = MATERIAL_GLASS,
    .optics = OPTICS_GLASS,
    .albedo = albedo,
    .line = {120, 215, 235, 150},
};
