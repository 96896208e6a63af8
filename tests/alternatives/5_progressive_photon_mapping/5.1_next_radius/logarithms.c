// By logarithms, of which a root takes one half.
#include "photonlab.h"

float next_radius(float radius, int pass, float alpha)
{
    double change = log((double)pass + (double)alpha) - log((double)pass + 1.0);
    return radius * (float)exp(0.5 * change);
}
