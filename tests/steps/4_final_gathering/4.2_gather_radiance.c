// Step 4.2: what a gather ray brings, in a scene where every surface receives the same irradiance E.
#include "judge/checks/directions.h"
#include "judge/checks/path_batches.h"

#define SCENE "tests/steps/scenes/gather.yaml"
#define TRIES 6    // rays of a station, beside each other
#define CALLS 4000 // of each ray where chance decides

typedef enum { ROUGH, MIRROR, DARK, GLASS } Kind;

// A ray in a vertical plane, `degrees` from straight down (above 90: upwards), and where its light comes from.
typedef struct {
    Kind kind;
    const char *what;
    double x, y, degrees;
    double bright[3]; // what it brings when it gets there, in E/π
    double dim[3];    // and otherwise
    double index;     // of glass; 0: there is none
    double share;     // of the rays that get there
} Station;

#define MATT    {0.6, 0.4, 0.2}
#define OTHER   {0.1, 0.3, 0.5}
#define NOTHING {0, 0, 0}

static const Station stations[] = {
    {ROUGH, "a matt surface", 0, 1, 10, MATT, NOTHING, 0, 1},
    {ROUGH, "a matt surface at a slant of 60°", -1.2, 1, 60, MATT, NOTHING, 0, 1},
    {ROUGH, "a glossy surface at a slant of 20°", 9.7, 1, 20, NOTHING, NOTHING, 0, 1},
    {ROUGH, "a glossy surface at a slant of 70°", 8.5, 0.5, 70, NOTHING, NOTHING, 0, 1},
    {MIRROR, "a mirror, and a matt surface in it", 19, 1, 45, {0.54, 0.24, 0.06}, NOTHING, 0, 1},
    {MIRROR, "two mirrors, and a matt surface in them", 29.2, 1, 45, {0.27, 0.168, 0.054}, NOTHING, 0, 1},
    {DARK, "a lamp", 40, 1, 15, NOTHING, NOTHING, 0, 1},
    {DARK, "a lamp's back", 60, 4, 15, NOTHING, NOTHING, 0, 1},
    {DARK, "nothing: the ray leaves the scene", 50, 1, 120, NOTHING, NOTHING, 0, 1},
    {DARK, "a mirror, and a lamp in it", 59.7, 1, 25, NOTHING, NOTHING, 0, 1},
    {GLASS, "a pane of glass at 60°, a matt floor behind it, another ceiling in it", 69.5, 1, 60, MATT, OTHER, 1.5, 0},
    {GLASS, "something matt within glass, from outside", 80, 3, 20, MATT, NOTHING, 1.5, 0},
    {GLASS, "something matt outside, from within glass", 88.5, 1, 160, MATT, NOTHING, 1.5, 0},
    {GLASS, "something matt within glass, by total reflection", 98, 1, 120, MATT, NOTHING, 1.5, 1},
    {GLASS, "something matt within glass that disperses, of mean index 1.7", 110, 3, 20, MATT, NOTHING, 1.7, 0},
};
#define STATIONS (int)(sizeof stations / sizeof *stations)

static Station station_of(int number)
{
    Station s = stations[number];
    double cosine = fabs(cos(s.degrees * (double)PI / 180.0));
    double scale = 1.0;
    if (number == 2 || number == 3) { // ρ_d + ρ_s (n+2)/2π ∫cosⁿα cosθ dω
        static const double diffuse[] = {0.2, 0.1, 0.3}, specular[] = {0.5, 0.6, 0.4};
        for (int c = 0; c < 3; c++)
            s.bright[c] = diffuse[c] + specular[c] * 14.0 / (2.0 * (double)PI) * lobe_weighted_exactly(12.0, cosine);
    }
    double inwards = exact_fresnel(cosine, 1.0 / fmax(1.0, s.index)), outwards = exact_fresnel(cosine, s.index);
    switch (number) {
    case 10: // in and out again, on either side of the pane, however often it is reflected within
        s.share = (1.0 - inwards) / (1.0 + inwards);
        break;
    case 11:
    case 14:
        s.share = 1.0 - inwards;
        scale = 1.0 / (s.index * s.index);
        break;
    case 12: // reflected up and down within the glass before it gets out
        s.share = 1.0 / (1.0 + outwards);
        scale = s.index * s.index;
        break;
    default:
        break;
    }
    for (int c = 0; c < 3; c++)
        s.bright[c] *= scale;
    return s;
}

// Each station has 64 numbers of its own.
static Vec3d irradiance_of(uint64_t seed, int station)
{
    int first = 64 * station;
    return vec3d(drawn_input(seed, first, 2, 3), drawn_input(seed, first + 1, 3, 4),
                 drawn_input(seed, first + 2, 4, 5));
}

static long calls_of(const Station *s)
{
    return s->share < 1.0 ? CALLS : 1;
}

// The rays of a station lie beside each other.
static void plan_kind(Plan *plan, Kind kind)
{
    for (int i = 0; i < STATIONS; i++) {
        Station s = station_of(i);
        double angle = s.degrees * (double)PI / 180.0;
        Vec3d e = irradiance_of(plan->seed, i);
        for (int t = 0; s.kind == kind && t < TRIES; t++) {
            double x = s.x + drawn_input(plan->seed, 64 * i + 10 + t, -0.1, 0.1);
            double z = drawn_input(plan->seed, 64 * i + 20 + t, -0.4, 0.4);
            plan_call_in(plan, SCENE, calls_of(&s), (double[]){e.x, e.y, e.z, x, s.y, z, sin(angle), -cos(angle), 0.0},
                         9);
        }
    }
}

static Vec3d brought(const double reflectance[3], Vec3d irradiance)
{
    return vec3d(reflectance[0] * irradiance.x / (double)PI, reflectance[1] * irradiance.y / (double)PI,
                 reflectance[2] * irradiance.z / (double)PI);
}

static bool is_like(const float *found, Vec3d expected)
{
    double size = vec3d_length(expected);
    return vec3d_length(vec3d_along(vec3d_of(found), expected, -1.0)) <= (size > 0.0 ? 2e-3 * size : 1e-6);
}

// What a ray brought that is neither of what it may.
static void judge_value(const Station *s, const float *found, Vec3d bright, Vec3d dim, long number, Finding *finding)
{
    double size = vec3d_length(bright);
    if (s->share < 1.0)
        finding_fail(finding, number,
                     "for a ray to %s: expected %s or, where the dice fall the other way, %s W/(m²·sr); found %s, "
                     "%.4g times the former",
                     s->what, text_of(bright), text_of(dim), text_of_floats(found),
                     vec3d_length(vec3d_of(found)) / size);
    else if (size > 0.0)
        finding_fail(finding, number, "for a ray to %s: expected %s W/(m²·sr), found %s, %.4g times as much", s->what,
                     text_of(bright), text_of_floats(found), vec3d_length(vec3d_of(found)) / size);
    else
        finding_fail(finding, number, "for a ray to %s: expected 0, found %s W/(m²·sr)", s->what,
                     text_of_floats(found));
}

static void judge_station(const Station *s, const Results *results, int first, Vec3d irradiance, Finding *finding)
{
    Vec3d bright = brought(s->bright, irradiance), dim = brought(s->dim, irradiance);
    double size = vec3d_length(bright) > 0.0 ? bright.x + bright.y + bright.z : 1.0;
    Sums got_there = {0, 0, 0}, value = {0, 0, 0}, other = {0, 0, 0}, red = {0, 0, 0};
    for (int t = 0; t < TRIES; t++) {
        const float *found = numbers_of(results, (size_t)(first + t), (size_t)(3 * calls_of(s)), finding);
        for (long i = 0; found && i < calls_of(s); i++, found += 3) {
            if (!all_finite(found, 3, "a radiance", s->what, first + t, finding))
                continue;
            bool is_bright = is_like(found, bright), is_dim = is_like(found, dim);
            if (!is_bright && !(is_dim && s->share < 1.0))
                judge_value(s, found, bright, dim, first + t, finding);
            sums_add(&got_there, is_bright);
            sums_add(&other, !is_bright && !is_dim);
            sums_add(&value, ((double)found[0] + (double)found[1] + (double)found[2]) / size);
            sums_add(&red, (double)found[0] / size);
        }
    }
    if (s->share < 1.0)
        finding_p(finding, binomial_p((long)got_there.sum, (long)got_there.count, s->share), first,
                  "for a ray to %s: expected %.4f of them to get there, by Fresnel's share at each surface, and bring "
                  "%s W/(m²·sr); found %.4f",
                  s->what, s->share, text_of(bright), sums_mean(&got_there));
    double dim_size = (dim.x + dim.y + dim.z) / size;
    bool dark = !(vec3d_length(bright) > 0.0);
    mean_feature(&value, dark ? 0.0 : s->share + (1.0 - s->share) * dim_size, finding);
    mean_feature(&red, dark ? 0.0 : (s->share * bright.x + (1.0 - s->share) * dim.x) / size, finding);
    mean_feature(&got_there, s->share, finding);
    mean_feature(&other, 0.0, finding);
}

static void judge_kind(const Results *results, Kind kind, Finding *finding)
{
    int first = 0;
    for (int i = 0; i < STATIONS; i++) {
        Station s = station_of(i);
        if (s.kind != kind)
            continue;
        judge_station(&s, results, first, irradiance_of(results->seed, i), finding);
        first += TRIES;
    }
}

// A check of one kind.
#define PLAN_AND_JUDGE(name, kind)                                                                                     \
    static void plan_##name(Plan *plan)                                                                                \
    {                                                                                                                  \
        plan_kind(plan, kind);                                                                                         \
    }                                                                                                                  \
    static void judge_##name(const Results *results, Finding *finding)                                                 \
    {                                                                                                                  \
        judge_kind(results, kind, finding);                                                                            \
    }
PLAN_AND_JUDGE(rough, ROUGH)
PLAN_AND_JUDGE(mirror, MIRROR)
PLAN_AND_JUDGE(dark, DARK)
PLAN_AND_JUDGE(glass, GLASS)

DEFINE_CHECKS(gather_radiance,
              {"rough", "The light that leaves a rough surface", CHECK_VALUES, plan_rough, judge_rough},
              {"mirror", "On along mirrors, whose colour it takes", CHECK_VALUES, plan_mirror, judge_mirror},
              {"dark", "Lamps and the open bring nothing, nor do lamps in mirrors", CHECK_VALUES, plan_dark,
               judge_dark},
              {"glass", "On through glass or back from it", CHECK_SAMPLES, plan_glass, judge_glass}, PICTURE(4))
