// The lobe of a scatter step's equation, and the cloud of its samples. A sample's point lies in its direction, as far out
// as the samples are dense there, by the estimate that photon maps make: k nearest over their area. Such an estimate is a mean
// over its disk, too low at the tip and too high beside it; what the equation's own mean is off by is taken out again. So the
// cloud lies on the equation's surface where the step is right, whatever is wrong in it.
#include "preview/view/view_internal.h"

#include <stdlib.h>

float lobe_density(const Lobe *lobe, Vec3 direction)
{
    if (direction.z <= 0.0f)
        return 0.0f;
    if (lobe->diffuse)
        return direction.z / PI;
    float cosine = fminf(vec3_dot(lobe->mirror, direction), 1.0f);
    float height = cosine > 0.0f ? powf(cosine, lobe->exponent) : 0.0f;
    if (lobe->play.glossy == GLOSSY_PHONG)
        return (lobe->exponent + 1.0f) / (2.0f * PI) * height;
    if (cosine <= 0.0f)
        return direction.z / PI;
    float share = 0.5f * (1.0f + lobe->mirror.z); // of diffuse directions that lie on the mirror direction's side
    return share * height / lobe_lookup(lobe->table.above, lobe->mirror.z);
}

Lobe lobe_of(float exponent, float angle, bool diffuse, StepChoice play)
{
    float radians = angle * (PI / 180.0f);
    Lobe lobe = {exponent, vec3(sinf(radians), 0, cosf(radians)), diffuse, play, {{0}, {0}}, 0.0f};
    lobe_table_fill(&lobe.table, exponent);
    lobe.peak = lobe_density(&lobe, lobe.mirror);
    for (int i = 0; i <= 1000; i++) { // along the plane of incidence, where the peak is
        float polar = PI * ((float)i / 1000.0f - 0.5f);
        lobe.peak = fmaxf(lobe.peak, lobe_density(&lobe, vec3(sinf(polar), 0, cosf(polar))));
    }
    return lobe;
}

Vec3 lobe_upright(Vec3 local)
{
    return vec3(local.x, local.z, -local.y);
}

// Part of the disk of radius r about a direction that lies above the surface, where directions can be.
static float part_above(float height, float r)
{
    float t = height / r;
    if (t >= 1.0f || t <= 0.0f)
        return 1.0f;
    return 1.0f - (acosf(t) - t * sqrtf(1.0f - t * t)) / PI;
}

// The samples that have a direction, as photons where it meets the unit sphere; the others are counted and left out. The
// map makes no use of `packed_wi`: it is the number of the sample.
static size_t to_photons(const Findings *samples, LobeCounts *counts, StoredPhoton *photons)
{
    size_t count = 0;
    *counts = (LobeCounts){0, 0, 0};
    const LobeSample *items = samples->items;
    for (size_t i = 0; i < samples->count; i++) {
        Vec3 d = items[i].direction;
        float length = vec3_length(d);
        if (items[i].weight == 0.0f) {
            counts->absorbed++;
            continue;
        }
        bool sound = isfinite(length) && length > 1e-6f;
        counts->not_unit += !sound || fabsf(length - 1.0f) > 1e-3f;
        counts->below += sound && d.z < 0.0f;
        if (sound)
            photons[count++] = (StoredPhoton){.position = vec3_scale(d, 1.0f / length), .packed_wi = (uint32_t)i};
    }
    return count;
}

float lobe_expected(const Lobe *lobe, Vec3 direction, float r, float *share)
{
    enum { PLACES = 64 };
    Frame frame = frame_about(direction);
    float sum = 0.0f;
    for (int i = 0; i < PLACES; i++) {
        float c2 = r * r * ((float)i + 0.5f) / PLACES, phi = 2.39996323f * (float)i; // the golden angle
        float cosine = 1.0f - 0.5f * c2,
              sine = sqrtf(fmaxf(1.0f - cosine * cosine, 0.0f)); // of the angle under a chord
        sum += lobe_density(lobe, frame_to_world(&frame, vec3(sine * cosf(phi), sine * sinf(phi), cosine)));
    }
    *share = sum / PLACES * PI * r * r;
    return sum / PLACES / part_above(direction.z, r);
}

void lobe_cloud(const Lobe *lobe, const Findings *samples, LobeCounts *counts, Vertices *list)
{
    StoredPhoton *photons = malloc((samples->count + 1) * sizeof *photons);
    NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(LOBE_NEAREST)];
    Error error;
    size_t count = photons ? to_photons(samples, counts, photons) : 0;
    PhotonMap *map = photons ? photon_map_build(photons, count, &error) : NULL;
    for (size_t i = 0; map && i < count; i++) {
        const StoredPhoton *photon = &photon_map_photons(map)[i];
        Vec3 direction = photon->position;
        float radius2 = INFINITY;
        if (photon_map_nearest(map, direction, LOBE_NEAREST, &radius2, near) < LOBE_NEAREST)
            continue;
        radius2 = fmaxf(radius2, 1e-10f);
        float share = (float)(LOBE_NEAREST - 1) / (float)samples->count; // without the sample itself
        float radius = sqrtf(radius2), inside, density = share / (PI * radius2 * part_above(direction.z, radius));
        if (direction.z > 0.0f)
            density += lobe_density(lobe, direction) - lobe_expected(lobe, direction, radius, &inside);
        density = fmaxf(density, 1e-4f * lobe->peak);
        float length = vec3_length(((const LobeSample *)samples->items)[photon->packed_wi].direction);
        float far_out = fminf(density / lobe->peak, 2.5f) * length;
        Rgba colour = direction.z < 0.0f ? (Rgba){255, 50, 50, 255} : (Rgba){255, 205, 110, 120};
        vertices_point(list, lobe_upright(vec3_scale(direction, far_out)), colour);
    }
    photon_map_free(map);
}
