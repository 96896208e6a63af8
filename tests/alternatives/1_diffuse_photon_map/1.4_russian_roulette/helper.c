// A helper for the probability; the draw counts down from one.
#include "photonlab.h"

static float chance(Colour before, Colour after)
{
    float total = colour_sum(before);
    if (!(total > 0.0f))
        return 0.0f;
    float ratio = colour_sum(after) / total;
    return ratio > 1.0f ? 1.0f : ratio;
}

bool russian_roulette(Colour *power, Colour reflectance, Rng *rng)
{
    Colour after = colour_mul(*power, reflectance);
    float survival = chance(*power, after);
    float draw = 1.0f - rng_float(rng);
    if (draw > survival)
        return false;
    power->r = after.r / survival;
    power->g = after.g / survival;
    power->b = after.b / survival;
    return true;
}
