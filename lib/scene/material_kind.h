// What makes a kind of material. Each is a file of its own in lib/scene/materials/, listed in materials.def.
#pragma once

#include "scene/limits.h"
#include "scene/material.h"
#include "scene/scene_key.h"

#include <stddef.h>
#include <stdint.h>

// How a surface treats rays.
typedef enum {
    OPTICS_ROUGH = 1, // sends light everywhere, by its BRDF; photons are stored there
    OPTICS_MIRROR,    // turns each ray into one other
    OPTICS_GLASS,     // reflects and refracts
    OPTICS_LIGHT      // gives light, takes all that comes
} MaterialOptics;

// A test names what a kind leaves out.
struct MaterialKind {
    SceneType scene; // its keys in a scene file; without a name it stands in none
    // Makes the material of what the file says, and refuses what only shows in combination.
    bool (*build)(SceneEntry *entry, Material *material);
    MaterialType type;
    MaterialOptics optics;
    // Rough: the BRDF beside ρ_d/π, for wi and wo above the surface, and the albedo of both; NULL: there is nothing beside it.
    Colour (*lobe)(const Material *material, GlossyModel model, Vec3 wi, Vec3 wo, Vec3 n);
    Colour (*albedo)(const Material *material, GlossyModel model, float cos_wi);
    bool cosine_lobe; // it is the course's, cosⁿα about the mirror direction
    // Mirrors: which way a ray goes on; ρ_s is how much of it does.
    Vec3 (*turn)(Vec3 direction, Vec3 normal);
    // How its outlines are drawn: this colour and opacity, and so much of the reflectance's hue on top.
    uint8_t line[4], line_hue;
};

#define MATERIAL(name) extern const MaterialKind material_##name;
#include "scene/materials.def"
#undef MATERIAL

// Opens the definition of a kind; one that materials.def does not list is an error here.
#define MATERIAL_KIND(name)                                                                                            \
    enum { listed_##name = sizeof material_##name };                                                                   \
    const MaterialKind material_##name

extern const MaterialKind *const material_kinds[];
extern const size_t material_kind_count;

static inline const MaterialKind *material_kind(const Material *material)
{
    return material->kind ? material->kind : material_kinds[material->type];
}
