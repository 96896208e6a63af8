// How often rand()/((float)RAND_MAX + 1) is exactly 1 where RAND_MAX = 2³¹ − 1: 1_rand OUT.txt
#include <stdint.h>
#include <stdio.h>

int main(int count, char **names)
{
    const int32_t most = 2147483647;
    FILE *text = count == 2 ? fopen(names[1], "w") : NULL;
    if (!text)
        return 1;
    int ones = 0;
    for (int32_t below = 0; below < 1000; below++) {
        volatile float u = (float)(most - below) / ((float)most + 1.0f);
        ones += u >= 1.0f;
    }
    fprintf(text, "values_that_give_1 %d\none_in_million %.1f\n", ones, 2147483648.0 / ones / 1e6);
    return fclose(text);
}
