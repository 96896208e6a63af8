// Stage NUMBER, toy: the contracts of its steps.
#ifndef PHOTONLAB_STEPS_TOY_H
#define PHOTONLAB_STEPS_TOY_H

// NUMBER.1  Half of the value.
float halve(float value);

// NUMBER.2  The mean of two values, by step NUMBER.1.
float mean_of_two(float a, float b);

#endif
