#include "preview/record/recording.h"

#include <stdlib.h>

double recording_farthest(const Recording *recording)
{
    float farthest = 0.0f;
    for (size_t i = 0; i < recording->count; i++)
        farthest = fmaxf(farthest, recording->photons[i].flown);
    for (size_t i = 0; i < recording->leg_count; i++) {
        const PathLeg *leg = &recording->legs[i];
        farthest = fmaxf(farthest, leg->flown + vec3_length(vec3_sub(leg->to, leg->from)));
    }
    return (double)farthest;
}

void recording_free(Recording *recording)
{
    free(recording->photons);
    free(recording->legs);
    *recording = (Recording){.photons = NULL};
}

void lobe_samples_free(LobeSamples *samples)
{
    free(samples->items);
    *samples = (LobeSamples){NULL, 0};
}
