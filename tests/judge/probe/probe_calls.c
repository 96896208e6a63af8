// `call` cases: a step's arguments out of a line, its results into the output. What each step is given stands in
// read_call, what is written per call in run_call; vectors and colours are three numbers.
//
//   step   arguments                                    results
//   1.1    direction, normal                            direction
//   1.2    corner, edge u, edge v, radiance             photon: position, direction, power, colour, bounce
//   1.3    normal                                       direction
//   1.4    power, reflectance                           survived, power
//   1.6    see read_surroundings                        radiance
//   2.1    exponent                                     direction
//   2.2    local, axis                                  direction
//   2.3 2.4  direction, normal, exponent                true, direction, weight; 2.3: calls of redraw_cap_reached
//   3.1    direction, normal, eta                       true, direction
//   3.2    cos_i, eta                                   reflectance
//   3.3    three indices, colour                        index
//   3.5    three indices, position, direction, power, colour, bounce       count, three photons
#include "judge/probe/probe.h"

#include <stdlib.h>
#include <string.h>

#define MOST_CALLS   2000000L
#define MOST_PHOTONS 4096 // given to step 1.6 in one case

// What a case's arguments make; each step takes its own part.
typedef struct {
    Vec3 a, b;
    float number;
    PhotonColour colour;
    Colour power, reflectance;
    Light light;
    Material material;
    LobeTable lobe;
    Photon photon;
    Hit hit;
    PhotonMap *map;
    Gather gather;
} Call;

// Left where a step must not write.
#define UNTOUCHED -77.0f

static PhotonColour read_colour(ProbeLine *line)
{
    return (PhotonColour)probe_whole(line, WHITE, BLUE);
}

static void read_glass(ProbeLine *line, Material *glass)
{
    glass->type = MATERIAL_GLASS;
    for (int c = 0; c < 3; c++)
        glass->index[c] = (float)probe_number(line);
    glass->disperses = glass->index[0] != glass->index[1] || glass->index[1] != glass->index[2];
}

// corner, edge_u, edge_v, radiance: direction, area and power follow.
static void read_light(ProbeLine *line, Light *light)
{
    light->type = LIGHT_RECTANGLE;
    light->position = probe_vec3(line);
    light->edge_u = probe_vec3(line);
    light->edge_v = probe_vec3(line);
    light->radiance = probe_colour(line);
    Vec3 across = vec3_cross(light->edge_u, light->edge_v);
    light->area = vec3_length(across);
    light->direction = vec3_normalize(across);
    light->power = colour_scale(light->radiance, PI * light->area);
}

// k, radius (0: no limit), point, normal, wo; surface (0 diffuse, 1 glossy as step 2.4 plays it, 2 as 2.3), ρ_d, ρ_s,
// exponent; count, then position, power, wi of each photon.
static bool read_surroundings(ProbeLine *line, Call *call, Error *error)
{
    call->gather.k = (size_t)probe_whole(line, 1, 1000);
    float radius = (float)probe_number(line);
    call->gather.radius = radius > 0.0f ? radius : INFINITY;
    call->hit.position = probe_vec3(line);
    call->hit.normal = call->hit.face_normal = probe_vec3(line);
    call->b = probe_vec3(line);
    long surface = probe_whole(line, 0, 2);
    call->material.type = surface ? MATERIAL_GLOSSY : MATERIAL_DIFFUSE;
    call->gather.glossy = surface == 2 ? GLOSSY_SOURCE_TEXT : GLOSSY_PHONG;
    call->material.diffuse = probe_colour(line);
    call->material.specular = probe_colour(line);
    call->material.exponent = (float)probe_number(line);
    if (surface)
        lobe_table_fill(&call->lobe, call->material.exponent);
    call->material.lobe = surface ? &call->lobe : NULL;
    call->hit.material = &call->material;
    call->hit.entering = true;
    long count = probe_whole(line, 0, MOST_PHOTONS);
    if (line->broken)
        return true; // said by the caller
    StoredPhoton *photons = calloc((size_t)count + 1, sizeof *photons);
    call->gather.near = malloc(PHOTON_MAP_NEAREST_ROOM(call->gather.k) * sizeof *call->gather.near);
    if (!photons || !call->gather.near) {
        free(photons);
        return error_set(error, "not enough memory");
    }
    for (long i = 0; i < count; i++) {
        photons[i].position = probe_vec3(line);
        photons[i].power = probe_colour(line);
        photons[i].packed_wi = direction_pack(probe_vec3(line));
        photons[i].path = PATH_INDIRECT;
    }
    call->map = photon_map_build(photons, (size_t)count, error);
    return call->map != NULL;
}

static bool read_call(const char *id, ProbeLine *line, Call *call, Error *error)
{
    if (strcmp(id, "1.1") == 0 || strcmp(id, "2.2") == 0) {
        call->a = probe_vec3(line);
        call->b = probe_vec3(line);
    } else if (strcmp(id, "1.2") == 0) {
        read_light(line, &call->light);
    } else if (strcmp(id, "1.3") == 0) {
        call->a = probe_vec3(line);
    } else if (strcmp(id, "1.4") == 0) {
        call->power = probe_colour(line);
        call->reflectance = probe_colour(line);
    } else if (strcmp(id, "1.6") == 0) {
        return read_surroundings(line, call, error);
    } else if (strcmp(id, "2.1") == 0) {
        call->number = (float)probe_number(line);
    } else if (strcmp(id, "2.3") == 0 || strcmp(id, "2.4") == 0 || strcmp(id, "3.1") == 0) {
        call->a = probe_vec3(line);
        call->b = probe_vec3(line);
        call->number = (float)probe_number(line);
    } else if (strcmp(id, "3.2") == 0) {
        call->a.x = (float)probe_number(line);
        call->number = (float)probe_number(line);
    } else if (strcmp(id, "3.3") == 0) {
        read_glass(line, &call->material);
        call->colour = read_colour(line);
    } else if (strcmp(id, "3.5") == 0) {
        read_glass(line, &call->material);
        call->photon.position = probe_vec3(line);
        call->photon.direction = probe_vec3(line);
        call->photon.power = probe_colour(line);
        call->photon.colour = read_colour(line);
        call->photon.bounce = (int)probe_whole(line, 0, 1000);
    } else {
        return error_set(error, "step %s is not called alone; use paths or picture", id);
    }
    return true;
}

static void put_photon(ProbeOutput *output, const Photon *photon)
{
    probe_put_vec3(output, photon->position);
    probe_put_vec3(output, photon->direction);
    probe_put_colour(output, photon->power);
    probe_put(output, (float)photon->colour);
    probe_put(output, (float)photon->bounce);
}

// ok (1 or 0), direction, weight.
static void put_glossy(const Call *call, Rng *rng, ProbeOutput *output,
                       bool (*scatter)(Vec3, Vec3, float, Rng *, Vec3 *, float *))
{
    Vec3 out = vec3(UNTOUCHED, UNTOUCHED, UNTOUCHED);
    float weight = UNTOUCHED;
    bool ok = scatter(call->a, call->b, call->number, rng, &out, &weight);
    probe_put(output, ok ? 1.0f : 0.0f);
    probe_put_vec3(output, out);
    probe_put(output, weight);
}

static void put_split(const Call *call, ProbeOutput *output)
{
    Photon children[3];
    Photon untouched = photon_create(vec3(UNTOUCHED, 0, 0), vec3(0, 0, 1), colour_grey(UNTOUCHED));
    for (int i = 0; i < 3; i++)
        children[i] = untouched;
    probe_put(output, (float)steps.split_colour(&call->photon, &call->material, children));
    for (int i = 0; i < 3; i++)
        put_photon(output, &children[i]);
}

static void run_call(const char *id, Call *call, Rng *rng, ProbeOutput *output)
{
    if (strcmp(id, "1.1") == 0) {
        probe_put_vec3(output, steps.reflect(call->a, call->b));
    } else if (strcmp(id, "1.2") == 0) {
        Photon photon = steps.emit_photon(&call->light, rng);
        put_photon(output, &photon);
    } else if (strcmp(id, "1.3") == 0) {
        probe_put_vec3(output, steps.scatter_diffuse(call->a, rng));
    } else if (strcmp(id, "1.4") == 0) {
        Colour power = call->power;
        probe_put(output, steps.russian_roulette(&power, call->reflectance, rng) ? 1.0f : 0.0f);
        probe_put_colour(output, power);
    } else if (strcmp(id, "1.6") == 0) {
        probe_put_colour(output, steps.estimate_radiance(call->map, &call->hit, call->b, &call->gather));
    } else if (strcmp(id, "2.1") == 0) {
        probe_put_vec3(output, steps.sample_lobe(call->number, rng));
    } else if (strcmp(id, "2.2") == 0) {
        probe_put_vec3(output, steps.turn_to(call->a, call->b));
    } else if (strcmp(id, "2.3") == 0) {
        long before = redraw_cap_count();
        put_glossy(call, rng, output, steps.scatter_glossy_source_text);
        probe_put(output, (float)(redraw_cap_count() - before));
    } else if (strcmp(id, "2.4") == 0) {
        put_glossy(call, rng, output, steps.scatter_glossy_phong);
    } else if (strcmp(id, "3.1") == 0) {
        Vec3 refracted = vec3(UNTOUCHED, UNTOUCHED, UNTOUCHED);
        probe_put(output, steps.refract(call->a, call->b, call->number, &refracted) ? 1.0f : 0.0f);
        probe_put_vec3(output, refracted);
    } else if (strcmp(id, "3.2") == 0) {
        probe_put(output, steps.fresnel(call->a.x, call->number));
    } else if (strcmp(id, "3.3") == 0) {
        probe_put(output, steps.refractive_index(&call->material, call->colour));
    } else if (strcmp(id, "3.5") == 0) {
        put_split(call, output);
    }
}

bool probe_call(const StepInfo *step, ProbeLine *line, ProbeOutput *output, Error *error)
{
    static Call call; // large, and one case runs at a time
    memset(&call, 0, sizeof call);
    long count = probe_whole(line, 1, MOST_CALLS);
    uint64_t seed = probe_seed(line);
    bool ok = read_call(step->id, line, &call, error);
    if (ok && (line->broken || !probe_at_end(line)))
        ok = error_set(error, "the arguments do not fit step %s", step->id);
    for (long i = 0; ok && i < count; i++) {
        Rng rng = rng_create(seed, (uint64_t)i);
        run_call(step->id, &call, &rng, output);
    }
    photon_map_free(call.map);
    free(call.gather.near);
    return ok;
}
