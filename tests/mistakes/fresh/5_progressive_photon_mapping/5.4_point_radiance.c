//1 pi_missing|factor          R² for πR²
//2 passes_forgotten     not over the passes
//3 factor|two_pi|circumference         2πR²
//4 radius_not_squared   πR
//5 -                    over the root of the count
//11 multiplied_by_passes   times the passes
//12 volume_of_a_ball       4/3 πR³
#include "photonlab.h"
Colour point_radiance(PointStatistics s, int n)
{
    float A = (MISTAKE == 1 ? 1.0f : MISTAKE == 3 ? 2.0f * PI : PI) * s.radius * (MISTAKE == 4 ? 1.0f : s.radius);
    float d = MISTAKE == 2 ? A : A * (float)n;
    if (MISTAKE == 11)
        d = A / (float)n;
    if (MISTAKE == 12)
        d = (float)n * 4.0f / 3.0f * PI * s.radius * s.radius * s.radius;
    if (MISTAKE == 5)
        d *= sqrtf(fmaxf(1.0f, s.count));
    return colour(s.flux.r / d, s.flux.g / d, s.flux.b / d);
}
