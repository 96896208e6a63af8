// In double precision, by the area of the disk.
#include "photonlab.h"

float next_radius(float radius, int pass, float alpha)
{
    double square = (double)radius * (double)radius;
    square *= (pass + (double)alpha) / (pass + 1);
    return (float)sqrt(square);
}
