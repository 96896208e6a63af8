// Where photons begin: which light, where on it, in which direction, of which wavelength.
#include "photons/pass/trace_internal.h"
#include "math/sample.h"
#include "steps/steps.h"

#include <stdlib.h>

LightChance *light_chances(const Scene *scene)
{
    LightChance *chances = calloc(scene->light_count, sizeof *chances);
    if (!chances)
        return NULL;
    double total = 0.0, sum = 0.0;
    for (size_t i = 0; i < scene->light_count; i++)
        total += (double)colour_sum(scene->lights[i].power);
    for (size_t i = 0; i < scene->light_count; i++) {
        double power = (double)colour_sum(scene->lights[i].power);
        sum += power;
        chances[i] = (LightChance){(float)(power / total), (float)(sum / total)};
    }
    return chances;
}

size_t light_pick(const LightChance *chances, size_t count, Rng *rng)
{
    if (count == 1)
        return 0;
    float u = rng_float(rng);
    size_t i = 0;
    while (i + 1 < count && u >= chances[i].up_to)
        i++;
    return i;
}

Photon light_emit(const Light *light, Rng *rng)
{
    if (light->type == LIGHT_RECTANGLE)
        return steps.emit_photon(light, rng);
    float u = rng_float(rng);
    float v = rng_float(rng);
    Vec3 position = light->position, direction = light->direction;
    if (light->type == LIGHT_BEAM) {
        Vec3 spot = sample_disk(u, v);
        position = vec3_along(position, light->edge_u, spot.x * light->radius);
        position = vec3_along(position, light->edge_v, spot.y * light->radius);
    } else if (light->type == LIGHT_SPOT) {
        Frame frame = frame_about(light->direction);
        direction = frame_to_world(&frame, sample_cone(light->cos_cone, u, v));
    } else {
        direction = sample_sphere(u, v); // of a sphere: where on it
    }
    if (light->type == LIGHT_SPHERE) {
        u = rng_float(rng);
        v = rng_float(rng);
        position = vec3_along(position, direction, light->radius);
        direction = sample_cosine(direction, u, v);
    }
    return photon_create(position, direction, light->power);
}

Photon light_emit_at_wavelength(const Light *light, double place, bool hero, Rng *rng)
{
    Light at = *light;
    float wavelength[3];
    for (int c = 0; c < 3; c++) {
        double u = place + c / 3.0;
        float weight = 1.0f;
        wavelength[c] = light->spectrum && light->spectrum->line > 0.0f
                            ? light->spectrum->line
                            : steps.draw_wavelength((float)(floor((u - floor(u)) * 0x1p24) * 0x1p-24), &weight);
        colour_set_channel(&at.power, c, weight * light_power_at(light, wavelength[c]));
    }
    if (!hero)
        at.power = colour_grey(at.power.r);
    if (light->area > 0.0f)
        at.radiance = colour_scale(at.power, 1.0f / (PI * light->area));
    Photon photon = light_emit(&at, rng);
    photon.wavelength = wavelength[0];
    for (int c = 1; hero && c < 3; c++)
        photon.others[c - 1] = wavelength[c];
    return photon;
}
