// What an eye ray brings back, on scenes so small that the answer can be written down. Every picture is one pixel seen
// through a needle of 0.01°: one direction, many samples.
#include "unit/test_common.h"

#define NEEDLE "vertical_fov: 0.01}\n"
#define GLASS  "materials:\n  - {name: glass, type: glass, index: 1.5}\n"

static Colour look_through(const Scene *scene, RenderOptions options)
{
    options.settings.width = options.settings.height = 1;
    options.settings.photons = 1000;
    options.seed = 1;
    options.threads = 1;
    Image image = picture_of(scene, &options);
    return *image_at(&image, 0, 0);
}

static Colour look(const char *text, Integrator integrator, int glass_sides, int depth, int samples)
{
    Scene *scene = scene_from_text(text);
    RenderOptions options = {.integrator = integrator, .glass_sides = glass_sides, .reuse = REUSE_DEFAULT};
    options.settings = (RenderSettings){.samples = samples, .k = 20, .depth = depth};
    return look_through(scene, options);
}

static void assert_colour(Colour value, double r, double g, double b, double relative, const char *what)
{
    assert_within((double)value.r, r, relative * r + 1e-6, what);
    assert_within((double)value.g, g, relative * g + 1e-6, what);
    assert_within((double)value.b, b, relative * b + 1e-6, what);
}

// Radiance of each channel by both integrators, which takes the path tracer this many samples for its tolerance.
static void both_see(const char *text, int depth, const double L[3], int samples, double tolerance, const char *what)
{
    for (int path = 0; path < 2; path++) {
        Colour seen = look(text, path ? INTEGRATOR_PATH : INTEGRATOR_PHOTONS, 2, depth, path ? samples : 4);
        assert_colour(seen, L[0], L[1], L[2], path ? tolerance : 1e-5,
                      words("%s, %s", what, path ? "path" : "photons"));
    }
}

static double fresnel_head_on(double n)
{
    return (n - 1.0) * (n - 1.0) / ((n + 1.0) * (n + 1.0));
}

// ---- radiance changes by n² where it enters glass or leaves it

// From the middle of a ball of glass all rays leave head on. At depth 1 what is reflected inside is cut, and
// L = n²(1−F)L₀ remains. The path tracer reflects a ray with probability F = 0.04: a standard error of
// √(F/(1−F)/4096) = 0.3 %.
#define INSIDE_GLASS                                                                                                   \
    "camera: {position: [0, 0, 0], target: [0, 0, 1], " NEEDLE                                                         \
    "lights:\n  - {type: rectangle, corner: [-1, -1, 3], edge_u: [0, 2, 0], edge_v: [2, 0, 0], radiance: [1, 2, 3]}\n" \
    "shapes:\n  - {type: sphere, centre: [0, 0, 0], radius: 1, material: glass}\n"

TEST(looking_out_of_glass)
{
    double share = 1.5 * 1.5 * (1.0 - fresnel_head_on(1.5));
    both_see(INSIDE_GLASS GLASS, 1, (double[]){share, 2 * share, 3 * share}, 4096, 0.012, "n²(1−F)L");
}

// Each colour has its own n. The path tracer follows one of the three, which counts three times: a standard error of
// √(3−1)/√16384 = 1.1 %.
TEST(looking_out_of_dispersing_glass)
{
    static const char text[] = INSIDE_GLASS "materials:\n  - {name: glass, type: glass, indices: [1.3, 1.6, 2.2]}\n";
    double share[3];
    static const double n[3] = {1.3, 1.6, 2.2};
    for (int c = 0; c < 3; c++)
        share[c] = (c + 1) * n[c] * n[c] * (1.0 - fresnel_head_on(n[c]));
    both_see(text, 1, share, 16384, 0.04, "n²(1−F)L of each colour");
}

// The other way round: a lamp in the glass, L = (1−F)L₀/n².
TEST(looking_into_glass)
{
    static const char text[] = "camera: {position: [0, 0, 3], target: [0, 0, 0], " NEEDLE GLASS "shapes:\n"
                               "  - {type: sphere, centre: [0, 0, 0], radius: 1, material: glass}\n"
                               "lights:\n"
                               "  - {type: rectangle, corner: [-0.1, -0.1, 0], edge_u: [0.2, 0, 0], "
                               "edge_v: [0, 0.2, 0], radiance: [1, 2, 3]}\n";
    double share = (1.0 - fresnel_head_on(1.5)) / (1.5 * 1.5);
    both_see(text, 8, (double[]){share, 2 * share, 3 * share}, 4096, 0.012, "(1−F)L/n²");
}

// ---- glass with one side (--glass-sides 1) and with two

// A slab of glass from y = −1 to 0, looked at under 60° where x = 0: sinθ_t = sin60°/1.5 = 1/√3, tanθ_t = 1/√2. The
// needle's width moves what it sees by 1 part in 10⁴.
#define ONTO_SLAB "camera: {position: [-1.7320508, 1, 0], target: [0, 0, 0], " NEEDLE GLASS
#define SLAB      "shapes:\n  - {type: box, low: [-9, -1, -1], high: [9, 0, 1], material: glass}\n"
// A small lamp in the plane of this height around x, shining up or down.
#define LAMP_UP(low_x, y)   "  - {type: rectangle, corner: [" low_x ", " y ", -0.1], edge_u: [0, 0, 0.2], " LAMP_LAST
#define LAMP_DOWN(low_x, y) "  - {type: rectangle, corner: [" low_x ", " y ", 0.1], edge_u: [0, 0, -0.2], " LAMP_LAST
#define LAMP_LAST           "edge_v: [0.2, 0, 0], radiance: [1, 2, 3]}\n"

// Unpolarised reflectance for θ_i = 60°, n = 1.5.
static double fresnel_at_60(void)
{
    double cos_t = sqrt(2.0 / 3.0);
    double s = (0.5 - 1.5 * cos_t) / (0.5 + 1.5 * cos_t);
    double p = (cos_t - 1.5 * 0.5) / (cos_t + 1.5 * 0.5);
    return 0.5 * (s * s + p * p);
}

// One metre below the slab a ray that was bent once is at x = 2/√2 = 1.414; one that was bent back is at 1/√2 + √3 =
// 2.439. With one side L = (1−F)L₀ and no n²; with two (1−F)²L₀; what takes more turns inside comes down elsewhere.
TEST(one_side_bends_at_the_front_only)
{
    static const char bent_once[] = ONTO_SLAB "lights:\n" LAMP_UP("1.314", "-2") SLAB;
    static const char bent_back[] = ONTO_SLAB "lights:\n" LAMP_UP("2.339", "-2") SLAB;
    double through = 1.0 - fresnel_at_60();
    Colour seen = look(bent_once, INTEGRATOR_PHOTONS, 1, 8, 16);
    assert_colour(seen, through, 2 * through, 3 * through, 1e-3, "one side, bent once");
    assert_colour(look(bent_back, INTEGRATOR_PHOTONS, 1, 8, 16), 0, 0, 0, 0, "one side is not bent back");
    assert_colour(look(bent_once, INTEGRATOR_PHOTONS, 2, 8, 16), 0, 0, 0, 0, "two sides do not bend once");
    through *= through;
    seen = look(bent_back, INTEGRATOR_PHOTONS, 2, 8, 16);
    assert_colour(seen, through, 2 * through, 3 * through, 1e-3, "two sides, bent and bent back");
}

// What the front reflects goes through x = √3 at a height of 1; what the back reflects comes out at x = 2/√2 and goes
// through √2 + √3 = 3.146 there (unbent: 3/√2 = 2.121). With two sides that is F(1−F)²L₀, found by roulette: a standard error of 0.7/√16384.
TEST(one_side_reflects_at_the_front_only)
{
    static const char front[] = ONTO_SLAB "lights:\n" LAMP_DOWN("1.632", "1") SLAB;
    static const char back[] = ONTO_SLAB "lights:\n" LAMP_DOWN("3.046", "1") SLAB;
    static const char unbent[] = ONTO_SLAB "lights:\n" LAMP_DOWN("2.021", "1") SLAB;
    double F = fresnel_at_60();
    for (int sides = 1; sides <= 2; sides++)
        assert_colour(look(front, INTEGRATOR_PHOTONS, sides, 8, 16), F, 2 * F, 3 * F, 1e-3, "the front reflects");
    assert_colour(look(back, INTEGRATOR_PHOTONS, 1, 8, 256), 0, 0, 0, 0, "with one side the back reflects nothing");
    assert_colour(look(unbent, INTEGRATOR_PHOTONS, 1, 8, 256), 0, 0, 0, 0, "not even to come out unbent");
    double reflected = F * (1 - F) * (1 - F);
    Colour seen = look(back, INTEGRATOR_PHOTONS, 2, 8, 16384);
    assert_colour(seen, reflected, 2 * reflected, 3 * reflected, 0.03, "with two sides the back reflects");
}

// From inside, under 60°: beyond the critical angle. One side lets it straight through, and takes nothing.
TEST(one_side_has_no_total_reflection)
{
    static const char text[] = "camera: {position: [0, -0.5, 0], target: [0.8660254, 0, 0], " NEEDLE GLASS
                               "lights:\n" LAMP_DOWN("2.498", "1") SLAB;
    assert_colour(look(text, INTEGRATOR_PHOTONS, 1, 8, 16), 1, 2, 3, 1e-5, "straight through");
    assert_colour(look(text, INTEGRATOR_PHOTONS, 2, 8, 16), 0, 0, 0, 0, "total reflection");
}

// ---- the depth limit

// Between two mirrors, a metre apart, under 45°: three reflections, then the lamp at the end.
TEST(depth_ends_a_path_between_mirrors)
{
    static const char text[] =
        "camera: {position: [0, 0.5, 0], target: [0.5, 0, 0], " NEEDLE
        "materials:\n  - {name: mirror, type: mirror, reflectance: [0.9, 0.8, 0.7]}\n"
        "lights:\n  - {type: rectangle, corner: [3, 0, -1], edge_u: [0, 0, 2], edge_v: [0, 1, 0], "
        "radiance: [1, 1, 1]}\n"
        "shapes:\n"
        "  - {type: rectangle, corner: [-1, 0, -1], edge_u: [0, 0, 2], edge_v: [4, 0, 0], material: mirror}\n"
        "  - {type: rectangle, corner: [-1, 1, -1], edge_u: [4, 0, 0], edge_v: [0, 0, 2], material: mirror}\n";
    static const Integrator all[] = {INTEGRATOR_PHOTONS, INTEGRATOR_PHOTONS_ONLY, INTEGRATOR_PATH};
    for (int i = 0; i < 3; i++) {
        for (int depth = 1; depth < 3; depth++)
            assert_colour(look(text, all[i], 2, depth, 4), 0, 0, 0, 0, "the limit comes before the lamp");
        for (int depth = 3; depth < 5; depth++)
            assert_colour(look(text, all[i], 2, depth, 4), 0.729, 0.512, 0.343, 1e-5, "ρ³L after three mirrors");
    }
}

// ---- step 1.6 shows

static Colour (*right_estimate)(const PhotonMap *map, const Hit *hit, Vec3 wo, Gather *gather);

// As a student may write it first: irradiance/π, with the reflectance forgotten.
static Colour estimate_without_reflectance(const PhotonMap *map, const Hit *hit, Vec3 wo, Gather *gather)
{
    static const Material white = {.type = MATERIAL_DIFFUSE, .diffuse = {1.0f, 1.0f, 1.0f}};
    Hit on_white = *hit;
    on_white.material = &white;
    return right_estimate(map, &on_white, wo, gather);
}

// A box whose floor a spot lights, and a camera that looks at the ceiling: all that it sees is indirect light, so the
// picture must become brighter by 1/ρ, in each channel, whether estimates are reused or not.
TEST(a_wrong_estimate_shows)
{
    Scene *scene = scene_from_text(
        "camera: {position: [0, -0.5, 0], target: [0.1, 1, 0], up: [0, 0, 1], vertical_fov: 40}\n"
        "materials:\n  - {name: matt, type: diffuse, reflectance: [0.8, 0.5, 0.25]}\n"
        "lights:\n  - {type: spot, position: [0, 0.5, 0], target: [0, -1, 0], angle: 20, power: [1, 2, 3]}\n"
        "shapes:\n  - {type: box, low: [-1, -1, -1], high: [1, 1, 1], material: matt}\n");
    static const Integrator both[] = {INTEGRATOR_PHOTONS, INTEGRATOR_PHOTONS_ONLY};
    static const float reuse[] = {0.0f, REUSE_DEFAULT};
    right_estimate = steps.estimate_radiance;
    for (int i = 0; i < 4; i++) {
        RenderOptions options = {.integrator = both[i % 2], .glass_sides = 2, .reuse = reuse[i / 2]};
        options.settings = (RenderSettings){.samples = 16, .k = 30, .depth = 8};
        Colour right = look_through(scene, options);
        steps.estimate_radiance = estimate_without_reflectance;
        Colour wrong = look_through(scene, options);
        steps.estimate_radiance = right_estimate;
        assert_true(right.r > 0.0f && right.g > 0.0f && right.b > 0.0f);
        assert_colour(wrong, right.r / 0.8, right.g / 0.5, right.b / 0.25, 1e-4, "the right picture over ρ");
    }
}
