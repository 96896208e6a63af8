// A root of each, and their ratio.
#include "photonlab.h"

float next_radius(float radius, int pass, float alpha)
{
    float i = (float)pass;
    float above = sqrtf(i + alpha), below = sqrtf(i + 1.0f);
    return above / below * radius;
}
