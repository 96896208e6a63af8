// What steps are given that is no plain value: each reader takes its part of a line, before the parameters.
#pragma once

#include "judge/probe/probe.h"

// What a reader provides, called as the rows of steps.def call it, and what that is made of.
typedef struct {
    Light light[1];
    Material glass[1]; // or of the surface that is hit
    Photon photon[1];
    PhotonMap *map;
    Hit hit[1];
    Vec3 wo;
    Gather gather[1];
    GatherTrace *trace;
    Ray ray;
    Hemisphere seen[1];
    const IrradianceEstimate *const *near;
    size_t count;

    SellmeierGlass formula;
    LobeTable lobe;
    struct GatherScene *scene;
    struct GivenEstimates *estimates;
} Given;

typedef bool Reader(ProbeLine *line, Given *given);
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
