// Stage 5, toy: the contracts of its steps.
#ifndef PHOTONLAB_STEPS_TOY_H
#define PHOTONLAB_STEPS_TOY_H

// 5.1  Half of the value.
float halve(float value);

// 5.2  The mean of two values, by step 5.1.
float mean_of_two(float a, float b);

#endif
