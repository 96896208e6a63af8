//1 ratio_inverted     n_t/n_i
//2 total_not_tested|total_goes_straight|total_grazes|total_reflects|total_writes   no test of total reflection
//3 root_missing       cos² for cos
//4 eta_not_squared    eta for its square
//5 eta_missing        d for ηd
//6 -                  the tangent of the angle
//11 plus_for_minus  the other side
//12 angles_for_sines    angles in place of sines
#include "photonlab.h"
bool refract(Vec3 d, Vec3 n, float eta, Vec3 *t)
{
    double h = MISTAKE == 1 ? 1.0 / (double)eta : (double)eta, ci = -(double)vec3_dot(d, n), s2 = 1.0 - ci * ci;
    double k = 1.0 - (MISTAKE == 4 ? h : h * h) * (MISTAKE == 6 ? s2 / fmax(1e-6, ci * ci) : s2);
    if (k < 0.0) {
        if (MISTAKE != 2)
            return false;
        k = 0.0;
    }
    if (MISTAKE == 12)
        k = pow(cos(fmin(h * acos(fmin(1.0, ci)), 1.5707)), 2.0);
    double ct = MISTAKE == 3 ? k : sqrt(k), a = MISTAKE == 5 ? 1.0 : h, b = MISTAKE == 11 ? h * ci + ct : h * ci - ct;
    *t = vec3((float)(a * d.x + b * n.x), (float)(a * d.y + b * n.y), (float)(a * d.z + b * n.z));
    return true;
}
