// Chapters 1 and 2: roulette, and the glossy lobe.
#include "web/figures/numbers.h"

// Share of the flux that a glossy surface sends on, when light comes in at this angle (degrees): the mean weight of
// `count` draws.
static double albedo(bool (*scatter)(Vec3, Vec3, float, Rng *, Vec3 *, float *), float exponent, float angle, int count)
{
    float radians = angle * (PI / 180.0f);
    Vec3 coming = vec3(sinf(radians), 0, -cosf(radians));
    Rng rng = rng_create(7, (uint64_t)(10.0f * angle));
    double sum = 0.0;
    for (int i = 0; i < count; i++) {
        Vec3 out;
        float weight = 0.0f;
        if (scatter(coming, vec3(0, 0, 1), exponent, &rng, &out, &weight))
            sum += (double)weight;
    }
    return sum / count;
}

// Angle, albedo by step 2.3, albedo by step 2.4: from 0 to 88 degrees, then at the angle that is asked for.
int EXPORT(web_albedo)(float exponent, float angle, int count)
{
    numbers_begin();
    for (int i = 0; i <= 45; i++) {
        float at = i < 45 ? 2.0f * (float)i : angle;
        numbers_add(at);
        numbers_add(albedo(steps.scatter_glossy_source_text, exponent, at, count));
        numbers_add(albedo(steps.scatter_glossy_phong, exponent, at, count));
    }
    return numbers_count();
}

// Samples of step 2.1 seen from the side, x and z, and the same with the z that the source text's prose prints.
int EXPORT(web_misprint)(float exponent, int count)
{
    Rng rng = rng_create(3, 1);
    numbers_begin();
    for (int i = 0; i < count; i++) {
        Vec3 right = steps.sample_lobe(exponent, &rng);
        Vec3 wrong = vec3(right.x, right.y, 1.0f - right.z);
        numbers_add_two((double)right.x, (double)right.z);
        numbers_add_two((double)wrong.x, (double)wrong.z);
        numbers_add_two((double)(acosf(fminf(right.z, 1.0f)) * (180.0f / PI)),
                        (double)(atan2f(sqrtf(wrong.x * wrong.x + wrong.y * wrong.y), wrong.z) * (180.0f / PI)));
    }
    return numbers_count();
}

// Photons in a closed box whose walls reflect this share. First the sums: mean of the power that a path leaves at walls, in
// powers of its photon, its standard deviation, bounces a path; then for each bounce the share of photons still alive by
// step 1.4, and the mean power of those. Without roulette all live, and each has this share to the power of the bounce.
int EXPORT(web_roulette)(float reflectance, int bounces, int paths)
{
    static double alive[100], power_of[100];
    double sum = 0.0, sum2 = 0.0, all = 0.0;
    Rng rng = rng_create(11, 1);
    numbers_begin();
    memset(alive, 0, sizeof alive);
    memset(power_of, 0, sizeof power_of);
    for (int i = 0; i < paths; i++) {
        Colour power = colour_grey(1.0f);
        double left = 0.0;
        for (int bounce = 0; bounce < 1000; bounce++) {
            if (bounce < bounces && bounce < 100) {
                alive[bounce] += 1.0 / paths;
                power_of[bounce] += (double)power.r / paths;
            }
            left += (double)power.r;
            all += 1.0 / paths;
            if (!steps.russian_roulette(&power, colour_grey(reflectance), &rng))
                break;
        }
        sum += left / paths;
        sum2 += left * left / paths;
    }
    numbers_add_two(sum, sqrt(sum2 - sum * sum));
    numbers_add(all);
    for (int bounce = 0; bounce < bounces && bounce < 100; bounce++)
        numbers_add_two(alive[bounce], alive[bounce] > 0.0 ? power_of[bounce] / alive[bounce] : 0.0);
    return numbers_count();
}
