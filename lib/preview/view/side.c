// One side's data and what was made of it.
#include "preview/view/view_internal.h"

#include <stdlib.h>

#define SIDE_CACHES 8

static void list_caches(Side *side, Cache *caches[SIDE_CACHES])
{
    Cache *all[SIDE_CACHES] = {&side->wires, &side->points,      &side->paths,      &side->screen,
                               &side->tree,  &side->tree_points, &side->lobe_lines, &side->lobe_points};
    for (int i = 0; i < SIDE_CACHES; i++)
        caches[i] = all[i];
}

Side *side_create(Canvas *canvas, const Scene *scene)
{
    Side *side = calloc(1, sizeof *side);
    if (!side)
        return NULL;
    side->canvas = canvas;
    side->scene = scene;
    side->screen_surface = -2;
    Cache *caches[SIDE_CACHES];
    list_caches(side, caches);
    for (int i = 0; i < SIDE_CACHES; i++)
        if (!(caches[i]->batch = batch_create(canvas))) {
            side_free(side);
            return NULL;
        }
    return side;
}

void side_free(Side *side)
{
    if (!side)
        return;
    Cache *caches[SIDE_CACHES];
    list_caches(side, caches);
    for (int i = 0; i < SIDE_CACHES; i++)
        batch_free(side->canvas, caches[i]->batch);
    recording_free(&side->recording);
    lobe_samples_free(&side->lobe);
    if (side->map)
        photon_map_free(side->map);
    free(side->flown);
    free(side);
}

static int compare_floats(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return x < y ? -1 : x > y;
}

// The power that nine of ten photons do not exceed: 1/N of all, whatever N is.
static float bright_power(const Recording *recording)
{
    enum { MOST = 4096 };
    float powers[MOST];
    size_t stride = recording->count / MOST + 1, count = 0;
    for (size_t i = 0; i < recording->count && count < MOST; i += stride) {
        float power = colour_max(recording->photons[i].at.power);
        if (power > 0.0f && isfinite(power))
            powers[count++] = power;
    }
    bool none = count == 0; // all have left: of the legs, then
    for (size_t i = 0; none && i < recording->leg_count && count < MOST; i++) {
        float power = colour_max(recording->legs[i].power);
        if (power > 0.0f && isfinite(power))
            powers[count++] = power;
    }
    if (count == 0)
        return 1.0f;
    qsort(powers, count, sizeof *powers, compare_floats);
    float power = powers[count * 9 / 10];
    return power > 0.0f && isfinite(power) ? power : 1.0f;
}

void side_set_recording(Side *side, Recording recording)
{
    recording_free(&side->recording);
    side->recording = recording;
    side->power = bright_power(&recording);
    side->points.valid = side->paths.valid = side->screen.valid = side->tree.valid = side->tree_points.valid = false;
    side->lobe_lines.valid = false; // it may show another of the two glossy steps
    side->screen_surface = -2;
    if (side->map)
        photon_map_free(side->map);
    side->map = NULL;
}

const Recording *side_recording(const Side *side)
{
    return &side->recording;
}

void side_set_lobe(Side *side, LobeSamples samples)
{
    lobe_samples_free(&side->lobe);
    side->lobe = samples;
    side->lobe_points.valid = false;
}
