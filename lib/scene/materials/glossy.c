// Lambert's reflection and a cosine lobe about the mirror direction.
#include "scene/material_kind.h"

#include <math.h>
#include <stdlib.h>

float lobe_lookup(const float table[LOBE_TABLE_SIZE], float cos_theta)
{
    float x = fminf(fmaxf(cos_theta, 0.0f), 1.0f) * (LOBE_TABLE_SIZE - 1);
    int i = (int)x;
    if (i >= LOBE_TABLE_SIZE - 1)
        return table[LOBE_TABLE_SIZE - 1];
    float f = x - (float)i;
    return table[i] * (1.0f - f) + table[i + 1] * f;
}

// A ring of directions at angle alpha from the mirror direction, which is theta from the normal: its height above the
// surface at azimuth phi is a + b·cosφ with a = cosα cosθ and b = sinα sinθ. Gives the azimuth's length with positive
// height, and the integral of the height over it.
static void ring_above(double cos_alpha, double cos_theta, double *length, double *height)
{
    double a = cos_alpha * cos_theta;
    double b = sqrt((1.0 - cos_alpha * cos_alpha) * (1.0 - cos_theta * cos_theta));
    double half = a >= b ? M_PI : acos(-a / b); // a ≥ 0: the lobe ends at α = 90°
    *length = 2.0 * half;
    *height = 2.0 * (half * a + sin(half) * b);
}

// ∫cosⁿα … dω with the ring's solid angle sinα dα dφ. The substitution cosα = x^(1/(n+1)) takes the lobe into the
// measure: ∫cosⁿα g sinα dα = ∫₀¹ g dx/(n+1), smooth for any exponent. Midpoint rule, in y with x = 1−y² to tame the
// root at α = 0.
void lobe_table_fill(LobeTable *table, float exponent)
{
    const int steps = 512;
    double above[LOBE_TABLE_SIZE] = {0.0};
    double weighted[LOBE_TABLE_SIZE] = {0.0};
    double n1 = (double)exponent + 1.0;
    for (int s = 0; s < steps; s++) {
        double y = (s + 0.5) / steps;
        double cos_alpha = pow(1.0 - y * y, 1.0 / n1);
        for (int i = 0; i < LOBE_TABLE_SIZE; i++) {
            double length, height;
            ring_above(cos_alpha, (double)i / (LOBE_TABLE_SIZE - 1), &length, &height);
            above[i] += length * 2.0 * y;
            weighted[i] += height * 2.0 * y;
        }
    }
    for (int i = 0; i < LOBE_TABLE_SIZE; i++) {
        table->above[i] = (float)(above[i] / (n1 * steps));
        table->weighted[i] = (float)(weighted[i] / (n1 * steps));
    }
}

static Colour lobe(const Material *material, GlossyModel model, Vec3 wi, Vec3 wo, Vec3 n)
{
    float cos_i = vec3_dot(n, wi);
    Vec3 mirror = vec3_sub(vec3_scale(n, 2.0f * cos_i), wi);
    float cos_alpha = vec3_dot(mirror, wo), power = cos_alpha > 0.0f ? powf(cos_alpha, material->exponent) : 0.0f;
    if (model == GLOSSY_PHONG)
        return colour_scale(material->specular, (material->exponent + 2.0f) / (2.0f * PI) * power);
    // The source text: where the diffuse draw fell on the mirror's side (probability (1+cosθ)/2) it became a lobe
    // sample; elsewhere the draw stayed, with the density cosθ_o/π of Lambert.
    if (cos_alpha <= 0.0f)
        return colour_scale(material->specular, 1.0f / PI);
    float p = 0.5f * (1.0f + cos_i) * power / lobe_lookup(material->lobe->above, cos_i);
    return colour_scale(material->specular, p / vec3_dot(n, wo));
}

// Less than ρ_d + ρ_s by what the lobe loses below the surface.
static Colour albedo(const Material *material, GlossyModel model, float cos_wi)
{
    float above = 1.0f;
    if (model == GLOSSY_PHONG)
        above = (material->exponent + 2.0f) / (2.0f * PI) * lobe_lookup(material->lobe->weighted, cos_wi);
    return colour_add(material->diffuse, colour_scale(material->specular, above));
}

static bool build(SceneEntry *entry, Material *material)
{
    material->diffuse = scene_colour(entry, "diffuse");
    material->specular = scene_colour(entry, "specular");
    material->exponent = scene_number(entry, "exponent");
    // 0.7 + 0.3 may come out a little above 1 in single precision.
    float most = colour_max(colour_add(material->diffuse, material->specular));
    if (most > 1.000001f)
        return scene_fault(entry, NULL,
                           "diffuse + specular of '%s' is %g in a channel; expected at most 1, or the surface "
                           "would give back more light than it gets",
                           material->name, most);
    material->lobe = calloc(1, sizeof *material->lobe);
    if (!material->lobe)
        return scene_fault(entry, NULL, "not enough memory");
    lobe_table_fill(material->lobe, material->exponent);
    return true;
}

static const SceneKeys keys = {
    {"diffuse", KEY_COLOUR, KEY_REQUIRED, RANGE_SHARE, "ρ_d: the share that is sent evenly to all sides"},
    {"specular", KEY_COLOUR, KEY_REQUIRED, RANGE_SHARE, "ρ_s: the lobe's share; ρ_d + ρ_s is at most 1"},
    {"exponent", KEY_NUMBER, KEY_REQUIRED, RANGE(0, 10000, NULL), "n of the lobe: the larger, the more like a mirror"},
};

MATERIAL_KIND(glossy) = {
    .scene = {"glossy", "glossy material", "Lambert, and a cosine lobe about the mirror direction.", keys,
              "{name: satin, type: glossy, diffuse: [0.3, 0.2, 0.1], specular: [0.6, 0.6, 0.6], exponent: 60}"},
    .build = build,
    .type = MATERIAL_GLOSSY,
    .optics = OPTICS_ROUGH,
    .cosine_lobe = true,
    .albedo = albedo,
    .lobe = lobe,
    .line = {70, 70, 70, 160},
    .line_hue = 120,
};
