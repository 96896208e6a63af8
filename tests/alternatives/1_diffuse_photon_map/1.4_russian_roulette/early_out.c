// Black surfaces and powerless photons are settled before a number is drawn.
#include "photonlab.h"

bool russian_roulette(Colour *power, Colour reflectance, Rng *rng)
{
    const float after = power->r * reflectance.r + power->g * reflectance.g + power->b * reflectance.b;
    if (after <= 0.0f)
        return false;
    const float ratio = (power->r + power->g + power->b) / after;
    if (ratio > 1.0f && rng_float(rng) * ratio >= 1.0f)
        return false;
    const float gain = ratio > 1.0f ? ratio : 1.0f;
    power->r *= reflectance.r * gain;
    power->g *= reflectance.g * gain;
    power->b *= reflectance.b * gain;
    return true;
}
