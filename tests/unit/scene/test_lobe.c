// The reference steps of stage 2: the lobe, its turning, and the two glossy bounces.
#include "unit/test_common.h"

static const float exponents[] = {0, 1, 5, 20, 100, 1000};

// Density (n+1)/(2π)·cosⁿα: cosα^(n+1) and the azimuth are uniform. Tested with the cosine as well as with
// what x and y say it is, since that is where digits get lost for large n.
TEST(sample_lobe_has_its_density)
{
    enum { SIDE = 16, BINS = SIDE * SIDE, COUNT = 200 * BINS };
    for (int k = 0; k < 6; k++) {
        double n1 = (double)exponents[k] + 1.0;
        long by_z[BINS] = {0}, by_xy[BINS] = {0};
        Rng rng = rng_create(21, (uint64_t)k);
        for (int i = 0; i < COUNT; i++) {
            Vec3 d = steps.sample_lobe(exponents[k], &rng);
            assert_true(d.z > 0.0f);
            assert_within(vec3_length(d), 1.0, 1e-6, "length");
            double sin2 = fmin(1.0, (double)d.x * d.x + (double)d.y * d.y);
            double from_z = pow(d.z, n1), from_xy = pow(1.0 - sin2, 0.5 * n1);
            double turn = atan2(d.y, d.x) / (2.0 * M_PI) + 0.5;
            int column = (int)fmin(turn * SIDE, SIDE - 1);
            by_z[(int)fmin(from_z * SIDE, SIDE - 1) * SIDE + column]++;
            by_xy[(int)fmin(from_xy * SIDE, SIDE - 1) * SIDE + column]++;
        }
        assert_uniform(by_z, BINS, "lobe, by z");
        assert_uniform(by_xy, BINS, "lobe, by x and y");
    }
}

// The sine of the angle to the axis keeps its digits close to it. For n = 1e6 it is about 1e-3 and cosα a
// number next to 1 in single precision; 1 − cos²α would take a handful of values only.
TEST(sample_lobe_of_a_huge_exponent)
{
    enum { BINS = 50, COUNT = 200 * BINS };
    long counts[BINS] = {0};
    Rng rng = rng_create(22, 0);
    for (int i = 0; i < COUNT; i++) {
        Vec3 d = steps.sample_lobe(1e6f, &rng);
        double sin2 = (double)d.x * d.x + (double)d.y * d.y;
        counts[(int)fmin(pow(1.0 - sin2, 0.5 * (1e6 + 1.0)) * BINS, BINS - 1)]++;
    }
    assert_uniform(counts, BINS, "lobe of a huge exponent");
}

static void assert_turned(Vec3 axis)
{
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Vec3 turned[3];
    for (int i = 0; i < 3; i++)
        turned[i] = steps.turn_to(unit[i], axis);
    assert_within(angle_between(turned[2], axis), 0.0, 1e-4, "+z goes to the axis");
    for (int i = 0; i < 3; i++) {
        assert_within(vec3_length(turned[i]), 1.0, 2e-6, "length");
        assert_within(vec3_dot(turned[i], turned[(i + 1) % 3]), 0.0, 2e-6, "right angle");
    }
    // Linear, so that all lengths and angles stay.
    Vec3 local = vec3(0.36f, -0.48f, 0.8f), sum = vec3_scale(turned[0], local.x);
    sum = vec3_along(vec3_along(sum, turned[1], local.y), turned[2], local.z);
    assert_within(vec3_length(vec3_sub(steps.turn_to(local, axis), sum)), 0.0, 2e-6, "any other direction");
}

TEST(turn_to_keeps_lengths_and_angles)
{
    Rng rng = rng_create(23, 0);
    for (int i = 0; i < 10000; i++)
        assert_turned(random_direction(&rng));
    for (int sign = -1; sign <= 1; sign += 2) {
        assert_turned(vec3((float)sign, 0, 0));
        assert_turned(vec3(0, (float)sign, 0));
        assert_turned(vec3(0, 0, (float)sign));
        for (float off = 1e-8f; off < 0.1f; off *= 3.0f) { // beside the poles, where shortcuts divide by nearly 0
            assert_turned(vec3_normalize(vec3(off, 0, (float)sign)));
            assert_turned(vec3_normalize(vec3(-off, off, (float)sign)));
        }
    }
}

// ---- the density of the source text's bounce, over bins of equal solid angle
#define ROWS    24 // of cosθ
#define COLUMNS 24 // of azimuth
#define FINE    24 // midpoints a side for the integral over a bin

// p(ω) of step 2.3 for mirror direction `mirror` (in the xz-plane), normal +z; I_P from data of the material's tests.
static double source_text_density(Vec3 mirror, double exponent, double above, double x, double z)
{
    double cos_alpha = (double)mirror.x * x + (double)mirror.z * z;
    if (cos_alpha <= 0.0)
        return z / M_PI;
    return 0.5 * (1.0 + (double)mirror.z) * pow(cos_alpha, exponent) / above;
}

static void expect_source_text(double *expected, Vec3 mirror, double exponent, double above, double count)
{
    double solid_angle = 2.0 * M_PI / (ROWS * FINE * COLUMNS * FINE);
    for (int i = 0; i < ROWS * FINE; i++) {
        double z = (i + 0.5) / (ROWS * FINE), r = sqrt(1.0 - z * z);
        for (int j = 0; j < COLUMNS * FINE; j++) {
            double x = r * cos(2.0 * M_PI * (j + 0.5) / (COLUMNS * FINE));
            expected[i / FINE * COLUMNS + j / FINE] +=
                count * solid_angle * source_text_density(mirror, exponent, above, x, z);
        }
    }
}

// Against p = P·cosⁿα/I_P on the mirror's side and cosθ_o/π beyond, P = (1+cosθ)/2. I_P at θ = 60° and 80°:
// Arvo (1995), Mallett & Yuksel (2020), checked by quadrature.
TEST(source_text_has_its_density)
{
    static const struct {
        float exponent, theta;
        double above;
    } cases[] = {{0, 60, 4.188790}, {1, 60, 2.356194},  {5, 60, 0.938796},  {20, 60, 0.296938},
                 {1, 80, 1.843562}, {20, 80, 0.235151}, {20, 30, 0.299199}, {50, 45, 0.123200}};
    const Vec3 normal = {0, 0, 1};
    for (int k = 0; k < 8; k++) {
        enum { BINS = ROWS * COLUMNS, COUNT = 400000 };
        long counts[BINS] = {0};
        double expected[BINS] = {0};
        Vec3 mirror = tilted(cases[k].theta), in = vec3(mirror.x, 0, -mirror.z);
        Rng rng = rng_create(24, (uint64_t)k);
        for (int i = 0; i < COUNT; i++) {
            Vec3 out;
            float weight = 0.0f;
            assert_true(steps.scatter_glossy_source_text(in, normal, cases[k].exponent, &rng, &out, &weight));
            assert_true(weight == 1.0f && out.z >= 0.0f);
            double turn = atan2(out.y, out.x) / (2.0 * M_PI);
            int column = (int)fmin((turn < 0.0 ? turn + 1.0 : turn) * COLUMNS, COLUMNS - 1);
            counts[(int)fminf(out.z * ROWS, ROWS - 1) * COLUMNS + column]++;
        }
        expect_source_text(expected, mirror, cases[k].exponent, cases[k].above, COUNT);
        assert_chi_square(counts, expected, BINS, "source text's glossy bounce");
    }
    assert_int_equal(redraw_cap_count(), 0); // the normal faced the photon throughout
}

// However narrow the lobe, (1 − cosθ)/2 of the photons are scattered diffusely, far from it.
TEST(source_text_leaks)
{
    for (int theta = 0; theta <= 80; theta += 20) {
        Vec3 mirror = tilted(theta), out;
        float weight;
        Rng rng = rng_create(25, (uint64_t)theta);
        long leaked = 0, count = 100000;
        for (long i = 0; i < count; i++) {
            assert_true(steps.scatter_glossy_source_text(vec3(mirror.x, 0, -mirror.z), vec3(0, 0, 1), 1000, &rng, &out,
                                                         &weight));
            leaked += vec3_dot(out, mirror) <= 0.0f;
        }
        assert_share(leaked, count, 0.5 * (1.0 - cos(theta / DEGREES)), "leak beside the lobe");
    }
}

// A normal that does not face the photon hides the lobe below the surface: the redraws stop, and are counted.
TEST(source_text_gives_up_audibly)
{
    Vec3 away = tilted(60), out; // flies with the normal: its mirror direction points into the surface
    float weight;
    Rng rng = rng_create(26, 0);
    long before = redraw_cap_count(), refused = 0;
    for (int i = 0; i < 200; i++)
        refused += !steps.scatter_glossy_source_text(away, vec3(0, 0, 1), 1000, &rng, &out, &weight);
    assert_in_range(refused, 20,
                    80); // (1 − cos 60°)/2 = a quarter of the diffuse draws lie on the mirror's side
    assert_int_equal(redraw_cap_count() - before, refused);
}

// Share of lobe samples above the surface, (n+1)/(2π)·I_P, and mean weight, (n+2)/(2π)·I_M: the modified Phong albedo.
TEST(phong_bounce_has_its_albedo)
{
    static const struct {
        float exponent, theta;
        double accept, albedo;
    } cases[] = {
        {0, 0, 1.000000, 1.000000},     {0, 60, 0.666667, 0.750000},    {1, 30, 0.933013, 0.880843},
        {1, 80, 0.586824, 0.409945},    {5, 60, 0.896484, 0.519407},    {5, 89, 0.516358, 0.178621},
        {20, 45, 0.999919, 0.707110},   {20, 80, 0.785934, 0.200342},   {100, 75, 0.995852, 0.258945},
        {100, 80, 0.960300, 0.175233},  {500, 85, 0.974623, 0.087584},  {1000, 60, 1.000000, 0.500000},
        {1000, 85, 0.997128, 0.087183}, {1000, 89, 0.709551, 0.023212},
    };
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        Vec3 mirror = tilted(cases[k].theta), in = vec3(mirror.x, 0, -mirror.z), out;
        Rng rng = rng_create(27, k);
        Mean mean = {0};
        long accepted = 0, count = 200000;
        for (long i = 0; i < count; i++) {
            float weight = 0.0f;
            bool above = steps.scatter_glossy_phong(in, vec3(0, 0, 1), cases[k].exponent, &rng, &out, &weight);
            accepted += above;
            assert_true(!above || out.z > 0.0f);
            mean_add(&mean, above ? weight : 0.0f);
        }
        assert_share(accepted, count, fmin(1.0, cases[k].accept), "share of the lobe above the surface");
        assert_mean(&mean, cases[k].albedo, "albedo");
    }
}

// Above the surface the directions are those of the lobe itself: (cosα)^(n+1) is uniform where the whole lobe is.
TEST(phong_bounce_goes_into_the_lobe)
{
    enum { BINS = 50, COUNT = 100000 };
    Vec3 normal = {0.48f, 0.64f, 0.6f}, in = vec3(0, 0, -1), out;
    Vec3 mirror = vec3(2.0f * 0.6f * normal.x, 2.0f * 0.6f * normal.y, 2.0f * 0.6f * normal.z - 1.0f);
    long counts[BINS] = {0};
    Rng rng = rng_create(28, 0);
    for (int i = 0; i < COUNT; i++) {
        float weight;
        assert_true(steps.scatter_glossy_phong(in, normal, 200, &rng, &out, &weight));
        assert_within(weight, 202.0 / 201.0 * (double)vec3_dot(out, normal), 1e-5, "weight");
        counts[(int)fmin(pow(cos(angle_between(out, mirror) / DEGREES), 201.0) * BINS, BINS - 1)]++;
    }
    assert_uniform(counts, BINS, "directions of the Phong bounce");
}

AROUND_TESTS(load_reference_steps, NULL)
