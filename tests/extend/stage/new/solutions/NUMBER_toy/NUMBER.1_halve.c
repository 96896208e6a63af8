// Step NUMBER.1: half of a value. Contract: lib/steps/NUMBER_toy.h
#include "photonlab.h"

float halve(float value)
{
    // BEGIN SOLUTION
    // 1. Take half of it.
    return 0.5f * value;
    // STUB: return value;
    // END SOLUTION
}
