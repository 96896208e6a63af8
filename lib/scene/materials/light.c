// The surface of a light.
#include "scene/material_kind.h"

MATERIAL_KIND(light) = {
    .type = MATERIAL_LIGHT,
    .optics = OPTICS_LIGHT,
    .line = {255, 220, 80, 255},
};
