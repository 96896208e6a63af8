// By the part of the area that is cut off; where none is, the radius stays as it is.
#include "photonlab.h"

float next_radius(float radius, int pass, float alpha)
{
    if (alpha >= 1.0f)
        return radius;
    float cut = (1.0f - alpha) / (float)(pass + 1);
    return radius * sqrtf(1.0f - cut);
}
