// Stage NUMBER, toy: the contracts of its steps.
#pragma once

// NUMBER.1  Half of the value.
float halve(float value);

// NUMBER.2  The mean of two values, by step NUMBER.1.
float mean_of_two(float a, float b);
