// The surface of a light.
#include "scene/material_kind.h"

static Colour albedo(const Material *material, GlossyModel model, float cos_wi)
{
    (void)material, (void)model, (void)cos_wi;
    return colour_grey(0.0f);
}

MATERIAL_KIND(light) = {
    .type = MATERIAL_LIGHT,
    .optics = OPTICS_LIGHT,
    .albedo = albedo,
    .line = {255, 220, 80, 255},
};
