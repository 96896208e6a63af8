#include "render/gather/gather_trace.h"

#include "math/sample.h"
#include "render/final_gather.h"
#include "scene/material_kind.h"

#define ALBEDO_PHOTONS 20
#define SHARPEST       100.0f // exponent of a lobe that some of the gather rays still meet,
#define CELL           0.12f  // each of which stands for this angle, √(2π/(MN))

static const Material white = {.name = "white", .type = MATERIAL_DIFFUSE, .diffuse = {1.0f, 1.0f, 1.0f}};

// One channel of three stands for all.
Colour gather_send(GatherTrace *trace, Ray ray, Rng *rng)
{
    trace->met = 0;
    trace->distance = INFINITY;
    trace->is_sent = true;
    trace->channel = -1;
    Colour brought = steps.gather_radiance(trace, ray, rng);
    int channel = trace->channel;
    return channel < 0 ? brought : colour_only(channel, 3.0f * colour_channel(brought, channel));
}

// Draws a channel where there is none, and shows glass of its index for all colours.
static void show_channel(GatherTrace *trace, Hit *hit)
{
    if (trace->channel < 0)
        trace->channel = (int)(rng_float(&trace->eye->rng) * 3.0f);
    trace->glass = *hit->material;
    trace->glass.disperses = false;
    for (int c = 0; c < 3; c++)
        trace->glass.index[c] = hit->material->index[trace->channel];
    hit->material = &trace->glass;
}

bool gather_meet(GatherTrace *trace, const Ray *ray, Hit *hit)
{
    bool met = trace->met < trace->eye->options->settings.depth && scene_intersect(trace->eye->scene, ray, hit);
    trace->eye->rays++;
    if (trace->met++ == 0 && met)
        trace->distance = hit->distance;
    if (met && trace->is_sent && hit->material->disperses)
        show_channel(trace, hit);
    return met;
}

float gather_distance(const GatherTrace *trace)
{
    return trace->distance;
}

// Something round, or too sharp, would be bright in single rays of many: it stays matt, and an estimate without blotches.
static bool shows_lobe(const Eye *eye, const Hit *hit)
{
    if (!eye->rest || !material_kind(hit->material)->lobe || hit->primitive >= eye->scene->flat_count)
        return false;
    const Flat *flat = &eye->scene->flats[hit->primitive];
    float wide = fminf(vec3_length(flat->edge_u), vec3_length(flat->edge_v));
    return wide > CELL * hit->distance && hit->material->exponent <= SHARPEST;
}

// What a lobe sends this way hangs on where light comes from. A few photons tell: πf of each, weighed by its flux, which has
// either sign with wavelengths.
static Colour lobe_albedo(const GatherTrace *trace, Vec3 wo, const Hit *hit, Colour albedo)
{
    const Eye *eye = trace->eye;
    Gather gather = eye->gather;
    gather.k = gather.k < ALBEDO_PHOTONS ? gather.k : ALBEDO_PHOTONS;
    float radius;
    size_t found = gather_near(eye->rest, hit->position, &gather, &radius);
    Colour sent = colour_grey(0.0f), arriving = colour_grey(0.0f);
    for (size_t i = 0; i < found; i++) {
        const StoredPhoton *photon = gather.near[i].photon;
        if (&eye->scene->materials[photon->material] != hit->material || !stored_photon_on_side(photon, hit->normal))
            continue;
        Colour flux = {fabsf(photon->power.r), fabsf(photon->power.g), fabsf(photon->power.b)};
        sent = colour_add(sent, colour_mul(flux, gather_brdf(&gather, hit, photon, wo)));
        arriving = colour_add(arriving, flux);
    }
    for (int c = 0; c < 3; c++)
        if (colour_channel(arriving, c) > 0.0f)
            colour_set_channel(&albedo, c, PI * colour_channel(sent, c) / colour_channel(arriving, c));
    return albedo;
}

Colour gather_albedo(const GatherTrace *trace, const Ray *ray, const Hit *hit)
{
    Vec3 wo = vec3_negate(ray->direction);
    Colour albedo = material_albedo(hit->material, trace->eye->options->play.glossy, vec3_dot(wo, hit->normal));
    return shows_lobe(trace->eye, hit) ? lobe_albedo(trace, wo, hit, albedo) : albedo;
}

// Irradiance by lamps, caustics and one more ray, which no look-up blurs.
static Colour gather_again(GatherTrace *trace, const Hit *hit)
{
    Eye *eye = trace->eye;
    Hit on_white = *hit;
    on_white.material = &white;
    eye->sampler.pixel = hash_u64(rng_u32(&eye->rng));
    Colour leaving = colour_add(direct_light(eye, &on_white, hit->normal), caustic_light(eye, &on_white, hit->normal));
    float u = rng_float(&eye->rng);
    float v = rng_float(&eye->rng);
    Ray onward = {hit->position, sample_cosine(hit->normal, u, v), hit->primitive};
    GatherTrace next = {.eye = eye, .is_second = true};
    return colour_scale(colour_add(leaving, gather_send(&next, onward, &eye->rng)), PI);
}

Colour gather_irradiance(GatherTrace *trace, const Hit *hit)
{
    LocalIrradiance local = {colour_grey(0.0f), INFINITY}; // no photon near: as good as none
    irradiance_map_find(trace->eye->final->ends, hit->position, hit->normal, &local);
    // Near a corner the disk of an estimate sticks out over the edge.
    return !trace->is_second && hit->distance < local.radius ? gather_again(trace, hit) : local.irradiance;
}

Colour irradiance_extrapolate(const IrradianceEstimate *estimate, Vec3 position, Vec3 normal)
{
    Vec3 offset = vec3_sub(position, estimate->position);
    Vec3 turn = vec3_cross(estimate->normal, normal);
    Colour result = estimate->irradiance;
    for (int c = 0; c < 3; c++) {
        float at = colour_channel(estimate->irradiance, c);
        float value = at + vec3_dot(turn, estimate->rotation[c]) + vec3_dot(offset, estimate->translation[c]);
        // Without this bound single pixels explode. With wavelengths `at` may be below 0.
        float low = fminf(0.5f * at, 1.6f * at), high = fmaxf(0.5f * at, 1.6f * at);
        colour_set_channel(&result, c, fminf(fmaxf(value, low), high));
    }
    return result;
}
