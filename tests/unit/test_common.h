// What the tests of physics and of the steps share: reference steps, scenes from text, photons, and
// statistics.
//
// Random tests draw from fixed seeds, so they give the same verdict on every run. They ask for 3 standard
// errors (1 right test in 370 would miss that with another seed) or the 4 that the energy ledger promises.
#pragma once

#include "photonlab.h"
#include "scene/scene.h"
#include "unit/test.h"

// Statistics over many photons tell the sanitizers nothing that an eighth of them would not: under these, fewer are
// traced. Tolerances must follow from the count.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SANITIZED 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#define SANITIZED 1
#endif
#ifdef SANITIZED
#define FEWER(count) ((count) / 8)
#else
#define FEWER(count) (count)
#endif

static const double DEGREES = 57.295779513082321;

// What a test program does first, unless it says something else by AROUND_TESTS, which comes later and wins.
FIXTURE(load_reference_steps)
{
    if (steps_load(NULL, &said))
        return 0;
    print_error("%s\n", said.message);
    return -1;
}

__attribute__((constructor(200))) static void play_reference_steps(void)
{
    before_all = load_reference_steps;
}

static inline void assert_within(double value, double expected, double tolerance, const char *what)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%s: %.9g, expected %.9g ± %.3g", what, value, expected, tolerance);
}

#define assert_near(value, expected, tolerance) assert_within(value, expected, tolerance, #value)

// Angle between two directions, degrees; exact for small angles too.
static inline double angle_between(Vec3 a, Vec3 b)
{
    double cx = (double)a.y * b.z - (double)a.z * b.y;
    double cy = (double)a.z * b.x - (double)a.x * b.z;
    double cz = (double)a.x * b.y - (double)a.y * b.x;
    double dot = (double)a.x * b.x + (double)a.y * b.y + (double)a.z * b.z;
    return DEGREES * atan2(sqrt(cx * cx + cy * cy + cz * cz), dot);
}

// The unit vector in the xz-plane at this angle to +z, towards +x.
static inline Vec3 tilted(double theta_degrees)
{
    return vec3((float)sin(theta_degrees / DEGREES), 0.0f, (float)cos(theta_degrees / DEGREES));
}

static inline Vec3 random_direction(Rng *rng)
{
    float z = 2.0f * rng_float(rng) - 1.0f;
    float phi = 2.0f * PI * rng_float(rng);
    float r = sqrtf(1.0f - z * z);
    return vec3_normalize(vec3(r * cosf(phi), r * sinf(phi), z));
}

// ---- mean and its standard error
typedef struct {
    double sum, sum_of_squares;
    long count;
} Mean;

static inline void mean_add(Mean *mean, double value)
{
    mean->sum += value;
    mean->sum_of_squares += value * value;
    mean->count++;
}

static inline double mean_value(const Mean *mean)
{
    return mean->sum / (double)mean->count;
}

static inline double mean_error(const Mean *mean)
{
    double m = mean_value(mean);
    double variance = mean->sum_of_squares / (double)mean->count - m * m;
    return sqrt(fmax(0.0, variance) / (double)mean->count);
}

static inline void assert_mean(const Mean *mean, double expected, const char *what)
{
    double rounding = 2e-6 * fabs(expected); // of the single-precision values themselves
    assert_within(mean_value(mean), expected, 3.0 * mean_error(mean) + rounding, what);
}

// Is a share of `count` trials the probability `p`?
static inline void assert_share(long hits, long count, double p, const char *what)
{
    double error = sqrt(p * (1.0 - p) / (double)count);
    assert_within((double)hits / (double)count, p, 3.0 * error + 1e-9, what);
}

// ---- scenes, photons and pictures
FREED_AT_END(own_scene, Scene, scene_free)
FREED_AT_END(own_pass, PhotonPass, photon_pass_free)
FREED_AT_END(own_image, Image, image_free)

// Files that the text names are looked for in `folder`.
static inline Scene *scene_in_folder(const char *text, const char *folder)
{
    Scene *scene = scene_load_text(text, strlen(text), "scene of the test", folder, &said);
    assert_works(scene);
    return own_scene(scene);
}

static inline Scene *scene_from_text(const char *text)
{
    return scene_in_folder(text, "scenes/");
}

static inline Scene *scene_from_file(const char *path)
{
    Scene *scene = scene_load(path, &said);
    if (!scene)
        fail_msg("%s (meshes are generated: run `make` first)", said.message);
    return own_scene(scene);
}

// As deep as the scene has it. All kinds of photons; they stand in pass.rest.
static inline PhotonPass pass_of(const Scene *scene, PhotonPassOptions options)
{
    PhotonPass pass;
    options.depth = scene->settings.depth;
    options.keep = KEEP_ALL;
    assert_works(photon_pass_run(scene, &options, &pass, &said));
    return *own_pass(kept(&pass, sizeof pass));
}

static inline PhotonPass photons_of(const Scene *scene, long photons, uint64_t seed, StepChoice play)
{
    steps_play(play);
    return pass_of(scene, (PhotonPassOptions){.photons = photons, .seed = seed, .play = play});
}

static inline Image picture_of(const Scene *scene, const RenderOptions *options)
{
    Image image;
    RenderStats stats;
    assert_works(render_image(scene, options, &image, &stats, &said));
    return *own_image(kept(&image, sizeof image));
}

static const StepChoice PLAY_DEFAULT = {GLOSSY_PHONG, false};
