// Step 1.2: uniform on the rectangle, cosine about its normal, the light's whole power.
#include "judge/checks/directions.h"

typedef struct {
    Vec3d corner, u, v, radiance;
} Lamp;

// On the ceiling, a slanted parallelogram with sides of different length, a small bluish one on a wall.
static const Lamp lamps[] = {
    {{0.3, 1.99, 0.4}, {0.4, 0, 0}, {0, 0, 0.3}, {15, 15, 15}},
    {{-1, 0.5, 2}, {1, 0.5, 0}, {0.2, 0.9, 0.6}, {12, 6, 1}},
    {{0.5, -0.25, -1}, {0, 0, -0.05}, {0.04, 0.16, 0.02}, {3, 40, 90}},
};
#define LAMPS   (int)(sizeof lamps / sizeof *lamps)
#define SAMPLES 16000
#define A_FEW   40
#define FLOATS  14 // position, direction, power, colour, bounce, and what photon_fly keeps
#define SIDE    10 // cells along a side of the light

// What a lamp's rectangle gives, as tests/judge/probe/probe_calls.c works it out.
typedef struct {
    Vec3d corner, u, v, direction, power;
    double size;
    const char *inputs;
} Lit;

static Lit lit(int i)
{
    Lit l = {.corner = vec3d_rounded(lamps[i].corner), .u = vec3d_rounded(lamps[i].u), .v = vec3d_rounded(lamps[i].v)};
    Vec3d across = vec3d_cross(l.u, l.v);
    double area = vec3d_length(across);
    l.direction = vec3d_unit(across);
    l.power = vec3d_along(vec3d(0, 0, 0), lamps[i].radiance, (double)PI * area);
    l.size = sqrt(area);
    l.inputs = words("the light with edges %s and %s", text_of(l.u), text_of(l.v));
    return l;
}

static void plan_lamps(Plan *plan, long samples)
{
    for (int i = 0; i < LAMPS; i++) {
        const Lamp *l = &lamps[i];
        double arguments[] = {l->corner.x, l->corner.y, l->corner.z, l->u.x,        l->u.y,        l->u.z,
                              l->v.x,      l->v.y,      l->v.z,      l->radiance.x, l->radiance.y, l->radiance.z};
        plan_call(plan, samples, arguments, 12);
    }
}

static void plan_photon(Plan *plan)
{
    plan_lamps(plan, A_FEW);
}

static void judge_photon(const Results *results, Finding *finding)
{
    for (int i = 0; i < LAMPS; i++) {
        Lit l = lit(i);
        Sums ratio[3] = {{0, 0, 0}}, colour = {0, 0, 0}, bounce = {0, 0, 0};
        const float *photon = numbers_of(results, (size_t)i, FLOATS * A_FEW, finding);
        for (int s = 0; photon && s < A_FEW; s++, photon += FLOATS) {
            const double expected[3] = {l.power.x, l.power.y, l.power.z};
            finding_ratios(finding, photon + 6, expected, 3);
            for (int c = 0; c < 3; c++) {
                sums_add(&ratio[c], (double)photon[6 + c] / expected[c]);
                if (!(fabs((double)photon[6 + c] / expected[c] - 1.0) < 1e-4))
                    finding_fail(finding, i, "expected the light's whole power %s W, found %s, for %s",
                                 text_of(l.power), text_of_floats(photon + 6), l.inputs);
            }
            if (photon[9] != 0.0f)
                finding_fail(finding, i, "expected a white photon (colour 0), found colour %g", (double)photon[9]);
            if (photon[10] != 0.0f)
                finding_fail(finding, i, "expected bounce 0 at the light, found %g", (double)photon[10]);
            sums_add(&colour, (double)photon[9]);
            sums_add(&bounce, (double)photon[10]);
        }
        for (int c = 0; c < 3; c++)
            mean_feature(&ratio[c], 1.0, finding);
        mean_feature(&colour, 0.0, finding);
        mean_feature(&bounce, 0.0, finding);
    }
}

// Where a point is along the two edges, 0…1 each, and how far before the plane, as a share of the light's size.
static Vec3d place_on(const Lit *l, const float *position)
{
    Vec3d p = vec3d_along(vec3d_of(position), l->corner, -1.0);
    Vec3d normal = vec3d_cross(l->u, l->v);
    double area2 = vec3d_dot(normal, normal);
    return vec3d(vec3d_dot(vec3d_cross(p, l->v), normal) / area2, vec3d_dot(vec3d_cross(l->u, p), normal) / area2,
                 vec3d_dot(p, l->direction) / l->size);
}

// A hair before the light is as good as on it.
static bool is_on_light(Vec3d place)
{
    return fmin(place.x, place.y) > -1e-3 && fmax(place.x, place.y) < 1.0 + 1e-3 && fabs(place.z) < 2e-3;
}

static int cell(double share, int cells)
{
    return (int)fmin(fmax(share, 0.0) * cells, cells - 1);
}

static void plan_samples(Plan *plan)
{
    plan_lamps(plan, SAMPLES);
}

static void judge_place(const Results *results, Finding *finding)
{
    for (int i = 0; i < LAMPS; i++) {
        Lit l = lit(i);
        double observed[SIDE * SIDE] = {0}, expected[SIDE * SIDE];
        Sums u = {0, 0, 0}, v = {0, 0, 0}, off = {0, 0, 0}, uu = {0, 0, 0}, vv = {0, 0, 0}, uv = {0, 0, 0};
        const float *photon = numbers_of(results, (size_t)i, FLOATS * SAMPLES, finding);
        for (long s = 0; photon && s < SAMPLES; s++, photon += FLOATS) {
            if (!all_finite(photon, 3, "a position", l.inputs, i, finding))
                continue;
            Vec3d place = place_on(&l, photon);
            if (!is_on_light(place))
                finding_fail(finding, i,
                             "expected positions on the light; found %s, which is u = %.3f, v = %.3f along its "
                             "edges and %.3f m off its plane, for %s",
                             text_of_floats(photon), place.x, place.y, place.z * l.size, l.inputs);
            observed[cell(place.x, SIDE) * SIDE + cell(place.y, SIDE)]++;
            sums_add(&u, place.x);
            sums_add(&v, place.y);
            sums_add(&uu, (place.x - 0.5) * (place.x - 0.5));
            sums_add(&vv, (place.y - 0.5) * (place.y - 0.5));
            sums_add(&uv, (place.x - 0.5) * (place.y - 0.5));
            sums_add(&off, !is_on_light(place));
        }
        double fewest = INFINITY, most = 0.0;
        for (int b = 0; b < SIDE * SIDE; b++) {
            expected[b] = u.count / (SIDE * SIDE);
            fewest = fmin(fewest, observed[b] / expected[b]);
            most = fmax(most, observed[b] / expected[b]);
        }
        finding_p(finding, u.count > 0.0 ? chi_square_p(observed, expected, SIDE * SIDE) : 1.0, i,
                  "expected positions spread evenly over the light; their means along the edges should be 0.5 and 0.5, "
                  "found %.4f and %.4f, in 10×10 cells from %.3g to %.3g times the expected, for %s",
                  sums_mean(&u), sums_mean(&v), fewest, most, l.inputs);
        mean_feature(&u, 0.5, finding);
        mean_feature(&v, 0.5, finding);
        mean_feature(&off, 0.0, finding);
        mean_feature(&uu, 1.0 / 12.0, finding);
        mean_feature(&vv, 1.0 / 12.0, finding);
        mean_feature(&uv, 0.0, finding);
    }
}

#define COARSE (3 * 3 * 2 * 4) // cells of place and direction together

// Two numbers from the stream used twice tie the direction to the place.
static int coarse_cell(const Lit *l, const DirectionCount *count, const float *photon)
{
    Vec3d place = place_on(l, photon), d = vec3d_unit(vec3d_of(photon + 3));
    double cosine = vec3d_dot(d, l->direction);
    int quarter = (vec3d_dot(d, count->tangent) > 0.0 ? 2 : 0) + (vec3d_dot(d, count->bitangent) > 0.0 ? 1 : 0);
    return ((cell(place.x, 3) * 3 + cell(place.y, 3)) * 2 + (cosine * cosine > 0.5 ? 1 : 0)) * 4 + quarter;
}

static void judge_direction(const Results *results, Finding *finding)
{
    for (int i = 0; i < LAMPS; i++) {
        Lit l = lit(i);
        double joint[COARSE] = {0}, even[COARSE];
        Sums with_u = {0, 0, 0}, with_v = {0, 0, 0};
        DirectionCount count;
        directions_begin(&count, &(DirectionDensity){l.direction, 2.0, lambert, &l.direction});
        const float *photon = numbers_of(results, (size_t)i, FLOATS * SAMPLES, finding);
        for (long s = 0; photon && s < SAMPLES; s++, photon += FLOATS) {
            if (!direction_is_above(photon + 3, l.direction, l.inputs, i, finding) ||
                !all_finite(photon, 3, "a position", l.inputs, i, finding))
                continue;
            directions_add(&count, photon + 3);
            joint[coarse_cell(&l, &count, photon)]++;
            double cosine = vec3d_dot(vec3d_of(photon + 3), l.direction) - 2.0 / 3;
            sums_add(&with_u, cosine * (place_on(&l, photon).x - 0.5));
            sums_add(&with_v, cosine * (place_on(&l, photon).y - 0.5));
        }
        for (int b = 0; b < COARSE; b++)
            even[b] = count.along.count / COARSE;
        finding_p(
            finding, directions_p(&count), i,
            "expected directions of density cosθ/π about the light's normal; the mean of cosθ should be %.4f, found "
            "%.4f, and the mean across the normal (0, 0), found (%.4f, %.4f), for %s",
            count.expected.along, sums_mean(&count.along), sums_mean(&count.across), sums_mean(&count.up), l.inputs);
        finding_p(finding, count.along.count > 0.0 ? chi_square_p(joint, even, COARSE) : 1.0, i,
                  "expected directions that do not depend on the position; found that they do, for %s: "
                  "is a random number used twice?",
                  l.inputs);
        directions_features(&count, finding);
        mean_feature(&with_u, 0.0, finding);
        mean_feature(&with_v, 0.0, finding);
        if (i == 1)
            directions_histogram(&count, "cosθ of photons to the light's normal", finding);
    }
}

DEFINE_CHECKS(emit_photon,
              {"photon", "A white photon with the light's whole power", CHECK_VALUES, plan_photon, judge_photon},
              {"place", "Positions are even over the light", CHECK_SAMPLES, plan_samples, judge_place},
              {"direction", "Directions follow cosθ/π about the light's normal, wherever the position", CHECK_SAMPLES,
               plan_samples, judge_direction},
              PICTURE(1))
