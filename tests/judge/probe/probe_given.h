// What steps are given that is no plain value: each reader takes its part of a line, before the parameters.
#ifndef PHOTONLAB_PROBE_GIVEN_H
#define PHOTONLAB_PROBE_GIVEN_H

#include "judge/probe/probe.h"

// What a reader provides, called as the rows of steps.def call it, and what that is made of.
typedef struct {
    const Light *light;
    const Material *glass;
    const Photon *photon;
    PhotonMap *map;
    const Hit *hit;
    Vec3 wo;
    Gather *gather;
    GatherTrace *trace;
    Ray ray;
    const Hemisphere *seen;
    const IrradianceEstimate *const *near;
    size_t count;

    Light light_read;
    Material material_read;
    SellmeierGlass formula_read;
    Photon photon_read;
    Hit hit_read;
    Gather gather_read;
    LobeTable lobe;
    struct GatherScene *scene;
    Hemisphere seen_read;
    struct GivenEstimates *estimates;
} Given;

typedef bool Reader(ProbeLine *line, Given *given, Error *error);
Reader read_arguments; // nothing
Reader read_glass;
Reader read_glass_formula;
Reader read_glass_and_photon;
Reader read_light;
Reader read_surroundings;
// probe_gather.c
Reader read_ray_in_scene;
Reader read_hit_in_scene;
Reader read_distances;
Reader read_estimates;
void gather_given_renew(Given *given);
void gather_given_free(Given *given);

void given_renew(Given *given); // as it was read, for the next call
void given_free(Given *given);

#endif
