// Splits by its own hand and knows Snell and Fresnel itself.
#include "photonlab.h"

static float reflectance(float c, float eta)
{
    float k = 1.0f - eta * eta * (1.0f - c * c);
    if (k <= 0.0f)
        return 1.0f;
    float t = sqrtf(k);
    float s = (eta * c - t) / (eta * c + t);
    float p = (c - eta * t) / (c + eta * t);
    return (s * s + p * p) / 2.0f;
}

static void follow_refracted(PhotonTrace *trace, Photon child, const Hit *hit, float eta, Rng *rng)
{
    float c = -vec3_dot(child.direction, hit->normal);
    float k = 1.0f - eta * eta * (1.0f - c * c);
    if (k < 0.0f || colour_sum(child.power) <= 0.0f)
        return;
    Vec3 t = vec3_along(vec3_scale(child.direction, eta), hit->normal, eta * c - sqrtf(k));
    child.direction = vec3_normalize(t);
    trace_photon_in_colour(trace, child, rng);
}

static void meet_glass(PhotonTrace *trace, Photon photon, const Hit *hit, Rng *rng)
{
    float c = -vec3_dot(photon.direction, hit->normal);
    float f[3], eta[3], mean = 0.0f;
    for (int i = 0; i < 3; i++) {
        eta[i] = glass_eta(hit, hit->material->index[photon.colour == WHITE ? i : (int)photon.colour - 1]);
        f[i] = reflectance(c, eta[i]);
        mean += f[i] / 3.0f;
    }
    if (rng_float(rng) < mean) {
        photon.power = colour_scale(colour_mul(photon.power, colour(f[0], f[1], f[2])), 1.0f / mean);
        photon.direction = vec3_along(photon.direction, hit->normal, 2.0f * c);
        trace_photon_in_colour(trace, photon, rng);
        return;
    }
    Colour passed = colour(1.0f - f[0], 1.0f - f[1], 1.0f - f[2]);
    photon.power = colour_scale(colour_mul(photon.power, passed), 1.0f / (1.0f - mean));
    if (photon.colour != WHITE || !hit->material->disperses) {
        follow_refracted(trace, photon, hit, eta[0], rng);
        return;
    }
    for (int i = 0; i < 3; i++) {
        Photon child = photon;
        child.colour = (PhotonColour)(i + 1);
        child.power = colour(i == 0 ? photon.power.r : 0, i == 1 ? photon.power.g : 0, i == 2 ? photon.power.b : 0);
        follow_refracted(trace, child, hit, eta[i], rng);
    }
}

void trace_photon_in_colour(PhotonTrace *trace, Photon photon, Rng *rng)
{
    Hit hit;
    if (!photon_fly(trace, &photon, &hit))
        return;
    const Material *m = hit.material;
    if (material_is_rough(m))
        photon_store(trace, &photon, &hit);
    photon.position = hit.position;
    bool goes_on = false;
    if (m->type == MATERIAL_GLASS)
        meet_glass(trace, photon, &hit, rng);
    else if (m->type == MATERIAL_GLOSSY)
        goes_on = photon_scatter_glossy(&photon, &hit, rng);
    else
        goes_on = steps.russian_roulette(&photon.power, m->type == MATERIAL_DIFFUSE ? m->diffuse : m->specular, rng);
    if (m->type == MATERIAL_DIFFUSE)
        photon.direction = steps.scatter_diffuse(hit.normal, rng);
    if (m->type == MATERIAL_MIRROR)
        photon.direction = steps.reflect(photon.direction, hit.normal);
    if (goes_on)
        trace_photon_in_colour(trace, photon, rng);
}
