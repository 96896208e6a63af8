// What is left of the blur along a straight edge: 5_jump NUMBERS
// Light is 1 on one side of a line and 0 on the other. A pass of radius r says at distance d from it, on the dark side, how
// much of its disk lies beyond. The square of the mean over passes, summed over all d: how wrong pictures are for the edge
// alone, without any noise.
#include <math.h>
#include <stdio.h>

enum { PASSES = 10000, PLACES = 4000 };

// The share of a unit disk beyond a line at distance u of its middle.
static double beyond(double u)
{
    return u < 1.0 ? (acos(u) - u * sqrt(1.0 - u * u)) / 3.14159265358979 : 0.0;
}

int main(int count, char **arguments)
{
    FILE *numbers = count == 2 ? fopen(arguments[1], "w") : NULL;
    if (!numbers)
        return fprintf(stderr, "usage: 5_jump NUMBERS, writable\n"), 2;
    static double sums[PLACES];
    for (int thirds = 1; thirds <= 2; thirds++) {
        double area = 1.0, first = 0.0, hundred = 0.0, alpha = thirds / 3.0;
        for (int p = 0; p < PLACES; p++)
            sums[p] = 0.0;
        for (int i = 1; i <= PASSES; i++) {
            double square = 0.0, radius = sqrt(area);
            for (int p = 0; p < PLACES; p++) {
                sums[p] += beyond((p + 0.5) / PLACES / radius);
                square += sums[p] * sums[p] / i / i;
            }
            first = i == 1 ? square : first;
            hundred = i == 100 ? square : hundred;
            if (i == 1000)
                fprintf(numbers, "left_1000_%d %.3f\n", thirds, square / first);
            if (i == PASSES)
                fprintf(numbers, "slope_%d %.2f\n", thirds, log(square / hundred) / log(PASSES / 100.0));
            area *= (i + alpha) / (i + 1.0);
        }
    }
    return fclose(numbers) == 0 ? 0 : 1;
}
