// Step 1.6: L = 3/(πr²) Σ f_r Φ (1 − d/r) over the photons on the normal's side, against a sum over all of them here.
#include "judge/checks/directions.h"

#include <stdlib.h>

#define MOST  700
#define CALLS 2 // of each case

// Photons lie in a disk about the point, evenly, and arrive between two angles to the normal.
typedef struct {
    const char *what; // in the student's terms
    int surface;      // 0 diffuse, 1 glossy (step 2.4), 2 glossy (step 2.3)
    int k;
    double radius; // largest allowed, 0: none
    int photons;
    double disk;     // its radius, m
    double from, to; // angles of arrival, degrees
    double behind;   // share that arrives from behind
    Vec3d normal;
    double exponent;
} Scenery;

#define SLANTED {0.48, -0.64, 0.6}

static const Scenery sceneries[] = {
    {"one photon, 0.2 m away, largest radius 0.5 m", 0, 10, 0.5, 1, 0, 40, 40, 0, {0, 0, 1}, 0},
    {"300 photons, of which the 50 nearest count", 0, 50, 0, 300, 0.5, 0, 85, 0, {0, 0, 1}, 0},
    {"the same in a disk a tenth as large", 0, 50, 0, 300, 0.05, 0, 85, 0, {0, 0, 1}, 0},
    {"200 photons, half of which arrive from behind the surface", 0, 60, 0, 200, 0.4, 0, 80, 0.5, SLANTED, 0},
    {"photons that all arrive at 75° to 88° to the normal", 0, 50, 0, 200, 0.4, 75, 88, 0, {0, 0, 1}, 0},
    {"fewer than k photons within the largest radius", 0, 200, 0.25, 200, 0.5, 0, 80, 0, {0, 1, 0}, 0},
    {"fewer than k photons in the map, no largest radius", 0, 100, 0, 30, 0.3, 0, 80, 0, {0, 0, -1}, 0},
    {"a glossy surface, n = 20", 1, 50, 0, 250, 0.5, 0, 80, 0.2, {0, 0, 1}, 20},
    {"a glossy surface, n = 100", 1, 80, 0.4, 300, 0.5, 20, 50, 0.1, {0.6, 0, 0.8}, 100},
    {"a glossy surface as step 2.3 plays it, n = 10", 2, 50, 0, 250, 0.5, 0, 80, 0.2, {0, 0, 1}, 10},
    {"only photons from behind", 0, 50, 0, 100, 0.3, 0, 80, 1, {0, 0, 1}, 0},
    {"no photon within the largest radius", 0, 50, 0.01, 1, 0, 40, 40, 0, {0, 0, 1}, 0},
    {"no photon at all", 0, 50, 0.5, 0, 0.3, 0, 80, 0, {0, 0, 1}, 0},
    {"no photon at all and no largest radius", 0, 50, 0, 0, 0.3, 0, 80, 0, {0, 0, 1}, 0},
    {"700 photons, of which the 600 nearest count", 0, 600, 0, 700, 0.5, 0, 85, 0, {0, 0, 1}, 0},
};
#define SCENERIES (int)(sizeof sceneries / sizeof *sceneries)
#define CASES     (2 * SCENERIES) // first with photons that are always the same, then with the seed's

static const Vec3d point = {0.25, -0.5, 1};
static const Vec3d diffuse[] = {{0.8, 0.5, 0.2}, {0.1, 0.2, 0.05}}, specular = {0.6, 0.7, 0.9};

static double share(int i, uint64_t seed, int photon, int use)
{
    uint64_t key = ((uint64_t)i * 1000 + (uint64_t)photon) * 16 + (uint64_t)use;
    return (double)(hash_u64(i < SCENERIES ? key : key + seed) >> 11) / 9007199254740992.0;
}

static Vec3 vec3_of(Vec3d v)
{
    return vec3((float)v.x, (float)v.y, (float)v.z);
}

static Vec3d wo_of(const Scenery *s)
{
    return vec3d_rounded(direction_at(s->normal, 35, 70));
}

static StoredPhoton photon_of(int number, uint64_t seed, int i, Vec3d *wi)
{
    const Scenery *s = &sceneries[number % SCENERIES];
    double distance = s->disk > 0.0 ? s->disk * sqrt(share(number, seed, i, 0)) : 0.2;
    Vec3d place = vec3d_along(point, direction_at(s->normal, 90, 360 * share(number, seed, i, 1)), distance);
    bool back = share(number, seed, i, 2) < s->behind;
    Vec3d side = back ? vec3d(-s->normal.x, -s->normal.y, -s->normal.z) : s->normal;
    double degrees = s->from + (s->to - s->from) * share(number, seed, i, 3);
    *wi = vec3d_rounded(direction_at(side, degrees, 360 * share(number, seed, i, 4)));
    return (StoredPhoton){.position = vec3_of(place),
                          .power =
                              colour((float)(0.5 + share(number, seed, i, 5)), (float)(0.1 + share(number, seed, i, 6)),
                                     (float)(0.3 + 0.2 * share(number, seed, i, 7))),
                          .packed_wi = direction_pack(vec3_of(*wi)), // as the map keeps it, 1e-4 off
                          .path = PATH_INDIRECT};
}

static double *put(double *at, Vec3d v)
{
    at[0] = v.x;
    at[1] = v.y;
    at[2] = v.z;
    return at + 3;
}

static void plan_values(Plan *plan)
{
    static double arguments[32 + 9 * MOST];
    for (int i = 0; i < CASES; i++) {
        const Scenery *s = &sceneries[i % SCENERIES];
        double *at = arguments;
        *at++ = s->k;
        *at++ = s->radius;
        at = put(put(put(at, point), s->normal), wo_of(s));
        *at++ = s->surface;
        at = put(put(at, diffuse[s->surface > 0]), specular);
        *at++ = s->exponent;
        *at++ = s->photons;
        for (int p = 0; p < s->photons; p++) {
            Vec3d wi;
            StoredPhoton photon = photon_of(i, plan->seed, p, &wi);
            at = put(at, vec3d_widened(photon.position));
            at = put(put(at, vec3d((double)photon.power.r, (double)photon.power.g, (double)photon.power.b)), wi);
        }
        plan_call(plan, CALLS, arguments, (size_t)(at - arguments));
    }
}

typedef struct {
    double distance;
    StoredPhoton photon;
} Near;

static int nearer(const void *a, const void *b)
{
    double x = ((const Near *)a)->distance, y = ((const Near *)b)->distance;
    return (x > y) - (x < y);
}

// The surface as tests/judge/probe/probe_calls.c makes it.
static void make_surface(const Scenery *s, Material *material, LobeTable *lobe)
{
    Vec3 d = vec3_of(diffuse[s->surface > 0]), g = vec3_of(specular);
    *material = (Material){.type = s->surface ? MATERIAL_GLOSSY : MATERIAL_DIFFUSE,
                           .diffuse = colour(d.x, d.y, d.z),
                           .specular = colour(g.x, g.y, g.z),
                           .exponent = (float)s->exponent,
                           .lobe = lobe};
    if (s->surface)
        lobe_table_fill(lobe, material->exponent);
}

// The estimate, by looking at every photon there is.
static Vec3d brute_force(int number, uint64_t seed)
{
    static Near near[MOST];
    static LobeTable lobe;
    const Scenery *s = &sceneries[number % SCENERIES];
    Material material;
    make_surface(s, &material, &lobe);
    Hit hit = {.material = &material, .normal = vec3_of(s->normal), .position = vec3_of(point)};
    Gather gather = {.glossy = s->surface == 2 ? GLOSSY_SOURCE_TEXT : GLOSSY_PHONG};
    int found = 0;
    for (int p = 0; p < s->photons; p++) {
        Vec3d wi;
        StoredPhoton photon = photon_of(number, seed, p, &wi);
        Vec3d place = vec3d_widened(photon.position);
        double distance = vec3d_length(vec3d_along(place, point, -1.0));
        if (s->radius == 0.0 || distance < s->radius)
            near[found++] = (Near){distance, photon};
    }
    qsort(near, (size_t)found, sizeof *near, nearer);
    double r = found >= s->k     ? near[s->k - 1].distance
               : s->radius > 0.0 ? s->radius
               : found           ? near[found - 1].distance
                                 : 0.0;
    Vec3d sum = {0, 0, 0};
    for (int i = 0; i < found && i < s->k; i++) {
        const StoredPhoton *photon = &near[i].photon;
        if (vec3_dot(stored_photon_wi(photon), hit.normal) <= 0.0f)
            continue;
        Colour f = gather_brdf(&gather, &hit, photon, vec3_of(wo_of(s)));
        Colour sent = colour_mul(f, photon->power);
        sum = vec3d_along(sum, vec3d((double)sent.r, (double)sent.g, (double)sent.b), 1.0 - near[i].distance / r);
    }
    return r > 0.0 ? vec3d_along(vec3d(0, 0, 0), sum, 3.0 / ((double)PI * r * r)) : sum;
}

// The channel that is farthest off, by its ratio.
static const char *ratio_words(const float *found, Vec3d expected)
{
    static const char *const names[] = {"red", "green", "blue"};
    double ratio[3] = {(double)found[0] / expected.x, (double)found[1] / expected.y, (double)found[2] / expected.z};
    int worst = 0;
    for (int c = 1; c < 3; c++)
        worst = fabs(ratio[c] - 1.0) > fabs(ratio[worst] - 1.0) + 1e-4 ? c : worst;
    return words(", in %s %.4g times the expected", names[worst], ratio[worst]);
}

// Ratios tell the mistakes apart: 3, π, r, a cosine. Where nothing is to be found there is none: an answer of 0/0 there
// is a slip of its own, which would hide the mistake that comes with it.
static void judge_scenery(int i, const Results *results, Finding *finding)
{
    const float *found = numbers_of(results, (size_t)i, 3 * CALLS, finding);
    const char *what = sceneries[i % SCENERIES].what;
    Vec3d expected = brute_force(i, results->seed);
    double largest = fmax(expected.x, fmax(expected.y, expected.z));
    bool lit = largest > 0.0;
    if (found && lit)
        finding_ratios(finding, found, (const double[]){expected.x, expected.y, expected.z}, 3);
    for (int call = 0; found && call < CALLS; call++)
        if (all_finite(found + 3 * call, 3, "a radiance", what, i, finding) &&
            vec3d_length(vec3d_along(vec3d_of(found + 3 * call), expected, -1.0)) > 2e-3 * largest)
            finding_fail(finding, i, "for %s%s: expected %s W/(m²·sr), found %s%s", what,
                         call ? ", asked a second time with the same Gather" : "", text_of_power(expected),
                         text_of_power(vec3d_of(found + 3 * call)), lit ? ratio_words(found + 3 * call, expected) : "");
    double scale[3] = {expected.x, expected.y, expected.z};
    for (int c = 0; i < SCENERIES && lit && c < 3; c++)
        finding_feature(finding, found ? (double)found[c] / scale[c] - 1.0 : (double)NAN, 0.0);
}

static void judge_values(const Results *results, Finding *finding)
{
    for (int i = 0; i < CASES; i++)
        judge_scenery(i, results, finding);
}

DEFINE_CHECKS(estimate_radiance,
              {"values", "Radiance from given photons, against a sum over all of them", CHECK_VALUES, plan_values,
               judge_values},
              PICTURE_AND_V(1))
