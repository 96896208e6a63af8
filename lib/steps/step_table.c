#include "steps/step_hints.h"

#include <stddef.h>
#include <string.h>

#define D "1_diffuse_photon_map/"
#define G "2_glossy_lobe/"
#define C "3_colour_dispersion/"

const StepInfo step_table[STEP_COUNT] = {
    {"1.1", "reflect", 1, D "1.1_reflect", "Reflect a direction", step_hints[0], "1_diffuse_photon_map.html#reflect",
     offsetof(Steps, reflect)},
    {"1.2", "emit_photon", 1, D "1.2_emit_photon", "Emit a photon from an area light", step_hints[1],
     "1_diffuse_photon_map.html#emission", offsetof(Steps, emit_photon)},
    {"1.3", "scatter_diffuse", 1, D "1.3_scatter_diffuse", "Scatter diffusely", step_hints[2],
     "1_diffuse_photon_map.html#cosine-hemisphere", offsetof(Steps, scatter_diffuse)},
    {"1.4", "russian_roulette", 1, D "1.4_russian_roulette", "Play Russian roulette", step_hints[3],
     "1_diffuse_photon_map.html#russian-roulette", offsetof(Steps, russian_roulette)},
    {"1.5", "trace_photon", 1, D "1.5_trace_photon", "Trace a photon: the loop", step_hints[4],
     "1_diffuse_photon_map.html#loop", offsetof(Steps, trace_photon)},
    {"1.6", "estimate_radiance", 1, D "1.6_estimate_radiance", "Estimate radiance from photons", step_hints[5],
     "1_diffuse_photon_map.html#density-estimation", offsetof(Steps, estimate_radiance)},
    {"2.1", "sample_lobe", 2, G "2.1_sample_lobe", "Sample the cosine lobe", step_hints[6], "2_glossy_lobe.html#lobe",
     offsetof(Steps, sample_lobe)},
    {"2.2", "turn_to", 2, G "2.2_turn_to", "Turn the lobe to the mirror direction", step_hints[7],
     "2_glossy_lobe.html#turning", offsetof(Steps, turn_to)},
    {"2.3", "scatter_glossy_source_text", 2, G "2.3_scatter_glossy_source_text", "Scatter as the source text does",
     step_hints[8], "2_glossy_lobe.html#gap", offsetof(Steps, scatter_glossy_source_text)},
    {"2.4", "scatter_glossy_phong", 2, G "2.4_scatter_glossy_phong", "Scatter as the modified Phong BRDF",
     step_hints[9], "2_glossy_lobe.html#energy", offsetof(Steps, scatter_glossy_phong)},
    {"3.1", "refract", 3, C "3.1_refract", "Refract", step_hints[10], "3_colour_dispersion.html#snell",
     offsetof(Steps, refract)},
    {"3.2", "fresnel", 3, C "3.2_fresnel", "Fresnel reflectance", step_hints[11], "3_colour_dispersion.html#fresnel",
     offsetof(Steps, fresnel)},
    {"3.3", "refractive_index", 3, C "3.3_refractive_index", "The index of a colour", step_hints[12],
     "3_colour_dispersion.html#index", offsetof(Steps, refractive_index)},
    {"3.4", "trace_photon_in_colour", 3, C "3.4_trace_photon_in_colour", "Trace a photon: the recursion",
     step_hints[13], "3_colour_dispersion.html#recursion", offsetof(Steps, trace_photon_in_colour)},
    {"3.5", "split_colour", 3, C "3.5_split_colour", "Split white at its first refraction", step_hints[14],
     "3_colour_dispersion.html#split", offsetof(Steps, split_colour)},
};

const StepInfo *step_find(const char *id)
{
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (strcmp(step_table[i].id, id) == 0)
            return &step_table[i];
    return NULL;
}
