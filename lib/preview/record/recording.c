#include "preview/record/recording.h"
#include "photons/photon_numbers.h"

#include <stdlib.h>
#include <string.h>

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

// The error of a sum: each part's error gives back its sum of squares (see photon_pass.c).
static void add_ledger(Ledger *sum, long sum_paths, const Ledger *part, long paths)
{
    for (int c = 0; c < 3; c++) {
        double before = sum->chance[c], own = part->chance[c];
        double squares = part->chance_error[c] * part->chance_error[c] + own * own / (double)paths;
        squares += sum->chance_error[c] * sum->chance_error[c] + before * before / fmax((double)sum_paths, 1.0);
        sum->emitted[c] += part->emitted[c];
        sum->absorbed[c] += part->absorbed[c];
        sum->escaped[c] += part->escaped[c];
        sum->cut[c] += part->cut[c];
        sum->chance[c] += own;
        double variance = squares - sum->chance[c] * sum->chance[c] / (double)(sum_paths + paths);
        sum->chance_error[c] = sqrt(fmax(0.0, variance));
    }
}

void recording_add_books(Recording *sum, const Recording *part)
{
    if (part->emitted > 0)
        add_ledger(&sum->ledger, sum->emitted, &part->ledger, part->emitted);
    sum->emitted += part->emitted;
    sum->segments += part->segments;
    unsound_paths_add(&sum->unsound, &part->unsound);
    sum->redraw_caps += part->redraw_caps;
    sum->bounces = part->bounces > sum->bounces ? part->bounces : sum->bounces;
    sum->play = part->play;
    memcpy(sum->states, part->states, sizeof sum->states);
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
