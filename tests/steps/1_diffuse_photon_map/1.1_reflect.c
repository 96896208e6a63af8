// Step 1.1: r = d − 2(d·n)n.
#include "judge/checks/directions.h"

typedef struct {
    Vec3d direction, normal;
} Mirror;

// Head-on, slanted, the normal on the other side, walls that face along x and y, a slanted wall, nearly grazing.
static const Mirror table[] = {
    {{0.6, 0, -0.8}, {0, 0, 1}},
    {{0, 0, -1}, {0, 0, 1}},
    {{0.6, 0, -0.8}, {0, 0, -1}},
    {{0.8, -0.6, 0}, {-1, 0, 0}},
    {{0.48, -0.64, 0.6}, {0, 1, 0}},
    {{0, 0, -1}, {0.6, 0, 0.8}},
    {{2.0 / 3, -1.0 / 3, -2.0 / 3}, {-1.0 / 3, 2.0 / 3, 2.0 / 3}},
    {{0.99998, 0, -0.00632452}, {0, 0, 1}},
};
#define TABLE    (int)(sizeof table / sizeof *table)
#define ANYWHERE 40

// Beyond the table, others with every salt: nobody can learn them by heart.
static Mirror mirror_of(int i, uint64_t seed)
{
    if (i < TABLE)
        return (Mirror){vec3d_rounded(table[i].direction), vec3d_rounded(table[i].normal)};
    return (Mirror){any_direction(seed + (uint64_t)i), any_direction(seed + 1000 + (uint64_t)i)};
}

static void plan_mirror(Plan *plan, int i)
{
    Mirror m = mirror_of(i, plan->seed);
    double arguments[] = {m.direction.x, m.direction.y, m.direction.z, m.normal.x, m.normal.y, m.normal.z};
    plan_call(plan, 1, arguments, 6);
}

static const char *inputs_of(Mirror m)
{
    return words("d = %s, n = %s", text_of(m.direction), text_of(m.normal));
}

static void plan_table(Plan *plan)
{
    for (int i = 0; i < TABLE; i++)
        plan_mirror(plan, i);
}

static void judge_table(const Results *results, Finding *finding)
{
    for (int i = 0; i < TABLE; i++) {
        Mirror m = mirror_of(i, results->seed);
        Vec3d expected = mirrored(m.direction, m.normal);
        const float *found = numbers_of(results, (size_t)i, 3, finding);
        if (found)
            vector_is(found, expected, 1e-4, inputs_of(m), i, finding);
        vector_features(found, expected, finding);
    }
}

static void plan_anywhere(Plan *plan)
{
    for (int i = 0; i < ANYWHERE; i++)
        plan_mirror(plan, TABLE + i);
}

// The length stays, the part along the normal turns round, the part in the surface stays.
static void judge_anywhere(const Results *results, Finding *finding)
{
    double length = 0.0, along = 0.0, beside = 0.0;
    for (int i = 0; i < ANYWHERE; i++) {
        Mirror m = mirror_of(TABLE + i, results->seed);
        const float *found = numbers_of(results, (size_t)i, 3, finding);
        if (!found || !all_finite(found, 3, "a direction", inputs_of(m), i, finding)) {
            length = along = beside = (double)NAN;
            continue;
        }
        Vec3d r = vec3d_of(found);
        double before = vec3d_dot(m.direction, m.normal), after = vec3d_dot(r, m.normal);
        Vec3d kept = vec3d_along(m.direction, m.normal, -before);
        double sideways = vec3d_length(vec3d_along(vec3d_along(r, m.normal, -after), kept, -1.0));
        length += (vec3d_length(r) - 1.0) / ANYWHERE;
        along += fabs(after + before) / ANYWHERE;
        beside += sideways / ANYWHERE;
        if (fabs(vec3d_length(r) - 1.0) > 1e-4)
            finding_fail(finding, i, "for %s: expected the length to stay 1, found %.4f", inputs_of(m),
                         vec3d_length(r));
        else if (fabs(after + before) > 1e-4)
            finding_fail(finding, i, "for %s: expected d·n = %.4f to become r·n = %.4f, found %.4f", inputs_of(m),
                         before, -before, after);
        else if (sideways > 2e-4)
            finding_fail(finding, i, "for %s: expected the part along the surface to stay %s, found r = %s",
                         inputs_of(m), text_of(kept), text_of_floats(found));
    }
    finding_feature(finding, length, 0.0);
    finding_feature(finding, along, 0.0);
    finding_feature(finding, beside, 0.0);
}

DEFINE_CHECKS(reflect, {"table", "Mirror directions worked out by hand", CHECK_VALUES, plan_table, judge_table},
              {"anywhere", "Length stays, the way along the normal turns round", CHECK_INVARIANT, plan_anywhere,
               judge_anywhere},
              PICTURE(1))
