#include "cli/preview_photons.h"
#include "judge/probe/probe_scatter.h"
#include "base/file.h"

#include <stdlib.h>
#include <string.h>

#define MOST_BYTES    (100u << 20)
#define FARTHEST      1e6f // m
#define LARGEST_POWER 1e12f

static bool is_small(const float *v, float limit)
{
    return fabsf(v[0]) <= limit && fabsf(v[1]) <= limit && fabsf(v[2]) <= limit; // false for what is no number
}

static bool is_whole(float value, size_t below)
{
    return value >= 0.0f && value < (float)below && value == floorf(value);
}

static Vec3 vec3_at(const float *v)
{
    return vec3(v[0], v[1], v[2]);
}

static bool take(const float *from, const Scene *scene, RecordedPhoton *to)
{
    const float *power = from + SCATTER_POWER;
    float length = vec3_length(vec3_at(from + SCATTER_FROM));
    if (!is_small(from + SCATTER_POSITION, FARTHEST) || !is_small(power, LARGEST_POWER) || !(length > 0.9f) ||
        !(length < 1.1f) || !is_whole(from[SCATTER_COLOUR], 4) || !is_whole(from[SCATTER_PATH], 3) ||
        !is_whole(from[SCATTER_BOUNCE], 256) || !is_whole(from[SCATTER_MATERIAL], scene->material_count))
        return false;
    to->at = (StoredPhoton){.position = vec3_at(from + SCATTER_POSITION),
                            .power = colour(power[0], power[1], power[2]),
                            .packed_wi = direction_pack(vec3_at(from + SCATTER_FROM)),
                            .colour = (uint8_t)from[SCATTER_COLOUR],
                            .path = (uint8_t)from[SCATTER_PATH],
                            .bounce = (uint8_t)from[SCATTER_BOUNCE],
                            .material = (uint8_t)from[SCATTER_MATERIAL]};
    to->flown = from[SCATTER_FLOWN] >= 0.0f && from[SCATTER_FLOWN] < FARTHEST ? from[SCATTER_FLOWN] : 0.0f;
    return true;
}

static bool take_all(const float *numbers, size_t count, const Scene *scene, Recording *recording)
{
    recording->photons = malloc((count + 1) * sizeof *recording->photons);
    if (!recording->photons)
        return false;
    for (size_t i = 0; i < count; i++) {
        RecordedPhoton *to = &recording->photons[recording->count];
        if (!take(numbers + SCATTER_HEAD + i * SCATTER_NUMBERS, scene, to))
            continue;
        recording->count++;
        recording->bounces = to->at.bounce + 1 > recording->bounces ? to->at.bounce + 1 : recording->bounces;
    }
    recording->farthest = recording_farthest(recording);
    return true;
}

bool preview_photons_read(const char *path, const Scene *scene, Recording *recording, Error *error)
{
    *recording = (Recording){.photons = NULL};
    size_t size, magic = strlen(SCATTER_MAGIC), head = SCATTER_HEAD * sizeof(float);
    char *bytes = file_read(path, MOST_BYTES, &size, error);
    if (!bytes)
        return false;
    size_t each = SCATTER_NUMBERS * sizeof(float);
    bool whole = size >= magic + head && memcmp(bytes, SCATTER_MAGIC, magic) == 0 && (size - magic - head) % each == 0;
    float *numbers = whole ? malloc(size - magic) : NULL;
    if (whole && numbers) {
        memcpy(numbers, bytes + magic, size - magic);
        float emitted = numbers[SCATTER_EMITTED];
        whole = is_whole(emitted, 100000000) && emitted >= 1.0f;
        recording->emitted = whole ? (long)emitted : 1;
    }
    free(bytes);
    bool ok = true;
    if (!whole)
        ok = error_set(error, "%s: is no file of photons", path);
    else if (!numbers || !take_all(numbers, (size - magic - head) / each, scene, recording))
        ok = error_set(error, "%s: not enough memory", path);
    free(numbers);
    return ok;
}
