// The probability as the mean reflectance, each channel weighed with its share of the flux.
#include "photonlab.h"

bool russian_roulette(Colour *power, Colour reflectance, Rng *rng)
{
    double flux = (double)power->r + (double)power->g + (double)power->b;
    double p = 0.0;
    for (int c = 0; c < 3 && flux > 0.0; c++)
        p += (double)colour_channel(*power, c) / flux * (double)colour_channel(reflectance, c);
    if (p > 1.0)
        p = 1.0;
    bool survives = (double)rng_float(rng) < p;
    for (int c = 0; c < 3 && survives; c++) {
        double reflected = (double)colour_channel(*power, c) * (double)colour_channel(reflectance, c);
        colour_set_channel(power, c, (float)(reflected / p));
    }
    return survives;
}
