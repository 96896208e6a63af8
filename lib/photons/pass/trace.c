#include "photons/pass/trace_internal.h"
#include "scene/material_kind.h"
#include "base/array.h"
#include "math/sample.h"
#include "steps/steps.h"

// What lies between the light and the surface that this photon flies to.
static PhotonPath path_after(const Photon *photon)
{
    const Material *left = photon->left_material;
    if (!left)
        return PATH_DIRECT;
    if (material_is_rough(left))
        return PATH_INDIRECT;
    return photon->path == PATH_DIRECT ? PATH_CAUSTIC : photon->path;
}

// nm, of number c of its power, where that is flux by wavelength.
static float wavelength_of(const Photon *photon, int c)
{
    return c > 0 ? photon->others[c - 1] : photon->wavelength;
}

static int wavelength_count(const Photon *photon)
{
    return photon->others[0] > 0.0f ? 3 : 1;
}

static Colour reflectances_for(const Photon *photon, Colour reflectance)
{
    Colour result = colour_grey(reflectance_at(reflectance, photon->wavelength));
    for (int c = 1; c < wavelength_count(photon); c++)
        colour_set_channel(&result, c, reflectance_at(reflectance, wavelength_of(photon, c)));
    return result;
}

Material photon_surface(const Photon *photon, const Hit *hit)
{
    Material here = *hit->material;
    if (photon->wavelength > 0.0f) {
        here.diffuse = reflectances_for(photon, here.diffuse);
        here.specular = reflectances_for(photon, here.specular);
    }
    return here;
}

// The same without a copy for photons of red, green and blue.
static const Material *surface_of(const Photon *photon, const Hit *hit, Material *room)
{
    if (photon->wavelength <= 0.0f)
        return hit->material;
    *room = photon_surface(photon, hit);
    return room;
}

// Where it disperses, the others of the hero's wavelengths would go other ways. The hero, which is any of the three, counts for
// them.
static void part_wavelengths(Photon *photon)
{
    photon->others[0] = photon->others[1] = 0.0f;
    photon->power = colour_grey(photon->power.r);
}

// Flux by wavelength as a colour. Whoever looks it up multiplies by the surface's red, green and blue reflectances; what the
// surface does to one wavelength is something else, and is put right here, where the wavelength is still known.
static Colour colour_of_flux(const Photon *photon, const Material *material)
{
    Colour reflectance = colour_add(material->diffuse, material->specular);
    if (colour_max(reflectance) <= 0.0f) // black: nobody will see it, but files and views show it
        reflectance = colour_grey(1.0f);
    Colour sent_back = colour_mul(photon->power, reflectances_for(photon, reflectance));
    Colour sum = colour_grey(0.0f);
    int count = wavelength_count(photon);
    for (int c = 0; c < count; c++) {
        Colour hue = steps.wavelength_colour(wavelength_of(photon, c));
        sum = colour_add(sum, colour_scale(hue, colour_channel(sent_back, c) / (float)count));
    }
    for (int c = 0; c < 3; c++) {
        float whole = colour_channel(reflectance, c);
        colour_set_channel(&sum, c, whole > 0.0f ? colour_channel(sum, c) / whole : 0.0f);
    }
    return sum;
}

// At an arrival the ledger expects the albedo's share of the flux to go on; what really does is subtracted at the next
// departure. The difference, summed over the path, is its part of `chance`.
static void book_arrival(PhotonTrace *trace, const Photon *photon, const Hit *hit)
{
    float cos_i = -vec3_dot(photon->direction, hit->normal);
    Material room;
    Colour albedo = material_albedo(surface_of(photon, hit, &room), trace->options->play.glossy, cos_i);
    Colour onward = colour_mul(photon->power, albedo);
    ledger_add_power(trace->ledger.absorbed, colour_sub(photon->power, onward));
    ledger_add_power(trace->path_chance, onward);
}

static void note_unsound(UnsoundPaths *unsound, const Photon *photon)
{
    if (unsound->total++ == 0)
        unsound->length = vec3_length(photon->direction);
    const Material *left = photon->left_material;
    unsound->at[left ? left->type : MATERIAL_LIGHT]++;
}

bool photon_fly(PhotonTrace *trace, Photon *photon, Hit *hit)
{
    if (photon->left_material)
        ledger_add_power(trace->path_chance, colour_scale(photon->power, -1.0f));
    photon->path = path_after(photon);
    bool is_done = trace->options->keep == KEEP_CAUSTIC && photon->path == PATH_INDIRECT; // none will be kept any more
    if (photon->bounce >= trace->options->depth || is_done) {
        ledger_add_power(trace->ledger.cut, photon->power);
        return false;
    }
    if (!(fabsf(vec3_dot(photon->direction, photon->direction) - 1.0f) < 0.01f)) { // NaN is not less
        note_unsound(&trace->unsound, photon);
        ledger_add_power(trace->ledger.escaped, photon->power);
        return false;
    }
    Ray ray = {photon->position, photon->direction, photon->from};
    trace->segments++;
    bool met = scene_intersect(trace->scene, &ray, hit);
    const PhotonRecorder *recorder = trace->options->recorder;
    if (recorder)
        recorder->leg(recorder->user, photon, met ? hit : NULL);
    if (!met) {
        ledger_add_power(trace->ledger.escaped, photon->power);
        return false;
    }
    photon->bounce++;
    photon->flown += hit->distance;
    photon->from = hit->primitive;
    photon->left_material = hit->material;
    book_arrival(trace, photon, hit);
    if (photon->others[0] > 0.0f && hit->material->disperses)
        part_wavelengths(photon);
    return hit->material->type != MATERIAL_LIGHT;
}

void photon_store(PhotonTrace *trace, const Photon *photon, const Hit *hit)
{
    const PhotonRecorder *recorder = trace->options->recorder;
    if (!(trace->options->keep & (1u << photon->path)))
        return;
    int before = photon->bounce - 1;
    bool alone =
        photon->wavelength >= WAVELENGTH_FIRST && photon->wavelength <= WAVELENGTH_LAST && photon->others[0] <= 0.0f;
    StoredPhoton stored = {
        .position = hit->position,
        .power = photon->wavelength > 0.0f ? colour_of_flux(photon, hit->material) : photon->power,
        .packed_wi = direction_pack(vec3_negate(photon->direction)),
        .colour = alone ? band_of_wavelength(photon->wavelength) : (uint8_t)photon->colour,
        .path = (uint8_t)photon->path,
        .bounce = (uint8_t)(before < 255 ? before : 255),
        .material = (uint8_t)(hit->material - trace->scene->materials),
    };
    if (recorder) {
        recorder->stored(recorder->user, &stored, photon->flown);
        return;
    }
    if (!array_reserve(&trace->photons, trace->count + 1, &trace->capacity, sizeof stored)) {
        trace->out_of_memory = true;
        return;
    }
    trace->photons[trace->count++] = stored;
    trace->caustics += photon->path == PATH_CAUSTIC;
}

// A kind that no step is about: turned as by a mirror, or sent into the cosine hemisphere with its BRDF for a weight.
static bool scatter_by_kind(Photon *photon, const Hit *hit, const Material *material, Rng *rng)
{
    Colour share = material->specular;
    if (material_kind(material)->turn) {
        photon->direction = material_kind(material)->turn(photon->direction, hit->normal);
    } else {
        float u = rng_float(rng);
        float v = rng_float(rng);
        Vec3 wi = vec3_negate(photon->direction);
        photon->direction = sample_cosine(hit->normal, u, v);
        share = colour_scale(material_brdf(material, GLOSSY_PHONG, wi, photon->direction, hit->normal), PI);
    }
    return steps.russian_roulette(&photon->power, share, rng);
}

bool photon_scatter_glossy(Photon *photon, const Hit *hit, Rng *rng)
{
    Material room;
    const Material *material = surface_of(photon, hit, &room);
    if (!material_kind(material)->cosine_lobe)
        return scatter_by_kind(photon, hit, material, rng);
    Colour total = colour_add(material->diffuse, material->specular);
    Colour arriving = photon->power;
    if (!steps.russian_roulette(&photon->power, total, rng))
        return false;

    // Of the flux that survived, each part's share; the weights keep the mean right channel by channel.
    float diffuse = colour_sum(colour_mul(arriving, material->diffuse));
    float lobe = colour_sum(colour_mul(arriving, material->specular));
    float lobe_share = lobe / (diffuse + lobe);
    bool take_lobe = rng_float(rng) < lobe_share;
    Colour part = take_lobe ? material->specular : material->diffuse;
    float probability = take_lobe ? lobe_share : 1.0f - lobe_share;
    for (int c = 0; c < 3; c++) {
        float whole = colour_channel(total, c);
        float factor = whole > 0.0f ? colour_channel(part, c) / (whole * probability) : 0.0f;
        colour_set_channel(&photon->power, c, colour_channel(photon->power, c) * factor);
    }

    if (!take_lobe) {
        photon->direction = steps.scatter_diffuse(hit->normal, rng);
        return true;
    }
    float weight;
    Vec3 out;
    if (!steps.scatter_glossy(photon->direction, hit->normal, material->exponent, rng, &out, &weight))
        return false;
    photon->direction = out;
    photon->power = colour_scale(photon->power, weight);
    return true;
}

void photon_scatter_glass(Photon *photon, const Hit *hit, Rng *rng)
{
    float eta = glass_eta(hit, steps.refractive_index(hit->material, WHITE));
    float reflected_share = steps.fresnel(-vec3_dot(photon->direction, hit->normal), eta);
    Vec3 through;
    if (rng_float(rng) >= reflected_share && steps.refract(photon->direction, hit->normal, eta, &through))
        photon->direction = through;
    else
        photon->direction = steps.reflect(photon->direction, hit->normal);
}
