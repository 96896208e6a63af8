// Step NUMBER.2: the mean of two values. Contract: lib/steps/NUMBER_toy.h
#include "photonlab.h"

float mean_of_two(float a, float b)
{
    // BEGIN SOLUTION
    // 1. Halve the sum.
    return steps.halve(a + b);
    // STUB: return a + b;
    // END SOLUTION
}
