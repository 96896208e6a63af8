#include "preview/record/recording.h"
#include "photons/photon_numbers.h"

#include <stdlib.h>

void recording_measure(Recording *recording)
{
    float farthest = 0.0f;
    for (size_t i = 0; i < recording->count; i++) {
        int bounces = recording->photons[i].at.bounce + 1;
        recording->bounces = bounces > recording->bounces ? bounces : recording->bounces;
        farthest = fmaxf(farthest, recording->photons[i].flown);
    }
    for (size_t i = 0; i < recording->leg_count; i++)
        farthest = fmaxf(farthest, recording->legs[i].flown + leg_length(&recording->legs[i]));
    recording->farthest = (double)farthest;
}

bool recording_read(const char *path, const Scene *scene, Recording *recording, Error *error)
{
    size_t count;
    PhotonNumbersHead head;
    PhotonNumbers *photons = photon_numbers_read(path, &head, &count, error);
    *recording = (Recording){.photons = NULL};
    if (!photons)
        return false;
    recording->emitted = (long)head.emitted;
    recording->photons = malloc((count + 1) * sizeof *recording->photons);
    for (size_t i = 0; recording->photons && i < count; i++) {
        RecordedPhoton *to = &recording->photons[recording->count];
        float flown = photons[i].flown;
        to->flown = flown >= 0.0f && flown < 1e6f ? flown : 0.0f;
        recording->count += photon_from_numbers(&photons[i], scene->material_count, &to->at);
    }
    recording_measure(recording);
    free(photons);
    return recording->photons || error_set(error, "%s: not enough memory", path);
}

float recording_reach(const Scene *scene)
{
    float across = box_diagonal(bvh_bounds(scene->bvh));
    return across > 0.0f && across < 1e30f ? 0.5f * across : 1.0f;
}

PathLeg path_leg(const Photon *photon, const Hit *hit, long path, float reach)
{
    float wave = photon->wavelength; // photons that are looked at have but one
    bool light = hit && hit->material->type == MATERIAL_LIGHT;
    return (PathLeg){
        .from = photon->position,
        .to = hit ? hit->position : vec3_along(photon->position, photon->direction, reach),
        .power = wave > 0.0f ? colour_scale(spectral_colour(wave), photon->power.r) : photon->power,
        .flown = photon->flown,
        .path = (uint32_t)path,
        .bounce = (uint16_t)(photon->bounce < 65535 ? photon->bounce : 65535),
        .colour = wave > 0.0f ? band_of_wavelength(wave) : (uint8_t)photon->colour,
        .end = (uint8_t)(!hit    ? LEG_ESCAPED
                         : light ? LEG_LIGHT
                                 : LEG_SURFACE),
    };
}

void recording_free(Recording *recording)
{
    free(recording->photons);
    free(recording->legs);
    *recording = (Recording){.photons = NULL};
}

LobeSample lobe_sample(float exponent, float degrees, bool diffuse, uint64_t seed, long i)
{
    float angle = degrees * PI / 180.0f;
    Vec3 normal = vec3(0.0f, 0.0f, 1.0f), incoming = vec3(sinf(angle), 0.0f, -cosf(angle));
    Rng rng = rng_create(seed, (uint64_t)i);
    LobeSample sample = {{0.0f, 0.0f, 0.0f}, 1.0f};
    if (diffuse)
        sample.direction = steps.scatter_diffuse(normal, &rng);
    else if (!steps.scatter_glossy(incoming, normal, exponent, &rng, &sample.direction, &sample.weight))
        sample.weight = 0.0f;
    return sample;
}

void findings_free(Findings *findings)
{
    free(findings->items);
    *findings = (Findings){NULL, 0};
}
