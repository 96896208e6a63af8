// What live figures draw, as numbers: an exported function fills the list anew and says how many there are. What a step
// computes is asked of the step.
#pragma once

#include "web/module/web.h"

void numbers_begin(void);
void numbers_add(double number); // past the 65536th: forgotten
int numbers_count(void);

static inline void numbers_add_two(double x, double y)
{
    numbers_add(x);
    numbers_add(y);
}
