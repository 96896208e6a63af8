// Vectors in double, words for them, and what a direction must be.
#include "judge/checks/directions.h"

#include <stdio.h>

static const double pi = 3.14159265358979323846;

Vec3d vec3d_unit(Vec3d a)
{
    double length = vec3d_length(a);
    return vec3d(a.x / length, a.y / length, a.z / length);
}

Vec3d vec3d_rounded(Vec3d a)
{
    return vec3d((double)(float)a.x, (double)(float)a.y, (double)(float)a.z);
}

void vec3d_frame(Vec3d axis, Vec3d *tangent, Vec3d *bitangent)
{
    Vec3d helper = fabs(axis.z) < 0.7 ? vec3d(0, 0, 1) : vec3d(1, 0, 0);
    *tangent = vec3d_unit(vec3d_cross(helper, axis));
    *bitangent = vec3d_cross(axis, *tangent);
}

Vec3d vec3d_about(Vec3d axis, Vec3d tangent, Vec3d bitangent, double cosine, double azimuth)
{
    double sine = sqrt(fmax(0.0, 1.0 - cosine * cosine));
    Vec3d v = vec3d_along(vec3d(0, 0, 0), axis, cosine);
    return vec3d_along(vec3d_along(v, tangent, sine * cos(azimuth)), bitangent, sine * sin(azimuth));
}

Vec3d direction_at(Vec3d axis, double degrees, double azimuth)
{
    Vec3d tangent, bitangent;
    vec3d_frame(axis, &tangent, &bitangent);
    return vec3d_about(axis, tangent, bitangent, cos(degrees * pi / 180.0), azimuth * pi / 180.0);
}

Vec3d mirrored(Vec3d d, Vec3d n)
{
    return vec3d_along(d, n, -2.0 * vec3d_dot(d, n));
}

const float *numbers_of(const Results *results, size_t number, size_t floats, Finding *finding)
{
    if (number < results->count && results->cases[number].values && results->cases[number].count == floats)
        return results->cases[number].values;
    finding_fail(finding, (long)number, "expected %lu numbers from the step; found %lu", (unsigned long)floats,
                 number < results->count ? (unsigned long)results->cases[number].count : 0ul);
    return NULL;
}

bool all_finite(const float *values, int count, const char *what, const char *inputs, long number, Finding *finding)
{
    for (int i = 0; i < count; i++) {
        if (!isfinite(values[i])) {
            finding_fail(finding, number, "expected %s made of finite numbers; found %g in it, for %s", what,
                         fabs((double)values[i]), inputs); // "nan" may come as "-nan"
            return false;
        }
    }
    return true;
}

bool direction_is_sound(const float *d, const char *inputs, long number, Finding *finding)
{
    if (!all_finite(d, 3, "a direction", inputs, number, finding))
        return false;
    double length = vec3d_length(vec3d_of(d));
    if (fabs(length - 1.0) > 1e-3)
        finding_fail(finding, number, "expected a direction of length 1; found %s of length %.4g, for %s",
                     text_of_floats(d), length, inputs);
    return length > 1e-6; // it can be counted, whatever its length
}

bool direction_is_above(const float *d, Vec3d normal, const char *inputs, long number, Finding *finding)
{
    if (!direction_is_sound(d, inputs, number, finding))
        return false;
    double cosine = vec3d_dot(vec3d_of(d), normal);
    if (cosine < -1e-4)
        finding_fail(finding, number,
                     "expected directions above the surface; found %s, whose cosine with the normal is "
                     "%.4f, for %s",
                     text_of_floats(d), cosine, inputs);
    return true;
}

bool vector_is(const float *found, Vec3d expected, double tolerance, const char *inputs, long number, Finding *finding)
{
    double off = vec3d_length(vec3d_along(vec3d_of(found), expected, -1.0));
    finding_ratios(finding, found, (const double[]){expected.x, expected.y, expected.z}, 3);
    if (off <= tolerance)
        return true;
    finding_fail(finding, number, "for %s: expected %s, found %s", inputs, text_of(expected), text_of_floats(found));
    return false;
}

Vec3d any_direction(uint64_t number)
{
    double z = 2.0 * ((double)(hash_u64(2 * number) >> 11) / 9007199254740992.0) - 1.0;
    double azimuth = 360.0 * ((double)(hash_u64(2 * number + 1) >> 11) / 9007199254740992.0);
    return vec3d_rounded(direction_at(vec3d(0, 0, 1), acos(z) * 180.0 / pi, azimuth));
}

const char *text_of_power(Vec3d v)
{
    static __thread char texts[8][64];
    static __thread int next;
    char *text = texts[next++ % 8];
    snprintf(text, sizeof texts[0], "(%.4g, %.4g, %.4g)", v.x, v.y, v.z);
    return text;
}

// Nobody wants to read -8.7e-09 in a direction, or -nan.
static double tidied(double component)
{
    return isnan(component) ? (double)NAN : fabs(component) < 5e-7 ? 0.0 : component;
}

const char *text_of(Vec3d v)
{
    return text_of_power(vec3d(tidied(v.x), tidied(v.y), tidied(v.z)));
}

const char *text_of_floats(const float *v)
{
    return text_of(vec3d_of(v));
}
