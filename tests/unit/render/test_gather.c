// Final gathering in surroundings whose answer can be written down.
#include "unit/test_common.h"

#include "render/final_gather.h"

// A closed room of one matt surface; above it another of two colours in halves, red to the left and blue to the right.
#define LIGHT     "lights:\n  - {type: point, position: [0, 0.9, 0], power: [1, 1, 1]}\n"
#define ROOM_HEAD "camera: {position: [0, 0.5, 0], target: [0, 0, 0.001], up: [0, 0, 1], vertical_fov: 40}\n" LIGHT
#define GREY_ROOM                                                                                                      \
    ROOM_HEAD "materials:\n  - {name: grey, type: diffuse, reflectance: [0.5, 0.4, 0.3]}\n"                            \
              "shapes:\n  - {type: box, low: [-1, 0, -1], high: [1, 2, 1], material: grey}\n"
#define HALVES                                                                                                         \
    ROOM_HEAD                                                                                                          \
    "materials:\n  - {name: white, type: diffuse, reflectance: [1, 1, 1]}\n"                                           \
    "  - {name: black, type: diffuse, reflectance: [0, 0, 0]}\n"                                                       \
    "shapes:\n  - {type: rectangle, corner: [-9, 1, -9], edge_u: [9, 0, 0], edge_v: [0, 0, 18], material: black}\n"    \
    "  - {type: rectangle, corner: [0, 1, -9], edge_u: [9, 0, 0], edge_v: [0, 0, 18], material: white}\n"              \
    "  - {type: rectangle, corner: [-9, 0, -9], edge_u: [0, 0, 18], edge_v: [18, 0, 0], material: black}\n"

typedef struct {
    Scene *scene;
    RenderOptions options;
    FinalGather final;
    Eye eye;
} Gathering;

FREED_AT_END(own_ends, IrradianceMap, irradiance_map_free)
FREED_AT_END(own_cache, IrradianceCache, irradiance_cache_free)

// Irradiance 1, 2, 3 W/m² wherever a gather ray ends.
static void begin(Gathering *g, const char *text)
{
    *g = (Gathering){.scene = scene_from_text(text), .options = {.glass_sides = 2}};
    g->options.settings.depth = 32;
    g->final = (FinalGather){own_ends(irradiance_map_uniform((Colour){1, 2, 3})),
                             own_cache(irradiance_cache_create(GATHER_ACCURACY, 4.0f)), 4.0f, 1e-4f};
    g->eye = (Eye){.scene = g->scene, .options = &g->options, .final = &g->final, .rng = rng_create(1, 1)};
}

static IrradianceEstimate estimate_at(Gathering *g, float x)
{
    Hit hit;
    Ray down = {vec3(x, 0.5f, 0), vec3(0, -1, 0), NO_PRIMITIVE};
    assert_true(scene_intersect(g->scene, &down, &hit));
    IrradianceEstimate estimate;
    irradiance_estimate_make(&g->eye, &hit, vec3(0, 1, 0), 0.5f, &estimate);
    return estimate;
}

// L = ρE/π comes from everywhere: E = πL, and nothing changes along the floor.
TEST(uniform_surroundings_give_pi_l)
{
    Gathering g;
    begin(&g, GREY_ROOM);
    IrradianceEstimate estimate = estimate_at(&g, 0.0f);
    static const double expected[3] = {0.5 * 1, 0.4 * 2, 0.3 * 3};
    for (int c = 0; c < 3; c++) {
        assert_within((double)colour_channel(estimate.irradiance, c), expected[c], 1e-5, "E");
        assert_within((double)vec3_length(estimate.translation[c]), 0.0, 1e-4, "slope along the floor");
    }
}

// Under a ceiling at height 1, white for x > 0 and black for x < 0, E = ½(1 + x/√(1+x²))·ρE₀; its slope at x = 0 is
// ½. 432 rays of which each is black or white: a standard error of 2 % of E, and more of the slope: mean of 64.
TEST(slope_under_a_ceiling_of_two_halves)
{
    Gathering g;
    begin(&g, HALVES);
    double slope = 0.0, across = 0.0, value = 0.0;
    for (int i = 0; i < 64; i++) {
        IrradianceEstimate estimate = estimate_at(&g, 0.0f);
        value += (double)estimate.irradiance.r / 64;
        slope += (double)estimate.translation[0].x / 64;
        across += (double)estimate.translation[0].z / 64;
    }
    assert_within(value, 0.5, 0.01, "E between the halves");
    assert_within(slope, 0.5, 0.05, "slope across the edge");
    assert_within(across, 0.0, 0.05, "slope along the edge");
}

// An estimate serves within accuracy × reach, and where the normal is the same.
TEST(an_estimate_serves_as_far_as_it_reaches)
{
    IrradianceCache *cache = own_cache(irradiance_cache_create(0.25f, 4.0f));
    IrradianceEstimate estimate = {
        .position = vec3(0.3f, 0, 0.1f), .normal = vec3(0, 1, 0), .irradiance = {1, 2, 3}, .reach = 0.4f};
    assert_true(irradiance_cache_add(cache, &estimate));
    Colour found;
    for (int degrees = 0; degrees < 360; degrees += 15) {
        Vec3 way = vec3(cosf((float)degrees * PI / 180), 0, sinf((float)degrees * PI / 180));
        assert_true(irradiance_cache_find(cache, vec3_along(estimate.position, way, 0.098f), vec3(0, 1, 0), &found));
        assert_within((double)found.g, 2.0, 1e-6, "irradiance");
        assert_false(irradiance_cache_find(cache, vec3_along(estimate.position, way, 0.102f), vec3(0, 1, 0), &found));
    }
    assert_false(irradiance_cache_find(cache, estimate.position, vec3(0, 0, 1), &found));
}

// However steep, no slope makes light of nothing or an explosion.
TEST(an_extrapolation_is_bounded)
{
    IrradianceEstimate estimate = {.normal = vec3(0, 1, 0), .irradiance = {1, 1, 1}, .reach = 1.0f};
    for (int c = 0; c < 3; c++)
        estimate.translation[c] = vec3(1e6f, 0, 0);
    Colour up = irradiance_extrapolate(&estimate, vec3(0.1f, 0, 0), vec3(0, 1, 0));
    Colour down = irradiance_extrapolate(&estimate, vec3(-0.1f, 0, 0), vec3(0, 1, 0));
    assert_within((double)up.r, 1.6, 1e-6, "upwards");
    assert_within((double)down.r, 0.5, 1e-6, "downwards");
}

// No photon lands, so there is no cell to look in.
TEST(a_picture_without_photons_is_dark)
{
    Scene *scene = scene_from_text(
        "camera: {position: [0, 0.5, 0], target: [0, 0, 0.001], up: [0, 0, 1], vertical_fov: 40}\n"
        "lights:\n  - {type: beam, position: [0, 2, 0], target: [0, 3, 0], radius: 0.1, power: [1, 1, 1]}\n"
        "materials:\n  - {name: grey, type: diffuse, reflectance: [0.5, 0.4, 0.3]}\n"
        "shapes:\n  - {type: rectangle, corner: [-1, 0, -1], edge_u: [0, 0, 2], edge_v: [2, 0, 0], material: grey}\n"
        "  - {type: rectangle, corner: [-1, 1, -1], edge_u: [2, 0, 0], edge_v: [0, 0, 2], material: grey}\n");
    RenderOptions options = {.integrator = INTEGRATOR_GATHER, .settings = scene->settings, .glass_sides = 2};
    Image image;
    RenderStats stats;
    options.settings.width = options.settings.height = 2;
    options.settings.photons = 10;
    assert_true(render_image(scene, &options, &image, &stats, &said));
    assert_int_equal(stats.photons_stored, 0);
    assert_true(image.pixels[0].r == 0.0f);
    image_free(&image);
}
