//1 root_missing          1 − n·n_i without its root
//2 not_normalised        the plain sum
//3 slope_unused          as they are
//4 reach_missing         in metres
//5 below_missing         no test of below
//6 inverse_weight        one over the error
//7 -                     weighed by the reach as well
//11 equal_weights      all the same
//12 normals_missing    the distance alone
//13 divided_by_count   over how many there are
#include "photonlab.h"
bool interpolate_irradiance(const IrradianceEstimate *const list[], size_t n, Vec3 x, Vec3 nx, float acc, Colour *E)
{
    double used = 0.0, W = 0.0, r = 0.0, g = 0.0, b = 0.0;
    for (const IrradianceEstimate *const *e = list; e != list + n; e++) {
        Vec3 v = vec3_sub(x, (*e)->position), both = vec3_add(nx, (*e)->normal);
        float bend = 1.0f - vec3_dot(nx, (*e)->normal);
        bend = bend > 0.0f ? bend : 0.0f;
        if (MISTAKE == 12)
            bend = 0.0f;
        float eps = vec3_length(v) / (MISTAKE == 4 ? 1.0f : (*e)->reach) + (MISTAKE == 1 ? bend : sqrtf(bend));
        if (!(eps < acc) || (MISTAKE != 5 && 0.5f * vec3_dot(v, both) < -0.05f * acc * (*e)->reach))
            continue;
        used += 1.0;
        Colour c = MISTAKE == 3 ? (*e)->irradiance : irradiance_extrapolate(*e, x, nx);
        double w = MISTAKE == 6 ? 1.0 / fmax(1e-4, (double)eps) : 1.0 - (double)(eps / acc);
        if (MISTAKE == 7)
            w *= (double)(*e)->reach;
        if (MISTAKE == 11)
            w = 1.0;
        W += w, r += w * (double)c.r, g += w * (double)c.g, b += w * (double)c.b;
    }
    if (W <= 0.0)
        return false;
    if (MISTAKE == 13)
        W = used;
    if (MISTAKE == 2)
        W = 1.0;
    *E = colour((float)(r / W), (float)(g / W), (float)(b / W));
    return true;
}
