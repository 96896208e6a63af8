// Step 4.5: the weighted mean of those estimates that serve, against a sum over all of them here.
#include "judge/checks/directions.h"

#include "render/gather/gather_trace.h"

#include <stdio.h>

#define MOST      300
#define UNTOUCHED -77.0f
#define FLOATS    4 // did any serve, irradiance

typedef struct {
    const char *what;
    IrradianceEstimate estimates[MOST];
    int count;
    Vec3 position, normal;
    float accuracy;
} Place;

// Estimates of different brightness on a floor at y = 0, without a slope.
static IrradianceEstimate *add(Place *place, Vec3 position, float reach, Colour irradiance)
{
    IrradianceEstimate *estimate = &place->estimates[place->count++];
    *estimate =
        (IrradianceEstimate){.position = position, .normal = vec3(0, 1, 0), .irradiance = irradiance, .reach = reach};
    return estimate;
}

// The normal of the floor, turned by so many degrees.
static Vec3 turned(double degrees)
{
    double angle = degrees * (double)PI / 180.0;
    return vec3((float)sin(angle), (float)cos(angle), 0.0f);
}

static float drawn(uint64_t seed, int use, float low, float high)
{
    return low + (high - low) * (float)((double)(hash_u64(seed ^ hash_u64((uint64_t)use)) >> 11) / 9007199254740992.0);
}

static double error_of(const Place *place, const IrradianceEstimate *e)
{
    double turn = 0.0, distance2 = 0.0;
    const double offset[3] = {(double)place->position.x - (double)e->position.x,
                              (double)place->position.y - (double)e->position.y,
                              (double)place->position.z - (double)e->position.z};
    turn = 1.0 - ((double)place->normal.x * (double)e->normal.x + (double)place->normal.y * (double)e->normal.y +
                  (double)place->normal.z * (double)e->normal.z);
    distance2 = offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2];
    return sqrt(distance2) / (double)e->reach + sqrt(fmax(0.0, turn));
}

// How high the place lies above the estimate's surface, in parts of the depth that is allowed: below −1 is too deep.
static double height_of(const Place *place, const IrradianceEstimate *e)
{
    Vec3 offset = vec3_sub(place->position, e->position);
    return 0.5 * (double)vec3_dot(offset, vec3_add(place->normal, e->normal)) /
           (0.05 * (double)place->accuracy * (double)e->reach);
}

// Some near, some not, with slopes, on a floor that is not quite flat; none so close to a bound that rounding decides.
static void add_any(Place *place, uint64_t seed, int count)
{
    for (int use = 0; place->count < count; use += 32) {
        float x = drawn(seed, use, -1, 1), y = drawn(seed, use + 1, -0.02f, 0.02f), z = drawn(seed, use + 2, -1, 1);
        IrradianceEstimate *e = add(place, vec3(x, y, z), drawn(seed, use + 3, 0.5f, 8),
                                    colour(drawn(seed, use + 4, 1, 3), drawn(seed, use + 5, 2, 6), drawn(seed, use + 6, 1, 5)));
        e->normal = vec3_normalize(vec3(drawn(seed, use + 7, -0.15f, 0.15f), 1, drawn(seed, use + 8, -0.15f, 0.15f)));
        for (int c = 0; c < 3; c++) {
            e->translation[c] = vec3(drawn(seed, use + 10 + c, -1, 1), 0, drawn(seed, use + 13 + c, -1, 1));
            e->rotation[c] = vec3(drawn(seed, use + 16 + c, -1, 1), 0, drawn(seed, use + 19 + c, -1, 1));
        }
        bool close = fabs(error_of(place, e) - (double)place->accuracy) < 1e-3 || fabs(height_of(place, e) + 1.0) < 0.02;
        place->count -= close;
    }
}

// The place of this number; false: there is none.
static bool make_place(int number, uint64_t seed, Place *place)
{
    const Colour red = colour(5, 1, 1), blue = colour(1, 2, 6);
    *place = (Place){.normal = vec3(0, 1, 0), .accuracy = 0.25f};
    float x = drawn(seed, 1000 + number, -2, 2), z = drawn(seed, 1100 + number, -2, 2);
    place->position = vec3(x, 0, z);
    switch (number) {
    case 0:
        place->what = "one estimate, at its own place";
        add(place, place->position, 1, red);
        return true;
    case 1:
        place->what = "one estimate, halfway to where it ends to serve";
        add(place, vec3(x + 0.125f, 0, z), 1, red);
        return true;
    case 2:
        place->what = "two estimates of equal reach, one three times as far as the other";
        add(place, vec3(x + 0.05f, 0, z), 1, red);
        add(place, vec3(x, 0, z - 0.15f), 1, blue);
        return true;
    case 3:
        place->what = "two estimates equally far, one with three times the reach";
        add(place, vec3(x + 0.15f, 0, z), 1, red);
        add(place, vec3(x, 0, z - 0.15f), 3, blue);
        return true;
    case 4:
        place->what = "two estimates equally far, one of them turned by 9°";
        add(place, vec3(x + 0.05f, 0, z), 1, red);
        add(place, vec3(x, 0, z - 0.05f), 1, blue)->normal = turned(9);
        return true;
    case 5:
        place->what = "one estimate, 0.3 of its reach away, at an accuracy of 0.25";
        add(place, vec3(x, 0, z + 0.6f), 2, red);
        return true;
    case 6:
        place->what = "one estimate, turned by 20°, at an accuracy of 0.25";
        add(place, vec3(x + 0.01f, 0, z), 1, red)->normal = turned(20);
        return true;
    case 7:
        place->what = "one estimate whose n·n_i comes out as 1.0000002";
        place->normal = vec3(0, 1.0000002f, 0);
        add(place, vec3(x + 0.05f, 0, z), 1, red);
        return true;
    case 8:
        place->what = "one estimate, the place 0.1 m below its surface, R = 1 m";
        place->position.y = -0.1f;
        add(place, vec3(x, 0, z), 1, red);
        return true;
    case 9:
        place->what = "one estimate, the place 0.1 m above its surface, R = 1 m";
        place->position.y = 0.1f;
        add(place, vec3(x, 0, z), 1, red);
        return true;
    case 10:
        place->what = "one estimate, the place 0.01 m below its surface, which is allowed for R = 1 m";
        place->position.y = -0.01f;
        add(place, vec3(x, 0, z), 1, red);
        return true;
    case 11: {
        place->what = "one estimate with a slope, 0.1 m away";
        IrradianceEstimate *e = add(place, vec3(x - 0.1f, 0, z), 1, colour(4, 4, 4));
        e->translation[0] = vec3(8, 0, 0);
        e->translation[2] = vec3(-8, 0, 3);
        return true;
    }
    case 12: {
        place->what = "one estimate that changes as its normal turns, by 5°";
        IrradianceEstimate *e = add(place, vec3(x, 0, z), 1, colour(4, 4, 4));
        place->normal = turned(5);
        e->rotation[1] = vec3(0, 0, 6);
        e->rotation[2] = vec3(0, 0, -6);
        return true;
    }
    case 13:
        place->what = "two estimates, of which only the second serves";
        add(place, vec3(x + 0.6f, 0, z), 2, red);
        add(place, vec3(x + 0.1f, 0, z), 2, blue);
        return true;
    case 14:
        place->what = "no estimates at all";
        return true;
    case 15:
        place->what = "two estimates at an accuracy of 0.5, one 0.4 of its reach away";
        place->accuracy = 0.5f;
        add(place, vec3(x + 0.4f, 0, z), 1, red);
        add(place, vec3(x, 0, z - 0.1f), 1, blue);
        return true;
    case 16:
        place->what = "300 estimates all around";
        place->position = vec3(0.1f, 0, -0.2f);
        add_any(place, seed + 16, MOST);
        return true;
    case 17:
    case 18:
    case 19:
        place->what = "40 estimates all around, at an accuracy of 0.3";
        place->accuracy = 0.3f;
        place->position = vec3(drawn(seed, 1200 + number, -0.5f, 0.5f), 0, drawn(seed, 1300 + number, -0.5f, 0.5f));
        place->normal = vec3_normalize(vec3(0.05f, 1, -0.03f));
        add_any(place, seed + (uint64_t)number, 40);
        return true;
    default:
        return false;
    }
}

static double *put(double *at, Vec3 v)
{
    at[0] = (double)v.x;
    at[1] = (double)v.y;
    at[2] = (double)v.z;
    return at + 3;
}

static void plan_mean(Plan *plan)
{
    static Place place;
    static double arguments[1 + 28 * MOST + 7];
    for (int i = 0; make_place(i, plan->seed, &place); i++) {
        double *at = arguments;
        *at++ = place.count;
        for (int k = 0; k < place.count; k++) {
            const IrradianceEstimate *e = &place.estimates[k];
            at = put(put(at, e->position), e->normal);
            at = put(at, vec3(e->irradiance.r, e->irradiance.g, e->irradiance.b));
            *at++ = (double)e->reach;
            for (int c = 0; c < 3; c++)
                at = put(at, e->translation[c]);
            for (int c = 0; c < 3; c++)
                at = put(at, e->rotation[c]);
        }
        at = put(put(at, place.position), place.normal);
        *at++ = (double)place.accuracy;
        plan_call(plan, 1, arguments, (size_t)(at - arguments));
    }
}

// How many serve, and their mean.
static int exact_mean(const Place *place, Vec3d *mean)
{
    double weights = 0.0;
    int serving = 0;
    Vec3d sum = {0, 0, 0};
    for (int k = 0; k < place->count; k++) {
        const IrradianceEstimate *e = &place->estimates[k];
        double error = error_of(place, e);
        if (error >= (double)place->accuracy || height_of(place, e) < -1.0)
            continue;
        Colour here = irradiance_extrapolate(e, place->position, place->normal);
        double weight = 1.0 - error / (double)place->accuracy;
        sum = vec3d_along(sum, vec3d((double)here.r, (double)here.g, (double)here.b), weight);
        weights += weight;
        serving++;
    }
    *mean = serving ? vec3d_along(vec3d(0, 0, 0), sum, 1.0 / weights) : sum;
    return serving;
}

static void judge_none(const Place *place, const float *found, long number, Finding *finding)
{
    if (found[0] != 0.0f)
        finding_fail(finding, number, "for %s: expected false, since none serves there; found true and %s W/m²",
                     place->what, text_of_floats(found + 1));
    for (int c = 1; c < FLOATS; c++)
        if (found[c] != UNTOUCHED)
            finding_fail(finding, number, "for %s: expected *irradiance to be left alone, since none serves there; "
                                          "found %s in it",
                         place->what, text_of_floats(found + 1));
}

static void judge_mean(const Results *results, Finding *finding)
{
    static Place place;
    for (int i = 0; make_place(i, results->seed, &place); i++) {
        Vec3d expected;
        int serving = exact_mean(&place, &expected);
        const float *found = numbers_of(results, (size_t)i, FLOATS, finding);
        bool both = found && found[0] != 0.0f && serving > 0;
        if (found && serving == 0)
            judge_none(&place, found, i, finding);
        else if (found && found[0] == 0.0f)
            finding_fail(finding, i, "for %s: expected true, since %s; found false", place.what,
                         place.count == 1 ? "it serves there" : "some serve there");
        else if (both && all_finite(found + 1, 3, "an irradiance", place.what, i, finding) &&
                 vec3d_length(vec3d_along(vec3d_of(found + 1), expected, -1.0)) > 2e-3 * vec3d_length(expected))
            finding_fail(finding, i, "for %s: expected %s W/m², found %s", place.what, text_of(expected),
                         text_of_floats(found + 1));
        float spread = i >= 16 ? 0.02f : 0.0f;
        finding_feature(finding, found ? (double)found[0] - (serving > 0) : (double)NAN, 0.0);
        finding_feature(finding, both ? (double)found[1] / expected.x - 1.0 : 0.0, (double)spread);
        finding_feature(finding, both ? (double)found[3] / expected.z - 1.0 : 0.0, (double)spread);
    }
}

DEFINE_CHECKS(interpolate_irradiance,
              {"mean", "The mean of the estimates that serve at a place", CHECK_VALUES, plan_mean, judge_mean, false},
              PICTURE_4)
