// Stage 4, toy: the contracts of its steps.
#ifndef PHOTONLAB_STEPS_TOY_H
#define PHOTONLAB_STEPS_TOY_H

// 4.1  Half of the value.
float halve(float value);

// 4.2  The mean of two values, by step 4.1.
float mean_of_two(float a, float b);

#endif
