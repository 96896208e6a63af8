// Of the numbers that eye rays draw.
#include "unit/test_common.h"

#include "render/sampler.h"

// Of 4,096 samples, how far from its share the fullest of 8×8 cells is; coordinates 0 and 1 are the first use's.
static double worst_cell(uint64_t pixel, const uint32_t uses[2], int a, int b)
{
    enum { SIDE = 8, SAMPLES = 4096 };
    int cells[SIDE][SIDE] = {{0}};
    for (uint32_t s = 0; s < SAMPLES; s++) {
        float x[4];
        Sampler sampler = {.pixel = pixel, .index = s};
        sampler_point(&sampler, uses[0], &x[0], &x[1]);
        sampler_point(&sampler, uses[1], &x[2], &x[3]);
        cells[(int)(x[a] * SIDE)][(int)(x[b] * SIDE)]++;
    }
    double share = SAMPLES / (double)(SIDE * SIDE), worst = 0.0;
    for (int i = 0; i < SIDE * SIDE; i++)
        worst = fmax(worst, fabs((&cells[0][0])[i] / share - 1.0));
    return worst;
}

// Where a sample lies in its pixel must say nothing of where it lies on the lamp: an edge in half a shadow would keep
// its error, however many samples it gets.
TEST(uses_of_a_sample_are_independent)
{
    static const uint32_t uses[][2] = {{SAMPLER_FILM, SAMPLER_LIGHT},
                                       {SAMPLER_FILM, SAMPLER_LOBE + 1},
                                       {SAMPLER_LIGHT, SAMPLER_LIGHT + 1},
                                       {SAMPLER_LIGHT, SAMPLER_WAVE}};
    for (uint64_t pixel = 0; pixel < 20; pixel++)
        for (int i = 0; i < 4; i++) {
            assert_within(worst_cell(hash_u64(pixel), uses[i], 0, 1), 0.0, 1e-9, "one use by itself");
            for (int pair = 0; pair < 4; pair++) // by chance a cell of 64 is 1/8 off; eight of these are 5120 × 6e-16
                assert_within(worst_cell(hash_u64(pixel), uses[i], pair / 2, 2 + pair % 2), 0.0, 1.0, "two uses");
        }
}
