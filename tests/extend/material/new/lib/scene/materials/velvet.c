// Velvet: matt, with fibres that shine at grazing angles, f = ρ_d/π + ρ_s·3/π·(1 − cosθ_i)(1 − cosθ_o).
#include "scene/material_kind.h"

static Colour albedo(const Material *material, GlossyModel model, float cos_wi)
{
    (void)model;
    return colour_add(material->diffuse, colour_scale(material->specular, 1.0f - cos_wi));
}

static Colour lobe(const Material *material, GlossyModel model, Vec3 wi, Vec3 wo, Vec3 n)
{
    (void)model;
    return colour_scale(material->specular, 3.0f / PI * (1.0f - vec3_dot(n, wi)) * (1.0f - vec3_dot(n, wo)));
}

static bool build(SceneEntry *entry, Material *material)
{
    material->diffuse = scene_colour(entry, "reflectance");
    material->specular = scene_colour(entry, "fibres");
    return true;
}

static const SceneKeys keys = {
    {"reflectance", KEY_COLOUR, "[0.2, 0.2, 0.2]", RANGE_SHARE, "ρ_d: the share of light that is sent back evenly"},
    {"fibres", KEY_COLOUR, KEY_REQUIRED, RANGE_SHARE, "ρ_s: the share that the fibres send back at grazing angles"},
};

MATERIAL_KIND(velvet) = {
    .scene = {"velvet", "velvet", "Matt, with a shine at grazing angles.", keys,
              "{name: curtain, type: velvet, fibres: [0.5, 0.1, 0.1]}"},
    .build = build,
    .type = MATERIAL_GLOSSY,
    .optics = OPTICS_ROUGH,
    .albedo = albedo,
    .lobe = lobe,
    .line = {120, 40, 60, 160},
    .line_hue = 120,
};
