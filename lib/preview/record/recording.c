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

void recording_free(Recording *recording)
{
    free(recording->photons);
    free(recording->legs);
    *recording = (Recording){.photons = NULL};
}

void findings_free(Findings *findings)
{
    free(findings->items);
    *findings = (Findings){NULL, 0};
}
