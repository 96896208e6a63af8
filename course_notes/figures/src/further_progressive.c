// Progressive photon mapping at one point (Knaus & Zwicker 2011): passes whose radius shrinks are averaged.
//   further_progressive DATA NUMBERS
// The photons lie on a disk of radius 1 m about the point, where the irradiance is 1 + s² at distance s: the truth in
// the middle is 1, and an estimate with radius r sees 1 + r²/2. Repeated with many seeds; DATA: passes, then for each
// alpha the radius by its first value, and the rms error.
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

enum { PHOTONS = 100, PASSES = 10000, RUNS = 1000, MARKS = 41, ALPHAS = 3 };

static const double alphas[ALPHAS] = {1.0 / 3.0, 2.0 / 3.0, 1.0};
static const double first_radius2 = 0.25; // m²

// From 1 to PASSES, evenly on a log axis, each once.
static int list_marks(int marks[MARKS])
{
    int count = 0;
    for (int i = 0; i < MARKS; i++) {
        int mark = (int)(pow(PASSES, (double)i / (MARKS - 1)) + 0.5);
        if (count == 0 || mark > marks[count - 1])
            marks[count++] = mark;
    }
    return count;
}

// One pass: the estimate from the photons within the radius. s² of a uniform point on the disk is uniform.
static double estimate(double radius2, Rng *rng)
{
    double sum = 0.0;
    for (int i = 0; i < PHOTONS; i++) {
        double s2 = (double)rng_float(rng);
        if (s2 < radius2)
            sum += 1.0 + s2;
    }
    return sum / (PHOTONS * radius2); // Φ = (1 + s²)·π/PHOTONS, over πr²
}

// Adds the squared errors of one run at the marks.
static void run(double alpha, uint64_t number, const int *marks, double *squares)
{
    Rng rng = rng_create(5, number);
    double radius2 = first_radius2, sum = 0.0;
    for (int i = 1, m = 0; i <= PASSES; i++) {
        sum += estimate(radius2, &rng);
        if (i == marks[m]) {
            double error = sum / i - 1.0;
            squares[m++] += error * error;
        }
        radius2 *= (i + alpha) / (i + 1.0);
    }
}

static double radius2_at(double alpha, int pass)
{
    double ratio = 1.0;
    for (int i = 1; i < pass; i++)
        ratio *= (i + alpha) / (i + 1.0);
    return ratio;
}

int main(int count, char **arguments)
{
    FILE *data = count == 3 ? fopen(arguments[1], "w") : NULL, *numbers = count == 3 ? fopen(arguments[2], "w") : NULL;
    if (!data || !numbers)
        return fprintf(stderr, "usage: further_progressive DATA NUMBERS, both writable\n"), 2;
    int marks[MARKS], mark_count = list_marks(marks);
    static double squares[ALPHAS][MARKS];
    for (int a = 0; a < ALPHAS; a++)
        for (int r = 0; r < RUNS; r++)
            run(alphas[a], (uint64_t)(a * RUNS + r), marks, squares[a]);
    for (int m = 0; m < mark_count; m++) {
        fprintf(data, "%d", marks[m]);
        for (int a = 0; a < ALPHAS; a++)
            fprintf(data, " %.5f %.5f", sqrt(radius2_at(alphas[a], marks[m])), sqrt(squares[a][m] / RUNS));
        fprintf(data, "\n");
    }
    static const char *const names[ALPHAS] = {"third", "two_thirds", "one"};
    for (int a = 0; a < ALPHAS; a++) {
        fprintf(numbers, "ratio2_1000_%s %.6f\n", names[a], radius2_at(alphas[a], 1000));
        fprintf(numbers, "radius_1000_%s %.3f\n", names[a], sqrt(radius2_at(alphas[a], 1000)));
        int from = mark_count - 1; // slope over the last two decades
        while (from > 0 && marks[from] * 100 > PASSES)
            from--;
        double fall = log(squares[a][mark_count - 1] / squares[a][from]) / 2.0;
        fprintf(numbers, "slope_%s %.2f\n", names[a], fall / log((double)PASSES / marks[from]));
        fprintf(numbers, "rms_%s %.3f\n", names[a], sqrt(squares[a][mark_count - 1] / RUNS));
    }
    return fclose(data) == 0 && fclose(numbers) == 0 ? 0 : 1;
}
