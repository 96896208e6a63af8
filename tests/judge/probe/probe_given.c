#include "judge/probe/probe_given.h"

#include <math.h>
#include <stdlib.h>

#define MOST_PHOTONS 4096 // around a point

static PhotonColour photon_colour(ProbeLine *line)
{
    return (PhotonColour)probe_whole(line, WHITE, BLUE);
}

bool read_arguments(ProbeLine *line, Given *given)
{
    (void)line, (void)given;
    return true;
}

bool read_glass(ProbeLine *line, Given *given)
{
    Material *glass = given->glass;
    glass->type = MATERIAL_GLASS;
    for (int c = 0; c < 3; c++)
        glass->index[c] = (float)probe_number(line);
    glass->disperses = glass->index[0] != glass->index[1] || glass->index[1] != glass->index[2];
    return true;
}

// A, B, then Sellmeier's b and c; all b 0: it has none.
bool read_glass_formula(ProbeLine *line, Given *given)
{
    Material *glass = given->glass;
    SellmeierGlass *formula = &given->formula;
    double any = 0.0;
    glass->type = MATERIAL_GLASS;
    for (int c = 0; c < 2; c++)
        glass->cauchy[c] = (float)probe_number(line);
    for (int i = 0; i < SELLMEIER_TERMS; i++)
        any += fabs(formula->b[i] = probe_number(line));
    for (int i = 0; i < SELLMEIER_TERMS; i++)
        formula->c[i] = probe_number(line);
    glass->sellmeier = any > 0.0 ? formula : NULL;
    return true;
}

bool read_glass_and_photon(ProbeLine *line, Given *given)
{
    Photon *photon = given->photon;
    read_glass(line, given);
    photon->position = probe_vec3(line);
    photon->direction = probe_vec3(line);
    photon->power = probe_colour(line);
    photon->colour = photon_colour(line);
    photon->bounce = (int)probe_whole(line, 0, 1000);
    photon->path = (PhotonPath)probe_whole(line, PATH_DIRECT, PATH_INDIRECT);
    photon->from = (uint32_t)probe_whole(line, 0, 1000);
    photon->flown = (float)probe_number(line);
    return true;
}

// corner, edge_u, edge_v, radiance: direction, area and power follow.
bool read_light(ProbeLine *line, Given *given)
{
    Light *light = given->light;
    light->type = LIGHT_RECTANGLE;
    light->position = probe_vec3(line);
    light->edge_u = probe_vec3(line);
    light->edge_v = probe_vec3(line);
    light->radiance = probe_colour(line);
    Vec3 across = vec3_cross(light->edge_u, light->edge_v);
    light->area = vec3_length(across);
    light->direction = vec3_normalize(across);
    light->power = colour_scale(light->radiance, PI * light->area);
    return true;
}

// k, radius (0: no limit), point, normal, wo; surface (0 diffuse, 1 glossy as step 2.4 plays it, 2 as 2.3), ρ_d, ρ_s,
// exponent; count, then position, power, wi of each photon.
bool read_surroundings(ProbeLine *line, Given *given)
{
    Gather *gather = given->gather;
    Hit *hit = given->hit;
    Material *material = given->glass;
    gather->k = (size_t)probe_whole(line, 1, 1000);
    float radius = (float)probe_number(line);
    gather->radius = radius > 0.0f ? radius : INFINITY;
    hit->position = probe_vec3(line);
    hit->normal = hit->face_normal = probe_vec3(line);
    given->wo = probe_vec3(line);
    long surface = probe_whole(line, 0, 2);
    material->type = surface ? MATERIAL_GLOSSY : MATERIAL_DIFFUSE;
    gather->glossy = surface == 2 ? GLOSSY_SOURCE_TEXT : GLOSSY_PHONG;
    material->diffuse = probe_colour(line);
    material->specular = probe_colour(line);
    material->exponent = (float)probe_number(line);
    if (surface)
        lobe_table_fill(&given->lobe, material->exponent);
    material->lobe = surface ? &given->lobe : NULL;
    hit->material = material;
    hit->entering = true;
    long count = probe_whole(line, 0, MOST_PHOTONS);
    if (line->broken)
        return true; // the caller tells of a broken line
    StoredPhoton *photons = calloc((size_t)count + 1, sizeof *photons);
    gather->near = malloc(PHOTON_MAP_NEAREST_CAPACITY(gather->k) * sizeof *gather->near);
    if (!photons || !gather->near) {
        free(photons);
        return error_set(line->error, "not enough memory");
    }
    for (long i = 0; i < count; i++) {
        photons[i].position = probe_vec3(line);
        photons[i].power = probe_colour(line);
        photons[i].packed_wi = direction_pack(probe_vec3(line));
        photons[i].path = PATH_INDIRECT;
    }
    given->map = photon_map_build(photons, (size_t)count, line->error);
    return given->map != NULL;
}

void given_renew(Given *given)
{
    gather_given_renew(given);
}

void given_free(Given *given)
{
    gather_given_free(given);
    photon_map_free(given->map);
    free(given->gather->near);
}
