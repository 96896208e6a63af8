// Step 2.2: from about +z to about an axis.
#include "judge/checks/directions.h"

// Both poles, the other axes, slanted, and near the poles, where a cross product with z loses its length.
static const Vec3d axes[] = {
    {0, 0, 1},    {0, 0, -1},         {1, 0, 0},          {-1, 0, 0},     {0, 1, 0},
    {0, -1, 0},   {0.48, -0.64, 0.6}, {-0.6, 0, -0.8},    {0.1, 0.02, 1}, {0.02, 0.1, -1},
    {0.01, 0, 1}, {0, 0.01, 1},       {0.008, 0.006, -1}, {-0.01, 0, -1},
};
#define AXES     (int)(sizeof axes / sizeof *axes)
#define ANYWHERE 30

// What is turned: the axes of the frame, then some between, in front and behind.
static const Vec3d locals[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6, 0, 0.8}, {0, -0.8, 0.6}, {0.48, 0.6, -0.64}};
#define LOCALS (int)(sizeof locals / sizeof *locals)

static Vec3d axis_of(int i, uint64_t seed)
{
    return i < AXES ? vec3d_rounded(vec3d_unit(axes[i])) : any_direction(seed + (uint64_t)i);
}

static const char *inputs_of(Vec3d local, Vec3d axis)
{
    return words("local = %s, axis = %s", text_of(local), text_of(axis));
}

static void plan_turn(Plan *plan, Vec3d local, Vec3d axis)
{
    plan_call(plan, 1, (double[]){local.x, local.y, local.z, axis.x, axis.y, axis.z}, 6);
}

static void plan_pole(Plan *plan)
{
    for (int i = 0; i < AXES; i++)
        plan_turn(plan, vec3d(0, 0, 1), axis_of(i, plan->seed));
}

static void judge_pole(const Results *results, Finding *finding)
{
    for (int i = 0; i < AXES; i++) {
        Vec3d axis = axis_of(i, results->seed);
        const float *found = numbers_of(results, (size_t)i, 3, finding);
        if (found)
            vector_is(found, axis, 2e-3, inputs_of(vec3d(0, 0, 1), axis), i, finding);
        vector_features(found, axis, finding);
    }
}

static void plan_angles(Plan *plan)
{
    for (int i = 0; i < AXES + ANYWHERE; i++)
        for (int j = 0; j < LOCALS; j++)
            plan_turn(plan, vec3d_rounded(locals[j]), axis_of(i, plan->seed));
}

// Lengths and angles between any two stay. Known formulas for a frame lose digits near −z: 1 % there.
static void judge_axis(const Results *results, int i, double *length_off, double *angle_off, Finding *finding)
{
    Vec3d axis = axis_of(i, results->seed);
    double tolerance = axis.z < -0.99 ? 1e-2 : 1e-3;
    for (int j = 0; j < LOCALS; j++) {
        long number = (long)i * LOCALS + j;
        const float *found = numbers_of(results, (size_t)number, 3, finding);
        if (!found || !all_finite(found, 3, "a direction", inputs_of(locals[j], axis), number, finding)) {
            *length_off = *angle_off = (double)NAN;
            continue;
        }
        double length = vec3d_length(vec3d_of(found));
        *length_off += fabs(length - 1.0);
        if (fabs(length - 1.0) > tolerance)
            finding_fail(finding, number, "for %s: expected a direction of length 1, found %s of length %.4f",
                         inputs_of(locals[j], axis), text_of_floats(found), length);
        for (int k = 0; k < j; k++) {
            const float *other = numbers_of(results, (size_t)(i * LOCALS + k), 3, finding);
            double expected = vec3d_dot(locals[j], locals[k]);
            double cosine = other ? vec3d_dot(vec3d_of(found), vec3d_of(other)) : (double)NAN;
            *angle_off += fabs(cosine - expected);
            if (!(fabs(cosine - expected) <= tolerance))
                finding_fail(finding, number,
                             "for axis = %s: expected the cosine between the turned %s and %s to stay %.3f, found %.3f",
                             text_of(axis), text_of(locals[k]), text_of(locals[j]), expected, cosine);
        }
    }
}

static void judge_angles(const Results *results, Finding *finding)
{
    double length_off = 0.0, angle_off = 0.0, polar_length = 0.0, polar_angle = 0.0;
    for (int i = 0; i < AXES + ANYWHERE; i++) {
        bool pole = fabs(axis_of(i, results->seed).z) > 0.99;
        judge_axis(results, i, pole ? &polar_length : &length_off, pole ? &polar_angle : &angle_off, finding);
    }
    finding_feature(finding, length_off / (AXES + ANYWHERE), 0.0);
    finding_feature(finding, angle_off / (AXES + ANYWHERE), 0.0);
    finding_feature(finding, polar_length / AXES, 0.0);
    finding_feature(finding, polar_angle / AXES, 0.0);
}

// The angle to the axis is the angle to +z: what the lobe needs.
static void judge_tilt(const Results *results, Finding *finding)
{
    for (int j = 0; j < LOCALS; j++) {
        double off = 0.0;
        for (int i = 0; i < AXES + ANYWHERE; i++) {
            long number = (long)i * LOCALS + j;
            Vec3d axis = axis_of(i, results->seed);
            const float *found = numbers_of(results, (size_t)number, 3, finding);
            double cosine = found ? vec3d_dot(vec3d_of(found), axis) : (double)NAN;
            off += (cosine - locals[j].z) / (AXES + ANYWHERE);
            if (!(fabs(cosine - locals[j].z) <= (axis.z < -0.99 ? 1e-2 : 2e-3)))
                finding_fail(finding, number,
                             "for %s: expected the cosine with the axis to be %.3f, as with +z before, found %.3f",
                             inputs_of(locals[j], axis), locals[j].z, cosine);
        }
        finding_feature(finding, off, 0.0);
    }
}

DEFINE_CHECKS(turn_to, {"pole", "+z goes to the axis", CHECK_VALUES, plan_pole, judge_pole},
              {"angles", "Lengths and angles stay", CHECK_INVARIANT, plan_angles, judge_angles},
              {"tilt", "The angle to +z becomes the angle to the axis", CHECK_INVARIANT, plan_angles, judge_tilt},
              PICTURE(2_phong))
