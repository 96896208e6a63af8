// What the steps of stage 4 are given: gather rays in a scene whose surfaces all receive the same irradiance, what such
// rays have seen, estimates.
#include "judge/probe/probe_given.h"

#include "render/final_gather.h"

#include <stdlib.h>

#define DEPTH          24 // surfaces of one gather ray
#define MOST_ESTIMATES 1000

struct GatherScene {
    Scene *scene;
    RenderOptions options;
    FinalGather final;
    Eye eye;
    GatherTrace trace;
};

struct GivenEstimates {
    const IrradianceEstimate *near[MOST_ESTIMATES];
    IrradianceEstimate estimates[MOST_ESTIMATES];
};

// A line begins with SCENE and the irradiance that all its surfaces receive.
static bool read_scene(ProbeLine *line, Given *given)
{
    struct GatherScene *s = calloc(1, sizeof *s);
    if (!s)
        return error_set(line->error, "not enough memory");
    given->scene = s;
    s->scene = probe_scene(probe_word(line), line->error);
    s->final.ends = irradiance_map_uniform(probe_colour(line));
    if (!s->scene || !s->final.ends)
        return s->scene ? error_set(line->error, "not enough memory") : false;
    s->options.settings = s->scene->settings;
    s->options.settings.depth = DEPTH;
    s->eye = (Eye){.scene = s->scene, .options = &s->options, .final = &s->final};
    given->trace = &s->trace;
    return true;
}

// Scene, irradiance, and a ray: origin, direction.
bool read_ray_in_scene(ProbeLine *line, Given *given)
{
    bool ok = read_scene(line, given);
    given->ray.origin = probe_vec3(line);
    given->ray.direction = probe_vec3(line);
    given->ray.from = NO_PRIMITIVE;
    return ok;
}

// Scene, irradiance, and a ray whose end is the hit.
bool read_hit_in_scene(ProbeLine *line, Given *given)
{
    if (!read_ray_in_scene(line, given))
        return false;
    return line->broken || scene_intersect(given->scene->scene, &given->ray, given->hit) ||
           error_set(line->error, "the ray to the hit meets nothing");
}

// Distances, cell by cell, ring after ring. Radiances are NaN, since the step must not use them.
bool read_distances(ProbeLine *line, Given *given)
{
    for (int j = 0; j < GATHER_RINGS; j++)
        for (int k = 0; k < GATHER_SECTORS; k++) {
            given->seen->radiance[j][k] = colour_grey(NAN);
            given->seen->distance[j][k] = (float)probe_number(line);
        }
    return true;
}

// Their number; of each: position, normal, irradiance, reach, translation and rotation of the three channels.
bool read_estimates(ProbeLine *line, Given *given)
{
    struct GivenEstimates *all = given->estimates = calloc(1, sizeof *all);
    if (!all)
        return error_set(line->error, "not enough memory");
    given->count = (size_t)probe_whole(line, 0, MOST_ESTIMATES);
    if (line->broken)
        return true; // the caller tells of a broken line
    for (size_t i = 0; i < given->count; i++) {
        IrradianceEstimate *estimate = &all->estimates[i];
        estimate->position = probe_vec3(line);
        estimate->normal = probe_vec3(line);
        estimate->irradiance = probe_colour(line);
        estimate->reach = (float)probe_number(line);
        for (int c = 0; c < 3; c++)
            estimate->translation[c] = probe_vec3(line);
        for (int c = 0; c < 3; c++)
            estimate->rotation[c] = probe_vec3(line);
        all->near[i] = estimate;
    }
    given->near = all->near;
    return true;
}

// A ray that has met nothing yet.
void gather_given_renew(Given *given)
{
    if (given->trace)
        *given->trace = (GatherTrace){.eye = &given->scene->eye, .distance = INFINITY};
}

void gather_given_free(Given *given)
{
    if (given->scene) {
        scene_free(given->scene->scene);
        irradiance_map_free(given->scene->final.ends);
    }
    free(given->scene);
    free(given->estimates);
}
