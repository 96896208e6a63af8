// Photons as a view has them.
#pragma once

#include "preview/view/view_internal.h"
#include "unit/test_common.h"

static inline Recording recording_of(const Scene *scene, long emitted)
{
    PhotonPass pass = photons_of(scene, emitted, 1, PLAY_DEFAULT);
    Recording recording = {.count = pass.rest.count, .emitted = emitted};
    recording.photons = calloc(pass.rest.count + 1, sizeof *recording.photons);
    assert_non_null(recording.photons);
    for (size_t i = 0; i < recording.count; i++)
        recording.photons[i] = (RecordedPhoton){pass.rest.photons[i], (float)(i * 7919 % 1000) * 0.01f};
    return recording;
}
