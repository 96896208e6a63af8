// When the eye pass may use an estimate again: within reach, on the same flat piece of one material.
#include "unit/test_common.h"

#include "render/radiance_cache.h"

static const Vec3 up = {0.0f, 1.0f, 0.0f};
static const Material red_paint, blue_paint;

static void add(RadianceCache *cache, Vec3 position, float reach, const Material *material, Colour radiance)
{
    CachedRadiance entry = {.position = position, .normal = up, .reach = reach, .radiance = radiance};
    entry.material = material;
    radiance_cache_add(cache, &entry);
}

// A cache with one estimate at the origin of a red floor, to be used up to 2 m away.
static RadianceCache cache_of_one(float radiance)
{
    RadianceCache cache;
    radiance_cache_clear(&cache);
    add(&cache, vec3(0, 0, 0), 2.0f, &red_paint, colour(radiance, 2 * radiance, 3 * radiance));
    return cache;
}

// Red of what the cache has for this place on red paint; −1: nothing.
static float found_at(const RadianceCache *cache, Vec3 position, Vec3 normal)
{
    Colour radiance;
    return radiance_cache_find(cache, position, normal, &red_paint, &radiance) ? radiance.r : -1.0f;
}

TEST(within_reach)
{
    RadianceCache cache = cache_of_one(1.0f);
    Colour found;
    assert_true(radiance_cache_find(&cache, vec3(1.98f, 0, 0), up, &red_paint, &found));
    assert_within((double)found.r, 1.0, 1e-6, "red");
    assert_within((double)found.g, 2.0, 1e-6, "green");
    assert_within((double)found.b, 3.0, 1e-6, "blue");
    assert_true(found_at(&cache, vec3(2.02f, 0, 0), up) < 0.0f);
    assert_true(found_at(&cache, vec3(1.5f, 0, 1.5f), up) < 0.0f);
    // One that is out of reach takes no part where another is found.
    add(&cache, vec3(1.0f, 0, 0), 0.5f, &red_paint, colour_grey(7.0f));
    assert_within((double)found_at(&cache, vec3(0.2f, 0, 0), up), 1.0, 1e-6, "the one within reach");
    radiance_cache_clear(&cache);
    assert_true(found_at(&cache, vec3(0, 0, 0), up) < 0.0f);
}

// Two plates 0.5 m apart, both facing up, one in the light and one in the other's shadow: each keeps its own.
TEST(not_on_a_parallel_plate)
{
    RadianceCache cache = cache_of_one(10.0f);
    assert_true(found_at(&cache, vec3(0, -0.5f, 0), up) < 0.0f);
    assert_true(found_at(&cache, vec3(1.0f, 0.5f, 0), up) < 0.0f);
    add(&cache, vec3(0, -0.5f, 0), 2.0f, &red_paint, colour_grey(1.0f));
    assert_within((double)found_at(&cache, vec3(0.5f, 0, 0), up), 10.0, 1e-5, "in the light");
    assert_within((double)found_at(&cache, vec3(0.5f, -0.5f, 0), up), 1.0, 1e-6, "in the shadow");
    // A curved surface never lies quite in the plane.
    assert_within((double)found_at(&cache, vec3(0.5f, 0.02f, 0), up), 10.0, 1e-5, "just above");
}

TEST(not_round_a_corner)
{
    RadianceCache cache = cache_of_one(1.0f);
    Vec3 slightly = {sinf(5.0f * PI / 180.0f), cosf(5.0f * PI / 180.0f), 0};
    Vec3 clearly = {sinf(20.0f * PI / 180.0f), cosf(20.0f * PI / 180.0f), 0};
    assert_true(found_at(&cache, vec3(0, 0, 0.1f), slightly) > 0.0f);
    assert_true(found_at(&cache, vec3(0, 0, 0.1f), clearly) < 0.0f);
    assert_true(found_at(&cache, vec3(0, 0, 0.1f), vec3(1, 0, 0)) < 0.0f);
    assert_true(found_at(&cache, vec3(0, 0, 0.1f), vec3(0, -1, 0)) < 0.0f); // the other side of the same sheet
}

TEST(not_on_another_material)
{
    RadianceCache cache = cache_of_one(1.0f);
    Colour found;
    assert_false(radiance_cache_find(&cache, vec3(0.1f, 0, 0), up, &blue_paint, &found));
    add(&cache, vec3(0, 0, 0), 2.0f, &blue_paint, colour_grey(7.0f));
    assert_true(radiance_cache_find(&cache, vec3(0.1f, 0, 0), up, &blue_paint, &found));
    assert_within((double)found.r, 7.0, 1e-5, "blue paint");
    assert_within((double)found_at(&cache, vec3(0.1f, 0, 0), up), 1.0, 1e-6, "red paint");
}

// At a quarter of one's reach and half of the other's: weights 3/4 and 1/2.
TEST(nearer_estimates_count_more)
{
    RadianceCache cache = cache_of_one(1.0f);
    add(&cache, vec3(1.0f, 0, 0), 1.0f, &red_paint, colour_grey(6.0f));
    double mean = (0.75 * 1.0 + 0.5 * 6.0) / 1.25;
    assert_within((double)found_at(&cache, vec3(0.5f, 0, 0), up), mean, 1e-5, "weighted mean");
}

// More than it has room for: the first stay, the last is dropped, and what lies behind is not written on.
TEST(a_full_cache_keeps_what_it_has)
{
    struct {
        RadianceCache cache;
        unsigned char behind[sizeof(CachedRadiance)];
    } guarded;
    memset(&guarded, 0x5a, sizeof guarded);
    radiance_cache_clear(&guarded.cache);
    for (int i = 0; i <= RADIANCE_CACHE_CAPACITY; i++)
        add(&guarded.cache, vec3(10.0f * (float)i, 0, 0), 1.0f, &red_paint, colour_grey((float)i));
    assert_int_equal(guarded.cache.count, RADIANCE_CACHE_CAPACITY);
    for (size_t i = 0; i < sizeof guarded.behind; i++)
        assert_int_equal(guarded.behind[i], 0x5a);
    for (int i = 0; i < RADIANCE_CACHE_CAPACITY; i++)
        assert_true(found_at(&guarded.cache, vec3(10.0f * (float)i, 0, 0), up) == (float)i);
    assert_true(found_at(&guarded.cache, vec3(10.0f * RADIANCE_CACHE_CAPACITY, 0, 0), up) < 0.0f);
}
