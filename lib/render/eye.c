#include "render/eye.h"
#include "scene/material_kind.h"

#include "render/final_gather.h"

#define SPLIT_WEIGHT  0.25f // glass: both ways are followed while the ray still carries this much …
#define ALIVE_WEIGHT  0.05f // … and below this a ray survives by roulette
#define CAUSTIC_SHARE 4     // caustics are estimated from k/4 photons …
#define LOBE_RAYS     4     // GATHER: sent into the lobe of a glossy surface that the eye sees straight
#define CAUSTIC_LEAST 20    // … but not from fewer than these, if k is larger; in a pass: from a disk of
#define CAUSTIC_REACH 0.5f  // this part of its radius

typedef struct {
    Colour weight;       // the share of what it brings back that reaches the camera: tells bright rays from faint ones
    PhotonColour colour; // WHITE, or the one that is left after dispersing glass
    float wavelength;    // nm; 0: all of them. With wavelengths, the one that is left after dispersing glass
    int bounce;          // surfaces met so far
    bool sees_lights;    // false where shadow rays have counted them
    float distance;      // m, so far
} EyeRay;

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

// One way on from a surface, by a share of what the ray carries. Faint rays play roulette.
static Colour follow(Eye *eye, const Hit *hit, Vec3 direction, Colour share, EyeRay carried)
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
        sum = colour_add(sum, follow(eye, hit, wi, share, carried));
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
    if (eye->has_point)
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
    if (eye->has_point)
        point_collect(eye, eye->rest, &on_matt, wo, carried.weight);
    else
        sum = colour_add(sum, matt_from_map(eye, eye->rest, &eye->rest_cache, &on_matt, material, wo));
    return has_lobe ? colour_add(sum, indirect_lobe(eye, hit, wo, carried)) : sum;
}

static Colour only_channel(int channel, float value)
{
    Colour result = colour_grey(0.0f);
    colour_set_channel(&result, channel, value);
    return result;
}

// What glass does with one index: the refracted direction and the shares of radiance that come from either way.
static void glass_way(const Eye *eye, const Hit *hit, Vec3 direction, float index, Vec3 *refracted, float *reflected,
                      float *through)
{
    bool front_only = eye->options->glass_sides == 1;
    if (front_only && !hit->entering) { // as if the glass had no back
        *refracted = direction;
        *reflected = 0.0f;
        *through = 1.0f;
        return;
    }
    *refracted = direction;
    *reflected = glass_optics(hit, direction, index, refracted);
    // Radiance is squeezed into the denser side's narrower cone: L/n² stays the same along a ray (Veach 1996).
    float eta = hit->entering ? 1.0f / index : index;
    *through = (1.0f - *reflected) * (front_only ? 1.0f : eta * eta);
}

// One of both ways by chance, where the ray is faint: what either then counts.
static void take_ways(Eye *eye, Colour weight, float reflected, float *take_reflected, float *take_through)
{
    *take_reflected = *take_through = 1.0f;
    if (colour_max(weight) >= SPLIT_WEIGHT)
        return;
    bool reflect = rng_float(&eye->rng) < reflected;
    *take_reflected = reflect ? 1.0f / reflected : 0.0f;
    *take_through = reflect ? 0.0f : 1.0f / (1.0f - reflected);
}

// Light through dispersing glass, with wavelengths: a ray of all of them refracts three ways, each by a wavelength of its own, spread
// evenly over the pixel's samples. What comes back is red, green and blue; at that wavelength it is taken as a wall's reflectance
// would be, and it has the wavelength's colour. In the mean that is the light that came.
static Colour spectral_glass(Eye *eye, const Hit *hit, Vec3 direction, EyeRay carried)
{
    float wavelength[3] = {carried.wavelength}, weight[3] = {1.0f}, through[3], place, unused;
    Vec3 refracted[3];
    int ways = carried.wavelength > 0.0f ? 1 : 3;
    float reflected = 0.0f, weights = 0.0f;
    sampler_point(&eye->sampler, SAMPLER_WAVE, &place, &unused);
    for (int i = 0; i < ways; i++) {
        float r, u = place + (float)i / 3.0f;
        if (ways > 1)
            wavelength[i] = steps.draw_wavelength(u < 1.0f ? u : u - 1.0f, &weight[i]);
        float index = steps.index_at_wavelength(hit->material, wavelength[i]);
        glass_way(eye, hit, direction, index, &refracted[i], &r, &through[i]);
        reflected += weight[i] * r;
        weights += weight[i];
    }
    reflected = fminf(reflected / weights, 1.0f);

    float take_reflected, take_through;
    take_ways(eye, carried.weight, reflected, &take_reflected, &take_through);
    Vec3 back = mirror_direction(direction, hit->normal);
    Colour sum = follow(eye, hit, back, colour_grey(reflected * take_reflected), carried);
    for (int i = 0; i < ways; i++) {
        EyeRay onward = carried;
        onward.wavelength = wavelength[i];
        float share = through[i] * take_through * weight[i] / (float)ways;
        Colour seen = follow(eye, hit, refracted[i], colour_grey(share), onward);
        if (ways > 1)
            seen = colour_scale(spectral_colour(wavelength[i]), reflectance_at(seen, wavelength[i]));
        sum = colour_add(sum, seen);
    }
    return sum;
}

// Light through glass: each way is followed or, while the ray is faint, one of both. In dispersing glass a white ray
// refracts three ways, one for each channel, and each goes on in its own colour.
static Colour glass_surface(Eye *eye, const Hit *hit, Vec3 direction, EyeRay carried)
{
    if (eye->options->play.loop == LOOP_WAVELENGTH && hit->material->disperses)
        return spectral_glass(eye, hit, direction, carried);
    bool splits = hit->material->disperses && carried.colour == WHITE;
    int first = carried.colour == WHITE ? 0 : (int)carried.colour - RED;
    int ways = splits ? 3 : 1;
    Colour reflected = colour_grey(0.0f);
    Colour through[3];
    Vec3 refracted[3];
    for (int i = 0; i < ways; i++) {
        float r, t;
        glass_way(eye, hit, direction, hit->material->index[first + i], &refracted[i], &r, &t);
        reflected = splits ? colour_add(reflected, only_channel(i, r)) : colour_grey(r);
        through[i] = splits ? only_channel(i, t) : colour_grey(t);
    }

    float take_reflected, take_through;
    take_ways(eye, carried.weight, colour_sum(reflected) / 3.0f, &take_reflected, &take_through);
    Vec3 back = mirror_direction(direction, hit->normal);
    Colour sum = follow(eye, hit, back, colour_scale(reflected, take_reflected), carried);
    for (int i = 0; i < ways; i++) {
        EyeRay onward = carried;
        onward.colour = splits ? (PhotonColour)(RED + i) : carried.colour;
        sum = colour_add(sum, follow(eye, hit, refracted[i], colour_scale(through[i], take_through), onward));
    }
    return sum;
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
        return follow(eye, &hit, kind->turn(ray->direction, hit.normal), hit.material->specular, carried);
    case OPTICS_GLASS:
        return glass_surface(eye, &hit, ray->direction, carried);
    }
    return colour_grey(0.0f);
}

Colour eye_radiance(Eye *eye, const Ray *ray)
{
    return trace(eye, ray, (EyeRay){colour_grey(1.0f), WHITE, 0.0f, 0, true, 0.0f});
}
