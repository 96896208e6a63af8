#include "photons/photon_numbers.h"
#include "base/file.h"

#include <stdlib.h>
#include <string.h>

#define MAGIC         "photonlab scatter 1\n"
#define MOST_BYTES    (100u << 20)
#define FARTHEST      1e6f // m
#define LARGEST_POWER 1e12f

PhotonNumbers photon_numbers(const StoredPhoton *photon, long emission, float flown)
{
    Vec3 at = photon->position, from = stored_photon_wi(photon);
    return (PhotonNumbers){.position = {at.x, at.y, at.z},
                           .from = {from.x, from.y, from.z},
                           .power = {photon->power.r, photon->power.g, photon->power.b},
                           .colour = (float)(photon->colour < BAND_FIRST ? photon->colour : WHITE),
                           .bounce = (float)photon->bounce,
                           .path = (float)photon->path,
                           .material = (float)photon->material,
                           .emission = (float)emission,
                           .flown = flown};
}

bool photon_number_is_whole(float value, double below)
{
    return value >= 0.0f && (double)value < below && value == floorf(value);
}

bool photon_numbers_are_sound(const PhotonNumbers *n, size_t materials)
{
    return photon_number_is_whole(n->colour, BLUE + 1) && photon_number_is_whole(n->path, PATH_INDIRECT + 1) &&
           photon_number_is_whole(n->bounce, 256) && photon_number_is_whole(n->material, (double)materials);
}

static bool is_small(const float v[3], float limit)
{
    return fabsf(v[0]) <= limit && fabsf(v[1]) <= limit && fabsf(v[2]) <= limit; // false for what is no number
}

bool photon_from_numbers(const PhotonNumbers *n, size_t materials, StoredPhoton *photon)
{
    Vec3 from = vec3(n->from[0], n->from[1], n->from[2]);
    float length = vec3_length(from);
    if (!is_small(n->position, FARTHEST) || !is_small(n->power, LARGEST_POWER) || !(length > 0.9f) ||
        !(length < 1.1f) || !photon_numbers_are_sound(n, materials))
        return false;
    *photon = (StoredPhoton){.position = vec3(n->position[0], n->position[1], n->position[2]),
                             .power = colour(n->power[0], n->power[1], n->power[2]),
                             .packed_wi = direction_pack(from),
                             .colour = (uint8_t)n->colour,
                             .path = (uint8_t)n->path,
                             .bounce = (uint8_t)n->bounce,
                             .material = (uint8_t)n->material};
    return true;
}

bool photon_numbers_write(const char *path, const PhotonNumbersHead *head, const PhotonNumbers *photons, size_t count,
                          Error *error)
{
    FileWriter writer;
    if (!file_write_begin(&writer, path, error))
        return false;
    fputs(MAGIC, writer.stream);
    bool ok = fwrite(head, sizeof *head, 1, writer.stream) == 1 &&
              fwrite(photons, sizeof *photons, count, writer.stream) == count;
    return file_write_end(&writer, ok, error) && ok;
}

PhotonNumbers *photon_numbers_read(const char *path, PhotonNumbersHead *head, size_t *count, Error *error)
{
    size_t size, start = strlen(MAGIC) + sizeof *head;
    *count = 0;
    char *bytes = file_read(path, MOST_BYTES, &size, error);
    if (!bytes)
        return NULL;
    bool whole =
        size >= start && memcmp(bytes, MAGIC, strlen(MAGIC)) == 0 && (size - start) % sizeof(PhotonNumbers) == 0;
    if (whole)
        memcpy(head, bytes + strlen(MAGIC), sizeof *head);
    if (!whole || !photon_number_is_whole(head->emitted, 1e8) || head->emitted < 1.0f) {
        free(bytes);
        error_set(error, "%s: is no file of photons", path);
        return NULL;
    }
    *count = (size - start) / sizeof(PhotonNumbers);
    return memmove(bytes, bytes + start, size - start); // to where malloc has aligned it
}
