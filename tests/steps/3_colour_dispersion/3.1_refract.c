// Step 3.1: Snell's law, in double precision, over a table of indices and angles.
#include "judge/checks/path_batches.h"

static const double etas[] = {1.0 / 2.42, 1.0 / 1.5, 1.0, 1.5, 2.42};
static const double degrees[] = {0, 0.5, 10, 24, 24.8, 30, 41.5, 42.2, 60, 80, 89};
#define ETAS      5
#define ANGLES    11
#define NORMALS   4
#define UNTOUCHED -77.0 // what the probe leaves in *refracted beforehand

typedef struct {
    float direction[3], normal[3], eta;
    double degrees, along[3]; // along: unit, in the surface, the way the light goes
} Arrival;

// Two unit vectors at right angles: first +y, then from a list without pattern, the last two as the seed has them.
static void surface(int number, uint64_t seed, double normal[3], double along[3])
{
    uint64_t h = hash_u64((number % NORMALS < 2 ? 31u : seed) + (uint64_t)number);
    double z = number ? 2.0 * (double)(h & 0xffff) / 65535.0 - 1.0 : 0.0;
    double turn = number ? (double)(h >> 16 & 0xffff) / 65535.0 * 6.283185307 : 1.570796327;
    double r = sqrt(1.0 - z * z), roll = (double)(h >> 32 & 0xffff) / 65535.0 * 6.283185307;
    const double n[3] = {r * cos(turn), r * sin(turn), z};
    const double a[3] = {-sin(turn), cos(turn), 0.0}, b[3] = {-z * cos(turn), -z * sin(turn), r};
    for (int i = 0; i < 3; i++) {
        normal[i] = n[i];
        along[i] = cos(roll) * a[i] + sin(roll) * b[i];
    }
}

static Arrival arrival(int number, uint64_t seed)
{
    Arrival a = {.eta = (float)etas[number / (ANGLES * NORMALS)], .degrees = degrees[number / NORMALS % ANGLES]};
    double normal[3], angle = a.degrees * (double)PI / 180.0;
    surface(number % NORMALS ? number : 0, seed, normal, a.along);
    for (int i = 0; i < 3; i++) {
        a.normal[i] = (float)normal[i];
        a.direction[i] = (float)(sin(angle) * a.along[i] - cos(angle) * normal[i]);
    }
    return a;
}

static void plan_snell(Plan *plan)
{
    for (int number = 0; number < ETAS * ANGLES * NORMALS; number++) {
        Arrival a = arrival(number, plan->seed);
        double arguments[7];
        for (int i = 0; i < 3; i++) {
            arguments[i] = (double)a.direction[i];
            arguments[3 + i] = (double)a.normal[i];
        }
        arguments[6] = (double)a.eta;
        plan_call(plan, 1, arguments, 7);
    }
}

static double dot(const double a[3], const float b[3])
{
    return a[0] * (double)b[0] + a[1] * (double)b[1] + a[2] * (double)b[2];
}

// What refract said: 1 or 0; the parts of *refracted along the surface, along the normal and across both; its length.
typedef struct {
    double through, along, normal, across, length;
} Found;

static Found found_in(const Numbers *numbers, const Arrival *a)
{
    Found f = {(double)NAN, (double)NAN, (double)NAN, (double)NAN, (double)NAN};
    if (!numbers->values || numbers->count != 4)
        return f;
    const double t[3] = {(double)numbers->values[1], (double)numbers->values[2], (double)numbers->values[3]};
    f.through = (double)numbers->values[0];
    f.along = t[0] * a->along[0] + t[1] * a->along[1] + t[2] * a->along[2];
    f.normal = dot(t, a->normal);
    f.length = sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    f.across = sqrt(fmax(0.0, f.length * f.length - f.along * f.along - f.normal * f.normal));
    return f;
}

static void judge_total(const Arrival *a, const Found *f, const Numbers *numbers, long number, Finding *finding)
{
    if (f->through != 0.0)
        finding_fail(finding, number, "expected total reflection (false) for eta = %.4g at %g°; found true",
                     (double)a->eta, a->degrees);
    for (int i = 1; i < 4; i++)
        if (!numbers->values || (double)numbers->values[i] != UNTOUCHED)
            finding_fail(finding, number,
                         "expected *refracted to be left alone under total reflection; found it changed, for "
                         "eta = %.4g at %g°",
                         (double)a->eta, a->degrees);
}

static void judge_through(const Arrival *a, const Found *f, double along, double normal, long number, Finding *finding)
{
    const double tolerance = 1e-3; // the root near the critical angle multiplies rounding by up to a thousand
    if (f->through != 1.0)
        finding_fail(finding, number, "expected light to get through (true) for eta = %.4g at %g°; found false",
                     (double)a->eta, a->degrees);
    else if (!(fabs(f->along - along) <= tolerance && fabs(f->normal - normal) <= tolerance))
        finding_fail(finding, number,
                     "expected sinθ_t = eta·sinθ_i = %.4f along the surface and %.4f along the normal for eta = "
                     "%.4g at %g°; found %.4f and %.4f",
                     along, normal, (double)a->eta, a->degrees, f->along, f->normal);
    else if (!(f->across <= 0.03))
        finding_fail(finding, number,
                     "expected a direction in the plane of direction and normal; found it %.3f beside, for eta = "
                     "%.4g at %g°",
                     f->across, (double)a->eta, a->degrees);
    else if (!(fabs(f->length - 1.0) <= tolerance))
        finding_fail(finding, number, "expected a direction of length 1; found length %.4f, for eta = %.4g at %g°",
                     f->length, (double)a->eta, a->degrees);
}

static void judge_snell(const Results *results, Finding *finding)
{
    for (int number = 0; number < ETAS * ANGLES * NORMALS; number++) {
        Arrival a = arrival(number, results->seed);
        const Numbers *numbers = &results->cases[number];
        Found f = found_in(numbers, &a);
        double eta = (double)a.eta, along = eta * sin(a.degrees * (double)PI / 180.0);
        double cos2 = 1.0 - along * along, normal = cos2 > 0.0 ? -sqrt(cos2) : 0.0;
        if (cos2 < 0.0)
            judge_total(&a, &f, numbers, number, finding);
        else
            judge_through(&a, &f, along, normal, number, finding);
        bool canonical = number % NORMALS == 1 && (a.degrees == 10.0 || a.degrees == 30.0 || a.degrees == 60.0);
        if (!canonical)
            continue;
        bool both = cos2 > 0.0 && f.through == 1.0;
        finding_feature(finding, f.through - (cos2 < 0.0 ? 0.0 : 1.0), 0.0);
        // The way it points, whether or not it is brought to length 1; the length where nothing else is wrong.
        double off_along = f.along / f.length - along, off_normal = f.normal / f.length - normal;
        bool right_way = fabs(off_along) < 1e-5 && fabs(off_normal) < 1e-5;
        finding_feature(finding, both ? off_along : (double)NAN, 0.0);
        finding_feature(finding, both ? off_normal : (double)NAN, 0.0);
        finding_feature(finding, both && right_way ? f.length - 1.0 : 0.0, 0.0);
    }
}

DEFINE_CHECKS(refract, {"snell", "Directions follow Snell's law", CHECK_VALUES, plan_snell, judge_snell}, PICTURE(3))
