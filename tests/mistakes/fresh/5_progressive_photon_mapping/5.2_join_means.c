//1 halves                a half each
//2 not_divided           only weighed
//3 one_more              one more
//4 added                 only added
//5 -                     the larger number of passes takes all
//11 weights_swapped        the wrong way round
//12 last_alone             b
#include "photonlab.h"
Colour join_means(Colour a, int m, Colour b, int n)
{
    double u = MISTAKE == 1 || MISTAKE == 4 ? 1.0 : (double)m, v = MISTAKE == 1 || MISTAKE == 4 ? 1.0 : (double)n;
    if (MISTAKE == 11) {
        double x = u;
        u = v, v = x;
    }
    if (MISTAKE == 12)
        return b;
    double w = MISTAKE == 2 || MISTAKE == 4 ? 1.0 : MISTAKE == 3 ? u + v + 1.0 : u + v;
    if (MISTAKE == 5)
        return m > n ? a : b;
    return colour((float)((u * (double)a.r + v * (double)b.r) / w), (float)((u * (double)a.g + v * (double)b.g) / w),
                  (float)((u * (double)a.b + v * (double)b.b) / w));
}
