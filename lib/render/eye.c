#include "render/eye.h"
#include "scene/material_kind.h"

#include "render/final_gather.h"

#define ALIVE_WEIGHT  0.05f // below it a ray survives by roulette
#define CAUSTIC_SHARE 4     // caustics are estimated from k/4 photons …
#define CAUSTIC_LEAST 20    // … but not from fewer than these, if k is larger; in a pass: from a disk of
#define CAUSTIC_REACH 0.5f  // this part of its radius
#define LOBE_RAYS     4     // GATHER: sent into the lobe of a glossy surface that the eye sees straight

static Colour trace(Eye *eye, const Ray *ray, EyeRay carried);

// What a matt surface sends back of one map's light; from the cache, if an estimate was made nearby on the same
// material. For the matt part of another rough surface, hit->material is a matt copy and `material` the scene's own,
// which the cache goes by.
static Colour matt_from_map(Eye *eye, const PhotonMap *map, RadianceCache *cache, const Hit *hit,
                            const Material *material, Vec3 wo)
{
    float reuse = eye->options->reuse;
    Colour radiance;
    if (reuse > 0.0f && radiance_cache_find(cache, hit->position, hit->normal, material, &radiance))
        return radiance;
    eye->gather.reach = 0.0f;
    radiance = steps.estimate_radiance(map, hit, wo, &eye->gather);
    // Where photons happen to be sparse, the radius is large and the estimate low; a reach in proportion to it would
    // spread low estimates farther than high ones. Rounded to a power of two, the reach does not follow such noise.
    if (reuse > 0.0f && eye->gather.reach > 0.0f) {
        float reach = reuse * ldexpf(1.0f, ilogbf(eye->gather.reach));
        radiance_cache_add(cache, &(CachedRadiance){hit->position, hit->normal, material, reach, radiance});
    }
    return radiance;
}

// Caustics are sharp and their photons dense: fewer of them make an estimate. GATHER has more of them.
Colour caustic_light(Eye *eye, const Hit *hit, Vec3 wo)
{
    if (photon_map_count(eye->caustic) == 0)
        return colour_grey(0.0f);
    size_t k = eye->gather.k;
    float radius = eye->gather.radius;
    if (eye->options->pass)
        eye->gather.radius *= CAUSTIC_REACH;
    else if (eye->options->integrator != INTEGRATOR_GATHER)
        eye->gather.k = k / CAUSTIC_SHARE > CAUSTIC_LEAST ? k / CAUSTIC_SHARE : k < CAUSTIC_LEAST ? k : CAUSTIC_LEAST;
    Colour radiance = !material_kind(hit->material)->lobe
                          ? matt_from_map(eye, eye->caustic, &eye->caustic_cache, hit, hit->material, wo)
                          : steps.estimate_radiance(eye->caustic, hit, wo, &eye->gather);
    eye->gather.k = k;
    eye->gather.radius = radius;
    return radiance;
}

// Photons of a map within the radius of the pixel's point, as this much of their light reaches the eye: step 1.6 without a kernel
// and without its division, since the radius is to shrink (step 5.3).
static void point_collect(Eye *eye, const PhotonMap *map, const Hit *hit, Vec3 wo, Colour weight)
{
    float radius;
    size_t near = gather_near(map, hit->position, &eye->gather, &radius);
    Colour sum = colour_grey(0.0f);
    for (size_t i = 0; i < near; i++) {
        const StoredPhoton *photon = eye->gather.near[i].photon;
        if (!stored_photon_on_side(photon, hit->normal))
            continue;
        sum = colour_add(sum, colour_mul(gather_brdf(&eye->gather, hit, photon, wo), photon->power));
        eye->found++;
    }
    eye->flux = colour_add(eye->flux, colour_mul(weight, sum));
}

Colour eye_follow(Eye *eye, const Hit *hit, Vec3 direction, Colour share, EyeRay carried)
{
    Colour onward = colour_mul(carried.weight, share);
    float brightest = colour_max(onward);
    if (brightest <= 0.0f)
        return colour_grey(0.0f);
    float survival = 1.0f;
    if (brightest < ALIVE_WEIGHT) {
        survival = brightest / ALIVE_WEIGHT;
        if (rng_float(&eye->rng) >= survival)
            return colour_grey(0.0f);
    }
    Ray ray = {hit->position, direction, hit->primitive};
    carried.weight = colour_scale(onward, 1.0f / survival);
    carried.bounce++;
    return colour_scale(colour_mul(share, trace(eye, &ray, carried)), 1.0f / survival);
}

// Indirect light in a glossy lobe. Few of the photons found lie in a narrow lobe, so the map is looked up where a ray
// drawn from the lobe ends. Lights are not seen there: shadow rays and the caustic map have counted them.
static Colour indirect_lobe(Eye *eye, const Hit *hit, Vec3 wo, EyeRay carried)
{
    // The source text's scheme leaks past the lobe as well, by a share that grows with the angle.
    float cos_o = vec3_dot(wo, hit->normal);
    float lobe_share = !material_kind(hit->material)->cosine_lobe        ? 0.0f
                       : eye->options->play.glossy == GLOSSY_SOURCE_TEXT ? fminf(0.5f * (1.0f + cos_o), 0.95f)
                                                                         : 1.0f;
    int rays = eye->options->integrator == INTEGRATOR_GATHER && carried.bounce == 0 ? LOBE_RAYS : 1;
    Sampler sampler = eye->sampler;
    sampler.index *= (uint32_t)rays;
    Colour sum = colour_grey(0.0f);
    carried.sees_lights = false;
    for (int i = 0; i < rays; i++, sampler.index++) {
        float choice = rng_float(&eye->rng);
        float u, v;
        sampler_point(&sampler, SAMPLER_LOBE + (uint32_t)carried.bounce, &u, &v);
        Vec3 wi;
        float pdf;
        if (!sample_rough(hit, wo, lobe_share, choice, u, v, &wi, &pdf))
            continue;
        Colour f = material_lobe(hit->material, eye->options->play.glossy, wi, wo, hit->normal);
        Colour share = colour_scale(f, vec3_dot(wi, hit->normal) / pdf / (float)rays);
        sum = colour_add(sum, eye_follow(eye, hit, wi, share, carried));
    }
    return sum;
}

// Light leaving a rough surface. PHOTONS_ONLY does what the source text does: one look-up at the first such surface.
static Colour rough_surface(Eye *eye, const Hit *hit, Vec3 wo, EyeRay carried)
{
    const Material *material = hit->material;
    if (eye->options->integrator == INTEGRATOR_PHOTONS_ONLY)
        return steps.estimate_radiance(eye->rest, hit, wo, &eye->gather);
    Colour sum = direct_light(eye, hit, wo);
    if (eye->point)
        point_collect(eye, eye->caustic, hit, wo, carried.weight);
    else
        sum = colour_add(sum, caustic_light(eye, hit, wo));
    bool has_lobe = material_kind(material)->lobe;
    if (eye->options->integrator == INTEGRATOR_GATHER) {
        Colour irradiance = final_gather_irradiance(eye, hit, wo, carried.distance);
        sum = colour_add(sum, colour_scale(colour_mul(material->diffuse, irradiance), 1.0f / PI));
        return has_lobe ? colour_add(sum, indirect_lobe(eye, hit, wo, carried)) : sum;
    }
    Material matt = *material;
    Hit on_matt = *hit;
    if (has_lobe) {
        matt.type = MATERIAL_DIFFUSE;
        matt.kind = NULL;
        on_matt.material = &matt;
    }
    if (eye->point)
        point_collect(eye, eye->rest, &on_matt, wo, carried.weight);
    else
        sum = colour_add(sum, matt_from_map(eye, eye->rest, &eye->rest_cache, &on_matt, material, wo));
    return has_lobe ? colour_add(sum, indirect_lobe(eye, hit, wo, carried)) : sum;
}

static Colour trace(Eye *eye, const Ray *ray, EyeRay carried)
{
    Hit hit;
    eye->rays++;
    if (carried.bounce > eye->options->settings.depth || !scene_intersect(eye->scene, ray, &hit))
        return colour_grey(0.0f);
    carried.distance += hit.distance;
    const MaterialKind *kind = material_kind(hit.material);
    switch (kind->optics) {
    case OPTICS_LIGHT:
        return carried.sees_lights && hit.entering ? hit.material->radiance : colour_grey(0.0f);
    case OPTICS_ROUGH:
        return rough_surface(eye, &hit, vec3_negate(ray->direction), carried);
    case OPTICS_MIRROR:
        return eye_follow(eye, &hit, kind->turn(ray->direction, hit.normal), hit.material->specular, carried);
    case OPTICS_GLASS:
        return eye_glass(eye, &hit, ray->direction, carried);
    }
    return colour_grey(0.0f);
}

Colour eye_radiance(Eye *eye, const Ray *ray)
{
    return trace(eye, ray, (EyeRay){colour_grey(1.0f), WHITE, 0.0f, 0, true, 0.0f});
}
