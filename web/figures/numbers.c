#include "web/figures/numbers.h"

#include "steps/steps.h"

#define MOST 65536
static double numbers[MOST];
static int count;

void numbers_begin(void)
{
    count = 0;
    Error error;
    steps_load(NULL, &error);
}

void numbers_add(double number)
{
    if (count < MOST)
        numbers[count++] = number;
}

int numbers_count(void)
{
    return count;
}

const double *EXPORT(web_numbers)(void)
{
    return numbers;
}
