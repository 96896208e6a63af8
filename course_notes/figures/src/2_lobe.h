// What the programs of chapter 2 share: integrals of the lobe in double, by their closed forms.
// θ: angle of the mirror direction to the normal, rad; n ≥ 1: exponent.
#pragma once

#include "photonlab.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define RADIANS (M_PI / 180.0)

// S_n(θ) = ∫₀^θ sinⁿx dx, by Simpson's rule.
static inline double sine_integral(double n, double theta)
{
    enum { PIECES = 2000 };
    double sum = 0.0;
    for (int i = 0; i <= PIECES; i++) {
        double weight = i == 0 || i == PIECES ? 1.0 : (i % 2 ? 4.0 : 2.0);
        sum += weight * pow(sin(theta * i / PIECES), n);
    }
    return sum * theta / PIECES / 3.0;
}

// I_P = ∫cosⁿα dω above the surface.
static inline double lobe_above(double n, double theta)
{
    return M_PI / (n + 1.0) * (2.0 - sine_integral(n, theta) / sine_integral(n, M_PI / 2.0));
}

// I_M = ∫cosⁿα cosθ_o dω above the surface.
static inline double lobe_weighted(double n, double theta)
{
    double c = cos(theta);
    double rest = pow(sin(theta), n) - n * c * sine_integral(n - 1.0, theta);
    return (2.0 * M_PI * c + 2.0 * sine_integral(n, M_PI / 2.0) * rest) / (n + 2.0);
}

// Arrival at angle theta to the normal +z; `mirror` is where a mirror would send it.
static inline Vec3 arrival(double theta, Vec3 *mirror)
{
    *mirror = vec3((float)sin(theta), 0.0f, (float)cos(theta));
    return vec3(mirror->x, 0.0f, -mirror->z);
}

// The file named by the argument of this number, or NULL with a message.
static inline FILE *open_output(int count, char **names, int number)
{
    FILE *file = number < count ? fopen(names[number], "w") : NULL;
    if (!file)
        fprintf(stderr, "%s: cannot write output file %d\n", names[0], number);
    return file;
}

// Opens both outputs, a table to be drawn and lines of numbers, and loads the reference steps. False after a message.
static inline bool start_figure(int count, char **names, FILE **data, FILE **text)
{
    Error error = {{0}};
    *data = open_output(count, names, 1);
    *text = open_output(count, names, 2);
    if (*data && *text && steps_load(NULL, &error))
        return true;
    fprintf(stderr, "%s\n", error.message);
    return false;
}
