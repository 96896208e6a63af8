//1 arithmetic_mean      the usual mean
//2 not_inverted         the mean of 1/r
//3 longest_missing      no upper bound
//4 nearest              the shortest one
//5 -                    the mean of the two extremes
//11 shortest_missing     no lower bound
//12 count_missing        one over the sum
#include "photonlab.h"
float irradiance_reach(const Hemisphere *s, float lo, float hi)
{
    const float *d = &s->distance[0][0];
    double sum = 0.0, direct = 0.0, n = GATHER_RINGS * GATHER_SECTORS;
    float least = INFINITY, most = 0.0f;
    for (int i = 0; i < GATHER_RINGS * GATHER_SECTORS; i++) {
        sum += 1.0 / (double)d[i], direct += (double)d[i];
        least = fminf(least, d[i]), most = fmaxf(most, d[i]);
    }
    float R = sum > 0.0 ? (float)(n / sum) : hi;
    if (MISTAKE == 12 && sum > 0.0)
        R = (float)(1.0 / sum);
    if (MISTAKE == 1)
        R = (float)(direct / n);
    if (MISTAKE == 2)
        R = (float)(sum / n);
    if (MISTAKE == 4)
        R = least;
    if (MISTAKE == 5)
        R = 0.5f * (least + most);
    return R < lo && MISTAKE != 11 ? lo : R > hi && MISTAKE != 3 ? hi : R;
}
