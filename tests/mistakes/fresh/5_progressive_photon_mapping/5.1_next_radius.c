//1 root_missing          the share itself
//2 alpha_alone           α whatever the pass
//3 counted_from_0        i + 1 for i
//4 squared               the share squared
//5 -                     the logarithm of the pass
//11 upside_down           larger
//12 one_minus_alpha       1 − α
//13 cube_root             the third root
#include "photonlab.h"
float next_radius(float r, int i, float a)
{
    double k = MISTAKE == 3 ? i + 1.0 : (double)i, q = (k + (double)a) / (k + 1.0);
    if (MISTAKE == 11)
        q = 1.0 / q;
    if (MISTAKE == 12)
        q = (k + 1.0 - (double)a) / (k + 1.0);
    if (MISTAKE == 13)
        return (float)((double)r * cbrt(q));
    if (MISTAKE == 2)
        q = (double)a;
    if (MISTAKE == 5)
        q = 1.0 / (1.0 + (1.0 - (double)a) * log1p(k));
    return (float)((double)r * (MISTAKE == 1 ? q : MISTAKE == 4 ? q * q : sqrt(q)));
}
