//1 n_for_n_plus_1          1/n
//2 sine_one_minus_cosine   the sine is 1 − cosα
//3 degrees                 the azimuth in degrees
//4 z_of_the_prose|power_for_root          1 − u^…
//5 two_over_n_plus_1       2/(n+1)
//6 sine_for_cosine                       the exponent of the sine
//11 half_circle             half a turn
//12 exponent_ignored        always 1
//13 same_number_twice       the first number for both
#include "photonlab.h"
Vec3 sample_lobe(float n, Rng *rng)
{
    double xi = 1.0 - (double)rng_float(rng);
    double eta = (double)rng_float(rng);
    if (MISTAKE == 12)
        n = 1.0f;
    if (MISTAKE == 13)
        eta = 1.0 - xi;
    double e = MISTAKE == 1 ? 1.0 / fmax((double)n, 1e-3) : MISTAKE == 5 ? 2.0 / (n + 1.0) : 1.0 / (n + 1.0);
    double z = pow(xi, e), s;
    if (MISTAKE == 4)
        z = 1.0 - z;
    s = MISTAKE == 2 ? 1.0 - z : sqrt(fmax(0.0, 1.0 - z * z));
    if (MISTAKE == 6)
        s = pow(xi, e), z = sqrt(fmax(0.0, 1.0 - s * s));
    double a = MISTAKE == 3 ? 360.0 * eta : 2.0 * 3.14159265358979 * eta;
    if (MISTAKE == 11)
        a *= 0.5;
    return vec3((float)(s * cos(a)), (float)(s * sin(a)), (float)z);
}
