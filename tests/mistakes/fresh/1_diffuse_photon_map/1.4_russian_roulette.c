//1 mean_reflectance|weighed_by_mean      the mean reflectance
//2 largest_reflectance  the largest reflectance
//3 answers_swapped      true for the absorbed
//4 not_reweighted       not divided
//5 absorbed_changed     changed before the draw
//6 -                    the product of the three reflectances
//7 reflectance_missing  divided, but not coloured
//11 reweighted_twice     over the square
//12 power_as_probability the mean of what is reflected
#include "photonlab.h"
bool russian_roulette(Colour *P, Colour rho, Rng *rng)
{
    float in = P->r + P->g + P->b, out = P->r * rho.r + P->g * rho.g + P->b * rho.b;
    if (in <= 0.0f)
        return false;
    float q = out / in;
    if (MISTAKE == 1)
        q = (rho.r + rho.g + rho.b) / 3.0f;
    if (MISTAKE == 2)
        q = fmaxf(fmaxf(rho.r, rho.g), rho.b);
    if (MISTAKE == 6)
        q = rho.r * rho.g * rho.b;
    if (MISTAKE == 12)
        q = out / 3.0f;
    Colour after = {P->r * rho.r, P->g * rho.g, P->b * rho.b};
    if (MISTAKE == 7)
        after = *P;
    if (MISTAKE == 5)
        *P = q > 0.0f ? colour_scale(after, 1.0f / q) : after;
    bool lives = rng_float(rng) < q;
    if (lives && MISTAKE != 5)
        *P = MISTAKE == 4 ? after : colour_scale(after, 1.0f / q);
    if (lives && MISTAKE == 11)
        *P = colour_scale(*P, 1.0f / q);
    return MISTAKE == 3 ? !lives : lives;
}
