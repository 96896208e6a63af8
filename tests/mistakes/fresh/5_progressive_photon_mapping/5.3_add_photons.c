//1 all_stay               N grows by all
//2 flux_not_scaled        no share in the flux
//3 radius_by_share        no root
//4 old_flux_forgotten     the new flux alone
//5 radius_stays           the radius as it was
//6 -                      the flux scaled by the new count over the old
//11 alpha_unused          nothing shrinks
//12 scaled_by_radius      by the radii
//13 count_kept            N as it was
#include "photonlab.h"
PointStatistics add_photons(PointStatistics p, int M, Colour F, float alpha)
{
    PointStatistics q = p;
    if (M <= 0)
        return q;
    float N = p.count, s = (N + alpha * M) / (N + M);
    if (MISTAKE == 11)
        s = 1.0f, alpha = 1.0f;
    q.count = MISTAKE == 1 ? N + M : N + alpha * M;
    q.radius = MISTAKE == 5 ? p.radius : p.radius * (MISTAKE == 3 ? s : sqrtf(s));
    q.flux = MISTAKE == 4 ? F : colour_add(p.flux, F);
    if (MISTAKE != 2)
        q.flux = colour_scale(q.flux, MISTAKE == 6 ? q.count / fmaxf(1.0f, N) : s);
    if (MISTAKE == 13)
        q.count = N;
    if (MISTAKE == 12)
        q.flux = colour_scale(colour_add(p.flux, F), sqrtf(s));
    return q;
}
