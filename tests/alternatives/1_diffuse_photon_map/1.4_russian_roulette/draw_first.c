// Draws first, and compares fluxes without a division.
#include "photonlab.h"

bool russian_roulette(Colour *power, Colour reflectance, Rng *rng)
{
    float draw = rng_float(rng);
    Colour rest = colour_mul(reflectance, *power);
    float in = colour_sum(*power);
    float out = colour_sum(rest);
    if (draw * in < out) {
        float up = out < in ? in / out : 1.0f;
        *power = colour_scale(rest, up);
        return true;
    }
    return false;
}
