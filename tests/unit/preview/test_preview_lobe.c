// The preview's lobe: the equation's surface, and the cloud of a step's samples about it.
#include "preview/view/view_internal.h"
#include "unit/test_common.h"

// Over the upper hemisphere: what is missing to 1 is what points into the surface.
static double density_integral(StepChoice play, bool diffuse)
{
    double sum = 0;
    int rings = 600, spokes = 600;
    Lobe lobe = lobe_of(20, 60, diffuse, play);
    for (int i = 0; i < rings; i++)
        for (int j = 0; j < spokes; j++) {
            float z = ((float)i + 0.5f) / (float)rings, phi = 2 * PI * ((float)j + 0.5f) / (float)spokes;
            float level = sqrtf(1 - z * z);
            sum += (double)lobe_density(&lobe, vec3(level * cosf(phi), level * sinf(phi), z));
        }
    assert_true(lobe_density(&lobe, vec3(0, 0, -1)) == 0);
    return sum * 2 * (double)PI / (rings * spokes);
}

TEST(densities_add_up)
{
    LobeTable *table = memory(1, sizeof *table);
    lobe_table_fill(table, 20);
    float above = lobe_lookup(table->above, cosf(60 * PI / 180)) * 21 / (2 * PI);
    StepChoice phong = {GLOSSY_PHONG, false}, source = {GLOSSY_SOURCE_TEXT, false};
    assert_true(fabs(density_integral(phong, false) - (double)above) < 2e-3);
    assert_true(above < 0.999f);
    assert_true(fabs(density_integral(source, false) - 1) < 2e-3);
    assert_true(fabs(density_integral(phong, true) - 1) < 2e-3);
}

// ---- the cloud

typedef enum { RIGHT, INSIDE_OUT, UNTURNED, TOO_LONG } StepFault;

static const struct {
    const char *name;
    float exponent, angle;
    bool diffuse, source_text;
} settings[] = {
    // half of the third's lobe lies below the horizon
    {"20 at 60 degrees", 20, 60, false, false}, {"100 at 80 degrees", 100, 80, false, false},
    {"5 at 80 degrees", 5, 80, false, false},   {"20 at 60 degrees, by step 2.3", 20, 60, false, true},
    {"diffuse", 20, 60, true, false},
};
#ifdef SANITIZED
#define SETTINGS 1
#else
#define SETTINGS (sizeof settings / sizeof *settings)
#endif
#define SAMPLES 20000

static Vec3 sample(const Lobe *lobe, StepFault fault, Rng *rng, float *weight)
{
    Vec3 normal = vec3(0, 0, 1), out = normal, mirror = fault == UNTURNED ? normal : lobe->mirror;
    *weight = 1.0f;
    if (lobe->diffuse)
        out = steps.scatter_diffuse(fault == UNTURNED ? vec3(sinf(1.0f), 0, cosf(1.0f)) : normal, rng);
    else if (!steps.scatter_glossy(vec3(mirror.x, 0, -mirror.z), normal, lobe->exponent, rng, &out, weight))
        *weight = 0.0f;
    return vec3_scale(out, fault == INSIDE_OUT ? -1.0f : fault == TOO_LONG ? 1.3f : 1.0f);
}

// What is wrong is so by far: fewer samples tell it.
static Findings samples_of(const Lobe *lobe, StepFault fault)
{
    LobeSample *items = memory(SAMPLES, sizeof *items);
    Findings samples = {items, fault == RIGHT ? SAMPLES : SAMPLES / 4};
    for (size_t i = 0; i < samples.count; i++) {
        Rng rng = rng_create(11, i);
        items[i].direction = sample(lobe, fault, &rng, &items[i].weight);
    }
    return samples;
}

// An estimate by LOBE_NEAREST neighbours, where the step is right, as part of the lobe's length. By halves: how large its disk is.
static double estimate_at(const Lobe *lobe, Vec3 direction)
{
    float low = 0, high = 2, share, estimate = 0;
    for (int i = 0; i < 14; i++) {
        float r = 0.5f * (low + high);
        estimate = lobe_expected(lobe, direction, r, &share);
        *(share > (float)LOBE_NEAREST / SAMPLES ? &high : &low) = r;
    }
    return (double)(estimate / lobe->peak);
}

// Means over the cloud's points, as parts of the lobe's length: how far from the surface, how far outwards of it, and
// how far the noise alone of an estimate puts them from it (a normal deviate's size is 0.798 on average).
#define NOISE (0.798 / sqrt((double)LOBE_NEAREST))
typedef struct {
    double apart, outwards, noise;
    size_t count, absorbed, too_long, below;
} Distance;

static Distance cloud_distance(size_t setting, StepFault fault)
{
    StepChoice play = {settings[setting].source_text ? GLOSSY_SOURCE_TEXT : GLOSSY_PHONG, false};
    LobeCounts counts;
    Vertices cloud = {.items = NULL};
    Distance distance = {0};
    steps_play(play);
    Lobe lobe = lobe_of(settings[setting].exponent, settings[setting].angle, settings[setting].diffuse, play);
    Findings samples = samples_of(&lobe, fault);
    lobe_cloud(&lobe, &samples, &counts, &cloud);
    for (size_t i = 0; i < cloud.count; i++) {
        Vec3 local = vec3(cloud.items[i].x, -cloud.items[i].z, cloud.items[i].y); // up is +y
        float reach = vec3_length(local);
        float density = lobe_density(&lobe, vec3_scale(local, 1.0f / reach));
        double out = (double)(reach - density / lobe.peak);
        distance.apart += fabs(out) / (double)cloud.count;
        distance.outwards += out / (double)cloud.count;
        if (fault == RIGHT && i % 50 == 0)
            distance.noise += 50.0 * NOISE * estimate_at(&lobe, vec3_scale(local, 1.0f / reach)) / (double)cloud.count;
    }
    distance.count = cloud.count;
    distance.absorbed = counts.absorbed;
    distance.too_long = counts.not_unit;
    distance.below = counts.below;
    vertices_free(&cloud);
    return distance;
}

static Distance right[SETTINGS];

// The mean of so few estimates that know nothing of each other: a normal deviate's size is 0.756 of its mean to one standard error.
TEST(right_samples_lie_on_the_surface)
{
    double most = 1.0 + 3.0 * 0.756 / sqrt((double)SAMPLES / LOBE_NEAREST);
    for (size_t i = 0; i < SETTINGS; i++) {
        Distance d = right[i] = cloud_distance(i, RIGHT);
        if (!(d.apart < most * d.noise && fabs(d.outwards) < 0.01))
            fail_msg("%s: %.4f apart, noise %.4f, %.4f outwards", settings[i].name, d.apart, d.noise, d.outwards);
        assert_int_equal(d.count + d.absorbed, SAMPLES);
        assert_int_equal(d.too_long + d.below, 0);
    }
}

// Each fault moves the points far off, and is counted where a count is kept of it.
TEST(wrong_samples_do_not)
{
    for (size_t i = 0; i < SETTINGS; i += 4) { // a glossy one and the diffuse one
        Distance inside_out = cloud_distance(i, INSIDE_OUT), unturned = cloud_distance(i, UNTURNED);
        Distance too_long = cloud_distance(i, TOO_LONG);
        assert_true(inside_out.apart > 5.0 * right[i].noise && inside_out.below == inside_out.count);
        assert_true(unturned.apart > 5.0 * right[i].noise);
        assert_true(too_long.apart > 5.0 * right[i].noise && too_long.too_long == too_long.count);
        // 1.3 times as long: the surface's mean reach is the noise over its share of it
        assert_within(too_long.outwards, 0.3 * right[i].noise / NOISE, 0.015, "points too far out");
    }
}

// What is no direction at all is counted, and makes no point.
TEST(nothing_and_no_number_are_left_out)
{
    LobeCounts counts;
    Vertices cloud = {.items = NULL};
    steps_play(PLAY_DEFAULT);
    Lobe lobe = lobe_of(20, 60, false, PLAY_DEFAULT);
    Findings samples = samples_of(&lobe, RIGHT);
    LobeSample *items = samples.items;
    size_t sound = 0;
    for (size_t i = 0; i < SAMPLES; i++) {
        if (i % 10 == 0)
            items[i].direction = i % 20 ? vec3(NAN, 0, 1) : vec3(0, 0, 0);
        else
            sound += items[i].weight > 0.0f;
    }
    lobe_cloud(&lobe, &samples, &counts, &cloud);
    assert_int_equal(cloud.count, sound);
    assert_int_equal(counts.not_unit, SAMPLES - counts.absorbed - sound);
    for (size_t i = 0; i < cloud.count; i++)
        assert_true(isfinite(cloud.items[i].x + cloud.items[i].y + cloud.items[i].z));
    vertices_free(&cloud);
}
