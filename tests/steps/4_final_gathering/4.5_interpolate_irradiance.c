// Step 4.5: the weighted mean of those estimates that serve, against a sum over all of them here.
#include "judge/checks/directions.h"

#include <string.h>

#define MOST      300
#define UNTOUCHED -77.0f
#define FLOATS    4 // did any serve, irradiance
#define ABOVE_ONE "one estimate whose n·n_i comes out as 1.0000002"

typedef struct {
    const char *what;
    IrradianceEstimate estimates[MOST];
    int count;
    Vec3 position, normal;
    float accuracy;
} Place;

static float drawn(uint64_t seed, int use, float low, float high)
{
    return (float)drawn_input(seed, use, (double)low, (double)high);
}

static double error_of(const Place *place, const IrradianceEstimate *e)
{
    double turn = 1.0 - vec3d_dot(vec3d_widened(place->normal), vec3d_widened(e->normal));
    double distance = vec3d_length(vec3d_along(vec3d_widened(place->position), vec3d_widened(e->position), -1.0));
    return distance / (double)e->reach + sqrt(fmax(0.0, turn));
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
        IrradianceEstimate *e = &place->estimates[place->count++];
        e->position = vec3(drawn(seed, use, -1, 1), drawn(seed, use + 1, -0.02f, 0.02f), drawn(seed, use + 2, -1, 1));
        e->normal = vec3_normalize(vec3(drawn(seed, use + 7, -0.15f, 0.15f), 1, drawn(seed, use + 8, -0.15f, 0.15f)));
        e->irradiance = colour(drawn(seed, use + 4, 1, 3), drawn(seed, use + 5, 2, 6), drawn(seed, use + 6, 1, 5));
        e->reach = drawn(seed, use + 3, 0.5f, 8);
        for (int c = 0; c < 3; c++) {
            e->translation[c] = vec3(drawn(seed, use + 10 + c, -1, 1), 0, drawn(seed, use + 13 + c, -1, 1));
            e->rotation[c] = vec3(drawn(seed, use + 16 + c, -1, 1), 0, drawn(seed, use + 19 + c, -1, 1));
        }
        bool close =
            fabs(error_of(place, e) - (double)place->accuracy) < 1e-3 || fabs(height_of(place, e) + 1.0) < 0.02;
        place->count -= close;
    }
}

// An estimate on a floor at y = 0, beside the place.
typedef struct {
    float x, z, reach; // 0: there is none
    int hue;           // red or blue
    float degrees;     // its normal leans towards x
    float slope;       // along x, of red; the other way of blue
    float turning;     // with the normal, of green; the other way of blue
} Beside;

typedef struct {
    const char *what;
    Beside estimates[2];
    float height, degrees; // of the place, and of its normal
    float accuracy;        // 0: 0.25
} Setting;

enum { red = 0, blue = 1 };

#define BESIDE(x_, z_, reach_, hue_) .x = x_, .z = z_, .reach = reach_, .hue = hue_
static const Setting settings[] = {
    {"one estimate, at its own place", .estimates = {{BESIDE(0, 0, 1, red)}}},
    {"one estimate, halfway to where it ends to serve", .estimates = {{BESIDE(0.125f, 0, 1, red)}}},
    {"two estimates of equal reach, one three times as far as the other",
     .estimates = {{BESIDE(0.05f, 0, 1, red)}, {BESIDE(0, -0.15f, 1, blue)}}},
    {"two estimates equally far, one with three times the reach",
     .estimates = {{BESIDE(0.15f, 0, 1, red)}, {BESIDE(0, -0.15f, 3, blue)}}},
    {"two estimates equally far, one of them turned by 9°",
     .estimates = {{BESIDE(0.05f, 0, 1, red)}, {BESIDE(0, -0.05f, 1, blue), .degrees = 9}}},
    {"one estimate, 0.3 of its reach away, at an accuracy of 0.25", .estimates = {{BESIDE(0, 0.6f, 2, red)}}},
    {"one estimate, turned by 20°, at an accuracy of 0.25", .estimates = {{BESIDE(0.01f, 0, 1, red), .degrees = 20}}},
    {ABOVE_ONE, .estimates = {{BESIDE(0.05f, 0, 1, red)}}},
    {"one estimate, the place 0.1 m below its surface, R = 1 m", .estimates = {{BESIDE(0, 0, 1, red)}},
     .height = -0.1f},
    {"one estimate, the place 0.1 m above its surface, R = 1 m", .estimates = {{BESIDE(0, 0, 1, red)}}, .height = 0.1f},
    {"one estimate, the place 0.01 m below its surface, which is allowed for R = 1 m",
     .estimates = {{BESIDE(0, 0, 1, red)}}, .height = -0.01f},
    {"one estimate with a slope, 0.1 m away", .estimates = {{BESIDE(-0.1f, 0, 1, red), .slope = 8}}},
    {"one estimate that changes as its normal turns, by 5°", .estimates = {{BESIDE(0, 0, 1, blue), .turning = 6}},
     .degrees = 5},
    {"two estimates, of which only the second serves",
     .estimates = {{BESIDE(0.6f, 0, 2, red)}, {BESIDE(0.1f, 0, 2, blue)}}},
    {"no estimates at all", .estimates = {{BESIDE(0, 0, 0, red)}}},
    {"two estimates at an accuracy of 0.5, one 0.4 of its reach away",
     .estimates = {{BESIDE(0.4f, 0, 1, red)}, {BESIDE(0, -0.1f, 1, blue)}}, .accuracy = 0.5f},
};
#define SETTINGS (int)(sizeof settings / sizeof *settings)
#define CROWDS   4 // and then many estimates all around

static Vec3 leaning(float degrees)
{
    double angle = (double)degrees * (double)PI / 180.0;
    return vec3((float)sin(angle), (float)cos(angle), 0.0f);
}

static void make_setting(const Setting *setting, Place *place)
{
    place->what = setting->what;
    place->accuracy = setting->accuracy > 0.0f ? setting->accuracy : 0.25f;
    place->position.y = setting->height;
    place->normal = leaning(setting->degrees);
    if (strcmp(setting->what, ABOVE_ONE) == 0)
        place->normal.y = 1.0000002f;
    for (const Beside *b = setting->estimates; b < setting->estimates + 2 && b->reach > 0.0f; b++) {
        IrradianceEstimate *e = &place->estimates[place->count++];
        e->position = vec3(place->position.x + b->x, 0.0f, place->position.z + b->z);
        e->normal = leaning(b->degrees);
        e->irradiance = b->hue == blue ? colour(1, 2, 6) : colour(5, 1, 1);
        e->reach = b->reach;
        e->translation[0] = vec3(b->slope, 0, 0);
        e->translation[2] = vec3(-0.2f * b->slope, 0, 0);
        e->rotation[1] = vec3(0, 0, b->turning);
        e->rotation[2] = vec3(0, 0, -b->turning);
    }
}

// The place of this number; false: there is none.
static bool make_place(int number, uint64_t seed, Place *place)
{
    *place = (Place){.normal = vec3(0, 1, 0), .accuracy = 0.25f};
    place->position = vec3(drawn(seed, 1000 + number, -2, 2), 0, drawn(seed, 1100 + number, -2, 2));
    if (number < SETTINGS) {
        make_setting(&settings[number], place);
    } else if (number == SETTINGS) {
        place->what = "300 estimates all around";
        place->position = vec3(0.1f, 0, -0.2f);
        add_any(place, seed + 16, MOST);
    } else {
        place->what = "40 estimates all around, at an accuracy of 0.3";
        place->accuracy = 0.3f;
        place->position = vec3_scale(place->position, 0.25f);
        place->normal = vec3_normalize(vec3(0.05f, 1, -0.03f));
        add_any(place, seed + (uint64_t)number, 40);
    }
    return number < SETTINGS + CROWDS;
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
            finding_fail(finding, number,
                         "for %s: expected *irradiance to be left alone, since none serves there; "
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
        float spread = i >= SETTINGS ? 0.02f : 0.0f;
        finding_feature(finding, found ? (double)found[0] - (serving > 0) : (double)NAN, 0.0);
        finding_feature(finding, both ? (double)found[1] / expected.x - 1.0 : 0.0, (double)spread);
        finding_feature(finding, both ? (double)found[3] / expected.z - 1.0 : 0.0, (double)spread);
    }
}

DEFINE_CHECKS(interpolate_irradiance,
              {"mean", "The mean of the estimates that serve at a place", CHECK_VALUES, plan_mean, judge_mean},
              PICTURE(4))
