// Pictures by passes: the rules that shrink radii, and the bytes, whatever the order in which passes are made.
#include "unit/test_common.h"

#include "render/passes/pass_file.h"

#include <unistd.h>

#define ALPHA (2.0f / 3.0f)

// Π (i + α)/(i + 1) over i = 1 … 999 is Γ(1000+α)/(Γ(1+α)·1000!), whose value is 0.110761.
TEST(radii_after_a_thousand_passes)
{
    float radius = 0.3f;
    for (int i = 1; i < 1000; i++)
        radius = steps.next_radius(radius, i, ALPHA);
    double product = exp(lgamma(1000.0 + 2.0 / 3.0) - lgamma(1.0 + 2.0 / 3.0) - lgamma(1001.0));
    assert_near(product, 0.110761, 1e-6);
    assert_near((double)(radius * radius) / 0.09, product, 1e-4 * product);
    assert_true(steps.next_radius(0.3f, 5, 1.0f) == 0.3f);
}

// Photons that always lie equally dense: the point's own rule then shrinks as the one for all passes does, and the flux that
// it keeps tells their density at every time.
TEST(both_rules_agree_where_photons_lie_evenly)
{
    const double density = 1e6, flux = 1e-6; // photons a m², W/sr of each: radiance 1
    PointStatistics point = {0.0f, 0.1f, {0.0f, 0.0f, 0.0f}};
    double first = 0.0;
    for (int pass = 1; pass <= 4096; pass++) {
        double area = (double)PI * point.radius * point.radius;
        int found = (int)lround(density * area);
        point = steps.add_photons(point, found, colour_grey((float)(found * flux)), ALPHA);
        if (pass == 64)
            first = (double)point.radius;
    }
    assert_near((double)steps.point_radiance(point, 4096).g, 1.0, 2e-3);
    assert_near(log((double)point.radius / first) / log(4096.0 / 64.0), 0.5 * (2.0 / 3.0 - 1.0), 5e-3);
}

TEST(a_pass_that_finds_nothing_changes_nothing)
{
    PointStatistics point = {0.0f, 0.1f, {0.0f, 0.0f, 0.0f}},
                    after = steps.add_photons(point, 0, colour_grey(0.0f), ALPHA);
    assert_memory_equal(&point, &after, sizeof point);
}

// ---- sums in a fixed order

static Image noise(int pass)
{
    Image image;
    assert_true(image_create(&image, 5, 3, NULL));
    Rng rng = rng_create(7, (uint64_t)pass);
    for (int i = 0; i < 15; i++)
        image.pixels[i] = colour_grey(rng_float(&rng));
    return image;
}

static void add_range(PassSums *sums, int first, int last)
{
    for (int i = first; i < last; i++)
        pass_sums_add(sums, (PassRun){i, 1, noise(i)});
}

static void move_runs(PassSums *from, PassSums *to)
{
    for (int i = 0; i < from->count; i++)
        pass_sums_add(to, from->runs[i]);
    from->count = 0;
}

TEST(any_split_gives_the_same_mean)
{
    Rng rng = rng_create(1, 1);
    for (int trial = 0; trial < 50; trial++) {
        int all = 1 + (int)(rng_u32(&rng) % 200);
        PassSums whole = {.count = 0}, joined = {.count = 0}, part = {.count = 0};
        add_range(&whole, 0, all);
        assert_true(whole.count >= 1 && whole.count <= 8);
        for (int first = 0, last; first < all; first = last) {
            last = first + 1 + (int)(rng_u32(&rng) % 40);
            last = last < all ? last : all;
            add_range(&part, first, last);
            move_runs(&part, &joined);
        }
        Image a, b;
        assert_true(pass_sums_mean(&whole, &a, NULL) && pass_sums_mean(&joined, &b, NULL));
        assert_memory_equal(a.pixels, b.pixels, 15 * sizeof(Colour));
        double sum = 0.0;
        for (int i = 0; i < all; i++) {
            Image one = noise(i);
            sum += (double)one.pixels[7].g;
            image_free(&one);
        }
        assert_near((double)a.pixels[7].g, sum / all, 1e-5);
        image_free(&a);
        image_free(&b);
        pass_sums_free(&whole);
        pass_sums_free(&joined);
    }
}

// ---- pictures

static RenderOptions small(void)
{
    RenderOptions options = {.integrator = INTEGRATOR_PHOTONS, .glass_sides = 2, .reuse = REUSE_DEFAULT, .seed = 3};
    options.settings =
        (RenderSettings){.width = 16, .height = 12, .samples = 1, .photons = FEWER(16000), .k = 40, .depth = 8};
    return options;
}

static Image by_passes(const Scene *scene, RenderOptions options, Passes passes)
{
    Image image = {0};
    RenderStats stats;
    assert_works(passes_run(scene, &options, &passes, &stats, &said) && passes_picture(&passes, &image, &said));
    passes_free(&passes);
    return *own_image(kept(&image, sizeof image));
}

static double mean_of(const Image *image)
{
    double sum = 0.0;
    for (int i = 0; i < image->width * image->height; i++)
        sum += (double)image->pixels[i].g;
    return sum / (image->width * image->height);
}

// Three ways to the same picture: k nearest, a radius for all, a radius for each pixel.
TEST(passes_converge_to_the_picture)
{
    Scene *scene = scene_from_file("scenes/box_glass.yaml");
    RenderOptions options = small();
    Image pass = by_passes(scene, options, (Passes){.last = 24, .alpha = ALPHA});
    Image pixel = by_passes(scene, options, (Passes){.last = 24, .alpha = ALPHA, .by_pixel = true});
    options.settings.photons *= 24;
    options.settings.samples = 24;
    Image once = picture_of(scene, &options);
    double expected = mean_of(&once);
    assert_near(mean_of(&pass), expected, 0.02 * expected);
    assert_near(mean_of(&pixel), expected, 0.02 * expected);
}

static bool stop_after_three(void *user, const Passes *passes)
{
    (void)user;
    return passes->done < 3;
}

// Stopped, written, read, and gone on with.
TEST(an_interrupted_picture_has_the_same_bytes)
{
    Scene *scene = scene_from_file("scenes/box_glass.yaml");
    RenderOptions options = small();
    options.settings.photons = 1000;
    for (int by_pixel = 0; by_pixel < 2; by_pixel++) {
        char path[] = "/tmp/photonlab-passes-XXXXXX";
        int file = mkstemp(path);
        assert_true(file >= 0);
        close(file);
        RenderStats stats;
        Passes first = {.last = 7, .alpha = ALPHA, .by_pixel = by_pixel, .heard = stop_after_three},
               again = {.alpha = ALPHA};
        PassOrigin origin = {"scene", "settings", "code", 1, 1, 7}, found;
        assert_true(passes_run(scene, &options, &first, &stats, &said));
        assert_int_equal(first.done, 3);
        assert_true(pass_file_write(path, &origin, &first, &said) && pass_file_read(path, &found, &again, &said));
        passes_free(&first);
        assert_int_equal(unlink(path), 0);
        assert_memory_equal(&origin.part, &found.part, 3 * sizeof(int));
        options.threads = 2;
        Image interrupted = by_passes(scene, options, again);
        options.threads = 1;
        Image whole = by_passes(scene, options, (Passes){.last = 7, .alpha = ALPHA, .by_pixel = by_pixel});
        assert_memory_equal(interrupted.pixels, whole.pixels, (size_t)(whole.width * whole.height) * sizeof(Colour));
    }
}
