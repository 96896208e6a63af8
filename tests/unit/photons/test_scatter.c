// The bounces that the library puts together from steps: photon_scatter_glossy and photon_scatter_glass.
#include "unit/test_common.h"

// Straight onto a glossy surface whose lobe is as narrow as a mirror: a photon that leaves along the normal
// (within 1°) came from the lobe; of diffuse ones, sin²1° = 0.0003 look like that.
static const Vec3 up = {0, 0, 1};

static bool from_the_lobe(const Photon *photon)
{
    return angle_between(photon->direction, up) < 1.0;
}

static Hit hit_on(const Material *material)
{
    return (Hit){.normal = up, .face_normal = up, .entering = true, .material = material};
}

// The mean power that goes on by each way is Φ_c ρ_c, channel by channel, for white and for coloured photons.
TEST(glossy_bounce_keeps_the_mean)
{
    Material material = {
        .type = MATERIAL_GLOSSY, .diffuse = {0.5f, 0.1f, 0.0f}, .specular = {0.2f, 0.6f, 0.9f}, .exponent = 1e6f};
    const Colour powers[] = {{1, 1, 1}, {0, 2, 0}, {5, 0.1f, 1}};
    for (int k = 0; k < 6; k++) {
        Hit hit = hit_on(&material);
        Rng rng = rng_create(61, (uint64_t)k);
        Mean diffuse[3] = {{0}}, lobe[3] = {{0}};
        steps_play((StepChoice){k < 3 ? GLOSSY_PHONG : GLOSSY_SOURCE_TEXT, false});
        for (int i = 0; i < 100000; i++) {
            Photon photon = photon_create(up, vec3(0, 0, -1), powers[k % 3]);
            bool survives = photon_scatter_glossy(&photon, &hit, &rng);
            for (int c = 0; c < 3; c++) {
                double power = survives ? (double)colour_channel(photon.power, c) : 0.0;
                mean_add(&lobe[c], from_the_lobe(&photon) ? power : 0.0);
                mean_add(&diffuse[c], from_the_lobe(&photon) ? 0.0 : power);
            }
        }
        for (int c = 0; c < 3; c++) {
            double power = colour_channel(powers[k % 3], c);
            double look_alike = 0.0003 * power * (double)colour_channel(material.diffuse, c);
            double by_lobe = power * (double)colour_channel(material.specular, c);
            double by_diffuse = power * (double)colour_channel(material.diffuse, c);
            assert_mean(&lobe[c], by_lobe + look_alike, "mean power by the lobe");
            assert_mean(&diffuse[c], by_diffuse - look_alike, "mean power by diffuse reflection");
        }
    }
    steps_play(PLAY_DEFAULT);
}

// Where both parts have one colour, choosing in proportion to their flux makes every weight 1: no power ever changes.
TEST(glossy_bounce_chooses_in_proportion)
{
    Material material = {
        .type = MATERIAL_GLOSSY, .diffuse = {0.2f, 0.2f, 0.2f}, .specular = {0.6f, 0.6f, 0.6f}, .exponent = 1e6f};
    Hit hit = hit_on(&material);
    Rng rng = rng_create(62, 0);
    long survivors = 0, lobes = 0, count = 100000;
    steps_play((StepChoice){GLOSSY_SOURCE_TEXT, false});
    for (long i = 0; i < count; i++) {
        Photon photon = photon_create(up, vec3(0, 0, -1), colour(1, 2, 3));
        if (!photon_scatter_glossy(&photon, &hit, &rng))
            continue;
        survivors++;
        lobes += from_the_lobe(&photon);
        assert_within(photon.power.r, 1.0, 1e-6, "red");
        assert_within(photon.power.b, 3.0, 3e-6, "blue");
    }
    assert_share(survivors, count, 0.8, "survivors");
    assert_share(lobes, survivors, 0.75 + 0.25 * 0.0003, "lobe's share of the survivors");
    steps_play(PLAY_DEFAULT);
}

// 4 % come back from glass of index 1.5 seen straight on; the others go through, as bright and as white as they came.
TEST(glass_bounce)
{
    Material glass = {.type = MATERIAL_GLASS, .index = {1.5f, 1.5f, 1.5f}};
    Hit hit = hit_on(&glass);
    Rng rng = rng_create(63, 0);
    long reflected = 0, count = 100000;
    for (long i = 0; i < count; i++) {
        Photon photon = photon_create(up, vec3(0, 0, -1), colour(1, 2, 3));
        photon_scatter_glass(&photon, &hit, &rng);
        assert_true(fabsf(photon.direction.z) == 1.0f && photon.colour == WHITE);
        assert_true(photon.power.r == 1.0f && photon.power.g == 2.0f && photon.power.b == 3.0f);
        reflected += photon.direction.z > 0.0f;
    }
    assert_share(reflected, count, 0.04, "reflected");
    hit.entering = false; // from inside, beyond the critical angle of 41.8°: always
    for (int i = 0; i < 1000; i++) {
        Photon photon = photon_create(up, vec3(0.8f, 0, -0.6f), colour_grey(1));
        photon_scatter_glass(&photon, &hit, &rng);
        assert_within(angle_between(photon.direction, vec3(0.8f, 0, 0.6f)), 0.0, 1e-4, "totally reflected");
    }
}
