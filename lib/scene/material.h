// Materials: what a surface does with light.
#ifndef PHOTONLAB_SCENE_MATERIAL_H
#define PHOTONLAB_SCENE_MATERIAL_H

#include "base/error.h"
#include "math/colour.h"
#include "math/vec3.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

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
    Colour radiance;          // emitted, W/(m²·sr); lights only
} Material;

// Which of the two glossy schemes is played: step 2.3 or step 2.4.
typedef enum {
    GLOSSY_PHONG,      // 2.4: modified Phong, energy-conserving and reciprocal
    GLOSSY_SOURCE_TEXT // 2.3: the source text's gap and lobe
} GlossyModel;

// How a surface treats rays.
typedef enum {
    OPTICS_ROUGH = 1, // sends light everywhere, by its BRDF; photons are stored there
    OPTICS_MIRROR,    // turns each ray into one other
    OPTICS_GLASS,     // reflects and refracts
    OPTICS_LIGHT      // gives light, takes all that comes
} MaterialOptics;

// A kind of material; a test names what one leaves out.
struct MaterialKind {
    const char *name;
    MaterialType type;
    MaterialOptics optics;
    bool cosine_lobe; // rough: its lobe is the course's, cosⁿα about the mirror direction
    // Share of light from wi that the surface sends back, per channel: the albedo a(wi), 0…1.
    Colour (*albedo)(const Material *material, GlossyModel model, float cos_wi);
    // Rough: the BRDF beside ρ_d/π, for wi and wo above the surface; NULL: there is nothing beside it.
    Colour (*lobe)(const Material *material, GlossyModel model, Vec3 wi, Vec3 wo, Vec3 n);
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

// Do photons end their specular path here (are they stored, is the map looked up)?
static inline bool material_is_rough(const Material *material)
{
    return material_kind(material)->optics == OPTICS_ROUGH;
}

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

static inline Colour material_albedo(const Material *material, GlossyModel model, float cos_wi)
{
    return material_kind(material)->albedo(material, model, cos_wi);
}

// Fills the table for exponent n ≥ 0 by quadrature. Between its entries the functions below interpolate; relative
// error below 1e-3 for n ≤ 1000 and θ ≤ 85°.
void lobe_table_fill(LobeTable *table, float exponent);
float lobe_above_surface(const LobeTable *table, float cos_theta);          // I_P
float lobe_weighted_above_surface(const LobeTable *table, float cos_theta); // I_M

#endif
