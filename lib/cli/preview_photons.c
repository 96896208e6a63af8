#include "cli/preview_photons.h"
#include "photons/photon_numbers.h"

#include <stdlib.h>

static void keep_drawable(const PhotonNumbers *photons, size_t count, const Scene *scene, Recording *recording)
{
    for (size_t i = 0; i < count; i++) {
        RecordedPhoton *to = &recording->photons[recording->count];
        float flown = photons[i].flown;
        if (!photon_from_numbers(&photons[i], scene->material_count, &to->at))
            continue;
        to->flown = flown >= 0.0f && flown < 1e6f ? flown : 0.0f;
        recording->count++;
        recording->bounces = to->at.bounce + 1 > recording->bounces ? to->at.bounce + 1 : recording->bounces;
        recording->farthest = fmax(recording->farthest, (double)to->flown);
    }
}

bool preview_photons_read(const char *path, const Scene *scene, Recording *recording, Error *error)
{
    size_t count;
    PhotonNumbersHead head;
    PhotonNumbers *photons = photon_numbers_read(path, &head, &count, error);
    *recording = (Recording){.photons = NULL};
    if (!photons)
        return false;
    recording->emitted = (long)head.emitted;
    recording->photons = malloc((count + 1) * sizeof *recording->photons);
    if (recording->photons)
        keep_drawable(photons, count, scene, recording);
    free(photons);
    return recording->photons || error_set(error, "%s: not enough memory", path);
}
