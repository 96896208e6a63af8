// The reference steps of stages 1 and 3, one by one, against values worked out by hand. Stage 2: test_lobe.c.
#include "unit/test_common.h"

TEST(reflect_mirrors)
{
    Vec3 r = steps.reflect(vec3(0.6f, 0.0f, -0.8f), vec3(0.0f, 0.0f, 1.0f));
    assert_within(angle_between(r, vec3(0.6f, 0.0f, 0.8f)), 0.0, 1e-5, "mirror direction");
    Rng rng = rng_create(11, 0);
    for (int i = 0; i < 1000; i++) {
        Vec3 d = random_direction(&rng), n = random_direction(&rng);
        r = steps.reflect(d, n);
        assert_within(vec3_length(r), 1.0, 1e-6, "length");
        assert_within(vec3_dot(r, n), -vec3_dot(d, n), 1e-6, "part along the normal");
        assert_within(angle_between(steps.reflect(r, n), d), 0.0, 1e-4, "mirrored twice");
        assert_within(angle_between(steps.reflect(d, vec3_negate(n)), r), 0.0, 1e-4, "normal's other side");
    }
}

// u and v along the sides of a slanted rectangle are uniform, the direction is cosine-distributed: cos²θ is uniform.
TEST(emit_photon_covers_the_light)
{
    Light light = {.type = LIGHT_RECTANGLE,
                   .position = vec3(1, 2, 3),
                   .edge_u = vec3(2, 0, 0),
                   .edge_v = vec3(0, 0.3f, 0.4f),
                   .direction = vec3(0, -0.8f, 0.6f),
                   .area = 1.0f,
                   .power = colour(3, 2, 1)};
    Rng rng = rng_create(12, 0);
    enum { SIDE = 8, BINS = SIDE * SIDE * SIDE, COUNT = 50 * BINS };
    static long counts[BINS];
    for (int i = 0; i < COUNT; i++) {
        Photon photon = steps.emit_photon(&light, &rng);
        Vec3 at = vec3_sub(photon.position, light.position);
        float u = vec3_dot(at, light.edge_u) / 4.0f, v = vec3_dot(at, light.edge_v) / 0.25f;
        assert_within(vec3_dot(at, light.direction), 0.0, 1e-6, "height over the light");
        assert_true(u >= 0.0f && u < 1.0f && v >= 0.0f && v <= 1.0f);
        float cosine = vec3_dot(photon.direction, light.direction);
        assert_true(cosine >= 0.0f);
        assert_within(vec3_length(photon.direction), 1.0, 1e-6, "length");
        assert_true(photon.power.r == 3.0f && photon.power.g == 2.0f && photon.power.b == 1.0f);
        assert_true(photon.colour == WHITE && photon.bounce == 0 && photon.path == PATH_DIRECT);
        float w = cosine * cosine;
        int bin = ((int)(u * SIDE) * SIDE + (int)fminf(v * SIDE, SIDE - 1)) * SIDE + (int)fminf(w * SIDE, SIDE - 1);
        counts[bin]++;
    }
    assert_uniform(counts, BINS, "place and angle of emission");
}

// Density cosθ/π: cos²θ and the azimuth about the normal are uniform, for any normal.
TEST(scatter_diffuse_is_lambert)
{
    const Vec3 normals[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {0.48f, 0.64f, -0.6f}};
    enum { SIDE = 16, BINS = SIDE * SIDE, COUNT = 200 * BINS };
    for (int k = 0; k < 5; k++) {
        Vec3 n = normals[k];
        Vec3 across = vec3_normalize(fabsf(n.x) < 0.5f ? vec3(0, n.z, -n.y) : vec3(-n.y, n.x, 0));
        Vec3 third = vec3_cross(n, across);
        long counts[BINS] = {0};
        Rng rng = rng_create(13, (uint64_t)k);
        for (int i = 0; i < COUNT; i++) {
            Vec3 d = steps.scatter_diffuse(n, &rng);
            float cosine = vec3_dot(d, n);
            assert_true(cosine >= 0.0f);
            assert_within(vec3_length(d), 1.0, 1e-6, "length");
            float turn = atan2f(vec3_dot(d, third), vec3_dot(d, across)) / (2.0f * PI) + 0.5f;
            int row = (int)fminf(cosine * cosine * SIDE, SIDE - 1), column = (int)fminf(turn * SIDE, SIDE - 1);
            counts[row * SIDE + column]++;
        }
        assert_uniform(counts, BINS, "diffuse directions");
    }
}

// The share that survives is Σ Φρ / Σ Φ, the mean power per channel Φρ: also for coloured photons, whose
// other channels must not count.
TEST(russian_roulette_keeps_the_mean)
{
    const Colour powers[] = {{1, 1, 1}, {2, 0, 0}, {0, 0, 0.5f}, {3, 0.1f, 1}};
    const Colour surface = {0.9f, 0.4f, 0.05f};
    const double survival[] = {1.35 / 3.0, 0.9, 0.05, 2.79 / 4.1};
    for (int k = 0; k < 4; k++) {
        Rng rng = rng_create(14, (uint64_t)k);
        Mean mean[3] = {{0}};
        long survivors = 0, count = 100000;
        for (long i = 0; i < count; i++) {
            Colour power = powers[k];
            bool survives = steps.russian_roulette(&power, surface, &rng);
            survivors += survives;
            if (survives)
                assert_within(colour_sum(power), colour_sum(powers[k]), 1e-5, "survivors carry the flux that came");
            for (int c = 0; c < 3; c++)
                mean_add(&mean[c], survives ? (double)colour_channel(power, c) : 0.0);
        }
        assert_share(survivors, count, survival[k], "survivors");
        for (int c = 0; c < 3; c++)
            assert_mean(&mean[c], (double)(colour_channel(powers[k], c) * colour_channel(surface, c)), "mean power");
    }
}

TEST(russian_roulette_at_its_ends)
{
    Rng rng = rng_create(15, 0);
    for (int i = 0; i < 1000; i++) {
        Colour power = colour(1, 2, 3), none = colour_grey(0);
        assert_true(steps.russian_roulette(&power, colour_grey(1), &rng));
        assert_true(power.r == 1.0f && power.g == 2.0f && power.b == 3.0f);
        assert_false(steps.russian_roulette(&power, colour_grey(0), &rng));
        assert_true(power.r == 1.0f && power.g == 2.0f && power.b == 3.0f);
        assert_false(steps.russian_roulette(&none, colour_grey(0.5f), &rng));
        Colour red = colour(1, 0, 0);
        assert_false(steps.russian_roulette(&red, colour(0, 1, 1), &rng)); // a red photon on a cyan wall
    }
}

// Snell: n_i sinθ_i = n_t sinθ_t, in the plane of direction and normal.
TEST(refract_obeys_snell)
{
    Rng rng = rng_create(31, 0);
    for (int i = 0; i < 2000; i++) {
        Vec3 n = random_direction(&rng), d = random_direction(&rng), t;
        float eta = 0.4f + 2.0f * rng_float(&rng);
        if (vec3_dot(d, n) > 0.0f)
            d = vec3_negate(d);
        double sin_i = sin(angle_between(d, vec3_negate(n)) / DEGREES), sin_t = (double)eta * sin_i;
        if (fabs(sin_t - 1.0) < 1e-4)
            continue; // the edge of total reflection: below
        assert_int_equal(steps.refract(d, n, eta, &t), sin_t < 1.0);
        if (sin_t > 1.0)
            continue;
        assert_within(vec3_length(t), 1.0, 1e-6, "length");
        assert_within(sin(angle_between(t, vec3_negate(n)) / DEGREES), sin_t, 2e-5, "sine behind the surface");
        assert_within(vec3_dot(t, vec3_normalize(vec3_cross(d, n))), 0.0, 2e-5, "out of plane");
        assert_true(vec3_dot(t, n) < 0.0f);
    }
}

// Out of glass, n = 1.5: total reflection from asin(1/1.5) = 41.8103° on. It leaves *refracted alone.
TEST(refract_reflects_totally)
{
    Vec3 t = {7, 8, 9}, n = {0, 0, 1};
    Vec3 above = vec3(tilted(41.82).x, 0, -tilted(41.82).z), below = vec3(tilted(41.80).x, 0, -tilted(41.80).z);
    assert_false(steps.refract(above, n, 1.5f, &t));
    assert_true(t.x == 7.0f && t.y == 8.0f && t.z == 9.0f);
    assert_within(steps.fresnel(-above.z, 1.5f), 1.0, 0.0, "total reflection");
    assert_true(steps.refract(below, n, 1.5f, &t));
    assert_within(angle_between(t, vec3(1, 0, 0)), DEGREES * acos(1.5 * sin(41.80 / DEGREES)), 0.01, "grazing");
    assert_true(steps.fresnel(-below.z, 1.5f) < 1.0f);
}

TEST(fresnel_values)
{
    assert_within(steps.fresnel(1.0f, 1.0f / 1.5f), 0.04, 1e-7, "glass seen straight on: ((n-1)/(n+1))^2");
    assert_within(steps.fresnel(1.0f, 1.5f), 0.04, 1e-7, "the same from inside");
    assert_within(steps.fresnel(1e-4f, 1.0f / 1.5f), 1.0, 1e-3, "grazing");
    assert_within(steps.fresnel(0.3f, 1.0f), 0.0, 1e-7, "no step in index");
    // Brewster: at tanθ = n only R_s is left, ((n²−1)/(n²+1))²; half of it for unpolarised light.
    double brewster = atan(1.5), r_s = (1.5 * 1.5 - 1.0) / (1.5 * 1.5 + 1.0);
    assert_within(steps.fresnel((float)cos(brewster), 1.0f / 1.5f), 0.5 * r_s * r_s, 1e-6, "Brewster's angle");
    // Light that goes the same way backwards is reflected as much.
    for (int degrees = 0; degrees < 90; degrees += 5) {
        double cos_i = cos(degrees / DEGREES), sin_t = sin(degrees / DEGREES) / 1.79;
        float from_air = steps.fresnel((float)cos_i, (float)(1.0 / 1.79));
        float from_glass = steps.fresnel((float)sqrt(1.0 - sin_t * sin_t), 1.79f);
        assert_within(from_glass, from_air, 5e-6, "both sides");
    }
}

// N-SF11 from inside at 33.95°: red and green partly leave, blue not; the mean is 0.862, where the mean index
// would say 1.
TEST(white_light_is_reflected_by_three_indices)
{
    Material flint = {.type = MATERIAL_GLASS, .index = {1.78133f, 1.79132f, 1.81369f}, .disperses = true};
    float cos_i = (float)cos(33.95 / DEGREES), mean = 0.0f;
    assert_within(steps.refractive_index(&flint, WHITE), 1.79545, 1e-5, "white has the mean index");
    for (int c = 0; c < 3; c++) {
        float index = steps.refractive_index(&flint, (PhotonColour)(RED + c));
        assert_true(index == flint.index[c]);
        mean += steps.fresnel(cos_i, index) / 3.0f;
    }
    assert_within(mean, 0.862, 0.001, "mean reflectance");
    assert_within(steps.fresnel(cos_i, steps.refractive_index(&flint, WHITE)), 1.0, 0.0, "at the mean index");
}

TEST(split_colour_once)
{
    Material flint = {.type = MATERIAL_GLASS, .index = {1.5f, 1.6f, 1.7f}, .disperses = true};
    Material crown = {.type = MATERIAL_GLASS, .index = {1.5f, 1.5f, 1.5f}};
    Photon white = photon_create(vec3(1, 2, 3), vec3(0, 0, 1), colour(4, 5, 6)), children[3], again[3];
    white.bounce = 7;
    assert_int_equal(steps.split_colour(&white, &flint, children), 3);
    for (int c = 0; c < 3; c++) {
        assert_int_equal(children[c].colour, RED + c);
        for (int other = 0; other < 3; other++)
            assert_true(colour_channel(children[c].power, other) == (other == c ? 4.0f + (float)c : 0.0f));
        assert_true(children[c].position.y == 2.0f && children[c].direction.z == 1.0f && children[c].bounce == 7);
        assert_int_equal(steps.split_colour(&children[c], &flint, again), 1);
        assert_int_equal(again[0].colour, RED + c);
        assert_memory_equal(&again[0].power, &children[c].power, sizeof(Colour));
    }
    assert_int_equal(steps.split_colour(&white, &crown, children), 1);
    assert_int_equal(children[0].colour, WHITE);
    assert_memory_equal(&children[0].power, &white.power, sizeof(Colour));
}

// 1.10 comes after 1.9.
static int number_of(const StepInfo *step)
{
    return 1000 * step->stage + atoi(strchr(step->id, '.') + 1);
}

TEST(table_is_in_order)
{
    assert_int_equal(step_table[0].stage, 1);
    for (int i = 1; i < STEP_COUNT; i++) {
        assert_true(number_of(&step_table[i - 1]) < number_of(&step_table[i]));
        assert_in_range(step_table[i].stage - step_table[i - 1].stage, 0, 1);
    }
    assert_int_equal(step_table[STEP_COUNT - 1].stage, STAGE_COUNT);
    for (int i = 0; i < STEP_COUNT; i++)
        assert_ptr_equal(step_find(step_table[i].id), &step_table[i]);
}

TEST(an_id_is_no_part_of_another)
{
    assert_true(step_is_listed("1.10 2.1", "1.10") && step_is_listed("1.10,2.1", "2.1"));
    assert_false(step_is_listed("1.10 12.1", "1.1") || step_is_listed("1.10 12.1", "2.1") || step_is_listed("", "1.1"));
}

// What plays in the place of what, and what `--steps` makes of it.
TEST(pairs_of_steps)
{
    StepChoice choice;
    Error error = {""};
    char text[40];
    assert_true(step_choice_parse("1.5", &choice, &error));
    step_choice_print(choice, text, sizeof text);
    assert_string_equal(text, "2.4,1.5");
    assert_true(step_is_played(step_find("1.5"), choice) && !step_is_played(step_find("3.5"), choice));
    assert_ptr_equal(step_chosen_by(step_find("3.5")), step_find("3.4"));
    assert_ptr_equal(step_chosen_by(step_find("2.1")), step_find("2.1"));
    assert_true(steps_are_paired(step_find("3.5"), step_find("1.5")));
    assert_false(steps_are_paired(step_find("3.5"), step_find("3.4")) ||
                 steps_are_paired(step_find("1.5"), step_find("2.4")));
    assert_false(step_choice_parse("3.4,1.5", &choice, &error));
    assert_string_equal(
        error.message,
        "--steps 3.4,1.5: no choice `1.5`; expected 2.4 or 2.3, and 3.4 or 1.5 or 6.4, parted by a comma");
    bool started[STEP_COUNT] = {false};
    started[STEP_trace_photon] = started[STEP_scatter_glossy_source_text] = started[STEP_scatter_glossy_phong] = true;
    step_choice_print(step_choice_for(started), text, sizeof text);
    assert_string_equal(text, "2.4,1.5");
}

AROUND_TESTS(load_reference_steps, NULL)
