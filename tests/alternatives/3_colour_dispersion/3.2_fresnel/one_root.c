// With g² = n² + c² − 1 (Cook & Torrance 1982), n = 1/eta.
#include "photonlab.h"

float fresnel(float cos_i, float eta)
{
    float c = cos_i;
    float n = 1.0f / eta;
    float g2 = n * n - (1.0f - c) * (1.0f + c);
    if (!(g2 > 0.0f))
        return 1.0f;
    float g = sqrtf(g2);
    float minus = g - c, plus = g + c;
    float s = minus / plus;
    float ratio = (c * plus - 1.0f) / (c * minus + 1.0f);
    return 0.5f * s * s * (1.0f + ratio * ratio);
}
