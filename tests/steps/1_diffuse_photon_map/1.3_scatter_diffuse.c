// Step 1.3: density cosθ/π about the normal.
#include "judge/checks/directions.h"

// Up, down, along the axes, slanted, and near the poles, where a frame may break.
static const Vec3d normals[] = {
    {0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {0.48, -0.64, 0.6}, {0.02, 0, 0.9998}, {0.012, 0.016, -0.9998},
};
#define NORMALS  (int)(sizeof normals / sizeof *normals)
#define SAMPLES  12000
#define ANYWHERE 60
#define A_FEW    50

static Vec3d normal_of(int i, uint64_t seed)
{
    return i < NORMALS ? vec3d_rounded(vec3d_unit(normals[i])) : any_direction(seed + (uint64_t)i);
}

static const char *inputs_of(Vec3d normal)
{
    return words("n = %s", text_of(normal));
}

static void plan_normal(Plan *plan, int i, long samples)
{
    Vec3d n = normal_of(i, plan->seed);
    plan_call(plan, samples, (double[]){n.x, n.y, n.z}, 3);
}

static void plan_density(Plan *plan)
{
    for (int i = 0; i < NORMALS; i++)
        plan_normal(plan, i, SAMPLES);
}

static void judge_density(const Results *results, Finding *finding)
{
    for (int i = 0; i < NORMALS; i++) {
        Vec3d normal = vec3d_unit(normal_of(i, results->seed));
        const char *inputs = inputs_of(normal);
        DirectionCount count;
        directions_begin(&count, &(DirectionDensity){normal, 2.0, lambert, &normal});
        const float *d = numbers_of(results, (size_t)i, 3 * SAMPLES, finding);
        for (long s = 0; d && s < SAMPLES; s++, d += 3)
            if (direction_is_above(d, normal, inputs, i, finding))
                directions_add(&count, d);
        finding_p(
            finding, directions_p(&count), i,
            "expected directions of density cosθ/π; for %s the mean of cosθ should be %.4f, found %.4f, and the mean "
            "across the normal (0, 0), found (%.4f, %.4f)",
            inputs, count.expected.along, sums_mean(&count.along), sums_mean(&count.across), sums_mean(&count.up));
        directions_features(&count, finding);
        if (i == 4)
            directions_histogram(&count, "cosθ of diffuse directions, n = (0.48, -0.64, 0.6)", finding);
    }
}

static void plan_azimuth(Plan *plan)
{
    plan_normal(plan, 0, FINE_SAMPLES);
}

static void judge_azimuth(const Results *results, Finding *finding)
{
    judge_fine(results, "the normal", inputs_of(normal_of(0, results->seed)), finding);
}

static void plan_anywhere(Plan *plan)
{
    for (int i = 0; i < ANYWHERE; i++)
        plan_normal(plan, NORMALS + i, A_FEW);
}

static void judge_anywhere(const Results *results, Finding *finding)
{
    Sums below = {0, 0, 0}, length = {0, 0, 0};
    for (int i = 0; i < ANYWHERE; i++) {
        Vec3d normal = normal_of(NORMALS + i, results->seed);
        const char *inputs = inputs_of(normal);
        const float *d = numbers_of(results, (size_t)i, 3 * A_FEW, finding);
        for (long s = 0; d && s < A_FEW; s++, d += 3) {
            direction_is_above(d, normal, inputs, i, finding);
            sums_add(&below, vec3d_dot(vec3d_of(d), normal) < -1e-4);
            sums_add(&length, vec3d_length(vec3d_of(d)));
        }
    }
    mean_feature(&below, 0.0, finding);
    mean_feature(&length, 1.0, finding);
}

DEFINE_CHECKS(scatter_diffuse, {"density", "Directions follow cosθ/π", CHECK_SAMPLES, plan_density, judge_density},
              {"azimuth", "Directions spread evenly all around the normal", CHECK_SAMPLES, plan_azimuth, judge_azimuth},
              {"anywhere", "Directions are unit vectors above the surface, for every normal", CHECK_INVARIANT,
               plan_anywhere, judge_anywhere},
              PICTURE(1))
