#include "judge/checks/glossy_cases.h"

#include <stdio.h>

// Exponent, angle to the normal in degrees, the normal. Blunt to sharp, head-on to grazing, for the histogram, about a
// slanted normal and one that points down; and exponents that are no whole numbers.
static const struct {
    double exponent, degrees;
    Vec3d normal;
} cases[GLOSSY_CASES] = {
    {0, 45, {0, 0, 1}},    {1, 70, {0, 0, 1}},   {5, 30, {1, 0, 0}},   {100, 80, {0, 0, 1}},
    {1000, 60, {0, 1, 0}}, {20, 0, {0, 0, 1}},   {20, 60, {0, 0, 1}},  {50, 85, {0.48, -0.64, 0.6}},
    {10, 50, {0, 0, -1}},  {0.5, 60, {0, 0, 1}}, {2.5, 45, {0, 1, 0}}, {7.3, 70, {0, 0, 1}},
};

GlossyCase glossy_case(int number)
{
    GlossyCase c = {.exponent = cases[number].exponent, .normal = vec3d_rounded(cases[number].normal)};
    Vec3d back = direction_at(cases[number].normal, cases[number].degrees, 30.0 + 50.0 * number);
    c.direction = vec3d_rounded(vec3d(-back.x, -back.y, -back.z));
    c.cos_in = -vec3d_dot(c.direction, c.normal);
    c.mirror = vec3d_unit(mirrored(c.direction, c.normal));
    c.above = lobe_above_exactly(c.exponent, c.cos_in);
    snprintf(c.inputs, sizeof c.inputs, "n = %g and d = %s, %g° to the normal %s", c.exponent, text_of(c.direction),
             cases[number].degrees, text_of(c.normal));
    return c;
}

void plan_glossy(Plan *plan)
{
    for (int i = 0; i < GLOSSY_CASES; i++) {
        GlossyCase c = glossy_case(i);
        double arguments[] = {c.direction.x, c.direction.y, c.direction.z, c.normal.x,
                              c.normal.y,    c.normal.z,    c.exponent};
        plan_call(plan, GLOSSY_SAMPLES, arguments, 7);
    }
}

double glossy_lobe(Vec3d d, const void *input)
{
    const GlossyCase *c = input;
    double cosine = vec3d_dot(d, c->mirror);
    return cosine > 0.0 && vec3d_dot(d, c->normal) > 0.0 ? pow(cosine, c->exponent) : 0.0;
}
