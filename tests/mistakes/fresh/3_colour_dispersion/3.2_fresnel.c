//1 schlick|schlick_with_cos_i   the well-known approximation
//2 s_only                      one polarisation
//3 half_missing                 the sum of both
//4 zero_when_total              0 under total reflection
//5 root_of_share                the root of all
//6 -                            the harmonic mean of both
//11 not_squared                 amplitudes
//12 p_only                      the other polarisation
//13 ratio_inverted              n_t/n_i
#include "photonlab.h"
float fresnel(float c, float eta)
{
    double ci = (double)c, h = MISTAKE == 13 ? 1.0 / (double)eta : (double)eta, sin2t = h * h * (1.0 - ci * ci);
    if (sin2t >= 1.0)
        return MISTAKE == 4 ? 0.0f : 1.0f;
    double ct = sqrt(1.0 - sin2t);
    if (MISTAKE == 1) {
        double r = (h - 1.0) / (h + 1.0), x = 1.0 - ci;
        return (float)(r * r + (1.0 - r * r) * x * x * x * x * x);
    }
    double perpendicular = pow((h * ci - ct) / (h * ci + ct), 2.0), parallel = pow((h * ct - ci) / (h * ct + ci), 2.0);
    if (MISTAKE == 11)
        perpendicular = sqrt(perpendicular), parallel = sqrt(parallel);
    if (MISTAKE == 12)
        perpendicular = parallel;
    double all = perpendicular + parallel;
    if (MISTAKE == 6)
        return (float)(2.0 * perpendicular * parallel / fmax(1e-12, all));
    return (float)(MISTAKE == 2 ? perpendicular : MISTAKE == 3 ? all : MISTAKE == 5 ? sqrt(all / 2.0) : all / 2.0);
}
