// Materials: what a surface does with light.
#pragma once

#include "base/error.h"
#include "math/colour.h"
#include "math/vec3.h"
#include "scene/glass_catalogue.h"

#include <stdbool.h>

// What steps 1.5 and 3.4 tell apart. A kind that the course does not teach has the type MATERIAL_GLOSSY: for that one
// the steps call photon_scatter_glossy, which knows all kinds.
typedef enum {
    MATERIAL_DIFFUSE, // Lambert: f = ρ_d/π
    MATERIAL_GLOSSY,  // ρ_d/π plus a cosine lobe about the mirror direction
    MATERIAL_MIRROR,
    MATERIAL_GLASS, // clear, exact unpolarised Fresnel
    MATERIAL_LIGHT  // emits from its outside, reflects nothing, black from behind
} MaterialType;
enum { MATERIAL_TYPES = MATERIAL_LIGHT + 1 };

#define LOBE_TABLE_SIZE 513

// Integrals of the lobe cosⁿα over the upper hemisphere by the mirror direction's angle θ to the normal, tabulated
// evenly in cosθ from 0 to 1 (Arvo 1995; Mallett & Yuksel 2020):
//   above = I_P = ∫cosⁿα dω,   weighted = I_M = ∫cosⁿα cosθ_o dω.
typedef struct {
    float above[LOBE_TABLE_SIZE], weighted[LOBE_TABLE_SIZE];
} LobeTable;

typedef struct MaterialKind MaterialKind;

typedef struct {
    char name[64];
    MaterialType type;
    const MaterialKind *kind; // NULL: the course's own of this type
    Colour diffuse;           // ρ_d: diffuse and glossy; 0…1
    Colour specular;          // ρ_s: the lobe's (glossy) or the mirror's reflectance; 0…1, with ρ_d + ρ_s ≤ 1
    float exponent;           // n of the glossy lobe, ≥ 0
    LobeTable *lobe;          // glossy only; owned by the scene
    float index[3];           // refractive index for red, green and blue, > 0
    bool disperses;           // the three differ: white light splits here
    // For single wavelengths, of glass: a real one's formula, or NULL, and A and B (µm²) of Cauchy's, A + B/λ².
    const SellmeierGlass *sellmeier;
    float cauchy[2];
    Colour radiance; // emitted, W/(m²·sr); lights only
} Material;

// Which of the two glossy schemes is played: step 2.3 or step 2.4.
typedef enum {
    GLOSSY_PHONG,      // 2.4: modified Phong, energy-conserving and reciprocal
    GLOSSY_SOURCE_TEXT // 2.3: the source text's gap and lobe
} GlossyModel;

// Do photons end their specular path here (are they stored, is the map looked up)?
bool material_is_rough(const Material *material);

// BRDF f_r(wi, wo) in 1/sr of a rough material; wi towards the light, wo towards the eye, n the unit normal on their
// side.
//   diffuse: ρ_d/π.
//   glossy, GLOSSY_PHONG: ρ_d/π + ρ_s·(n+2)/(2π)·cosⁿα, α between wo and the mirror direction of wi
//     (Lafortune & Willems 1994). Reciprocal.
//   glossy, GLOSSY_SOURCE_TEXT: ρ_d/π + ρ_s·p(wo)/cosθ_o, with p the density that step 2.3 samples. It is what those
//     photons carry, but no material: it is not reciprocal. Its I_P(θ) is a finite sum for whole n only.
// Zero when wi or wo is below the surface. material_lobe: the part with ρ_s alone.
Colour material_lobe(const Material *material, GlossyModel model, Vec3 wi, Vec3 wo, Vec3 n);
Colour material_brdf(const Material *material, GlossyModel model, Vec3 wi, Vec3 wo, Vec3 n);

// Share of light from wi that the material sends back, per channel (the albedo a(wi), 0…1): for glossy it is less by
// what the lobe loses below the surface. Mirrors: ρ_s. Glass: 1. Lights: 0.
Colour material_albedo(const Material *material, GlossyModel model, float cos_wi);

// Fills the table for exponent n ≥ 0 by quadrature. lobe_lookup interpolates between the entries of either; relative
// error below 1e-3 for n ≤ 1000 and θ ≤ 85°.
void lobe_table_fill(LobeTable *table, float exponent);
float lobe_lookup(const float table[LOBE_TABLE_SIZE], float cos_theta);
