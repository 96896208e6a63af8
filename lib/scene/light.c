#include "scene/light.h"
#include "math/sample.h"

static bool sample_rectangle(const Light *light, Vec3 point, float u, float v, LightSample *sample)
{
    Vec3 spot = vec3_along(vec3_along(light->position, light->edge_u, u), light->edge_v, v);
    Vec3 to_light = vec3_sub(spot, point);
    float distance2 = vec3_dot(to_light, to_light);
    float cos_times_distance = -vec3_dot(to_light, light->direction);
    if (cos_times_distance <= 0.0f)
        return false;
    sample->distance = sqrtf(distance2);
    sample->wi = vec3_scale(to_light, 1.0f / sample->distance);
    sample->geometry = cos_times_distance / sample->distance * light->area / distance2;
    return true;
}

// Uniform in the cone of directions that the sphere fills: no sample is wasted on its far side.
static bool sample_sphere_light(const Light *light, Vec3 point, float u, float v, LightSample *sample)
{
    Vec3 to_centre = vec3_sub(light->position, point);
    float distance2 = vec3_dot(to_centre, to_centre);
    float radius2 = light->radius * light->radius;
    if (distance2 <= radius2)
        return false;
    float sin2_max = radius2 / distance2;
    float cos_max = sqrtf(1.0f - sin2_max);
    float one_minus_cos = sin2_max / (1.0f + cos_max); // no cancellation for a small, far sphere
    float z = 1.0f - u * one_minus_cos;
    float sin2 = fmaxf(0.0f, u * one_minus_cos * (2.0f - u * one_minus_cos));
    float r = sqrtf(sin2);
    float phi = 2.0f * PI * v;
    Frame frame = frame_about(vec3_scale(to_centre, 1.0f / sqrtf(distance2)));
    sample->wi = frame_to_world(&frame, vec3(r * cosf(phi), r * sinf(phi), z));
    sample->distance = sqrtf(distance2) * z - sqrtf(fmaxf(0.0f, radius2 - distance2 * sin2));
    sample->geometry = 2.0f * PI * one_minus_cos;
    return true;
}

static bool sample_point(const Light *light, Vec3 point, LightSample *sample)
{
    Vec3 to_light = vec3_sub(light->position, point);
    float distance2 = vec3_dot(to_light, to_light);
    if (distance2 <= 0.0f)
        return false;
    sample->distance = sqrtf(distance2);
    sample->wi = vec3_scale(to_light, 1.0f / sample->distance);
    float solid_angle = 4.0f * PI;
    if (light->type == LIGHT_SPOT) {
        if (-vec3_dot(sample->wi, light->direction) < light->cos_cone)
            return false;
        solid_angle = 2.0f * PI * (1.0f - light->cos_cone);
    }
    sample->geometry = 1.0f / (solid_angle * distance2);
    return true;
}

static bool sample_beam(const Light *light, Vec3 point, LightSample *sample)
{
    Vec3 from_centre = vec3_sub(point, light->position);
    float along = vec3_dot(from_centre, light->direction);
    Vec3 off_axis = vec3_along(from_centre, light->direction, -along);
    float radius2 = light->radius * light->radius;
    if (along <= 0.0f || vec3_dot(off_axis, off_axis) > radius2)
        return false;
    sample->distance = along;
    sample->wi = vec3_negate(light->direction);
    sample->geometry = 1.0f / (PI * radius2);
    return true;
}

bool light_sample(const Light *light, Vec3 point, float u, float v, LightSample *sample)
{
    bool has_surface = light->type == LIGHT_RECTANGLE || light->type == LIGHT_SPHERE;
    bool arrives = light->type == LIGHT_RECTANGLE ? sample_rectangle(light, point, u, v, sample)
                   : light->type == LIGHT_SPHERE  ? sample_sphere_light(light, point, u, v, sample)
                   : light->type == LIGHT_BEAM    ? sample_beam(light, point, sample)
                                                  : sample_point(light, point, sample);
    if (arrives)
        sample->arriving = colour_scale(has_surface ? light->radiance : light->power, sample->geometry);
    return arrives;
}

float light_power_at(const Light *light, float wavelength)
{
    return spectrum_at(light->spectrum, wavelength) * reflectance_at(light->given_power, wavelength);
}

Colour light_reflected(const Light *light, Colour brdf, float geometry)
{
    Colour sum = colour_grey(0.0f);
    for (int c = 0; c < 3; c++)
        sum = colour_add(sum, colour_scale(light->behind[c], colour_channel(brdf, c) * geometry));
    return sum;
}
