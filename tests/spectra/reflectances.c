// The two tables of lib/scene/spectrum.c, what a red and a blue wall reflect: the smoothest b_r, b_g, b_b ≥ 0 with sum 1 whose
// means under equal energy are pure red, green and blue. `--check` holds the library against them.
//
// Values stand at every 10 nm, linear between. Smooth is a small sum of squared steps. With x the red and blue values (green is the
// rest to 1), that is a quadratic form under six linear conditions and y = Cx + d ≥ 0; solved by alternating directions (Boyd et
// al. 2011): x minimises with y drawn towards z, z is y without what lies below 0, u keeps count of what was cut off.
#include "scene/spectrum.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ROWS    36
#define SIZE    (2 * ROWS)
#define ALL     (SIZE + 6) // unknowns and conditions
#define PULL    0.3
#define ROUNDS  20000
#define FINE    35000 // wavelengths of a mean
#define STEP_NM 10.0

// What row i counts in the mean of channel c.
static double counts[3][ROWS];

static void fill_counts(void)
{
    for (int s = 0; s < FINE; s++) {
        double place = (s + 0.5) / FINE * (ROWS - 1);
        int row = (int)place;
        Colour hue = spectral_colour((float)((double)WAVELENGTH_FIRST + place * STEP_NM));
        for (int c = 0; c < 3; c++) {
            double value = (double)colour_channel(hue, c) / FINE;
            counts[c][row] += value * (row + 1 - place);
            counts[c][row + 1] += value * (place - row);
        }
    }
}

// Adds w·s² to the form, with s = Σ ±(next − this) of the given halves: both stand for green.
static void add_smoothness(double m[ALL][ALL], bool red, bool blue)
{
    for (int i = 0; i + 1 < ROWS; i++) {
        double step[SIZE] = {0.0};
        for (int half = 0; half < 2; half++)
            if (half == 0 ? red : blue) {
                step[half * ROWS + i] = -1.0;
                step[half * ROWS + i + 1] = 1.0;
            }
        for (int a = 0; a < SIZE; a++)
            for (int b = 0; b < SIZE; b++)
                m[a][b] += step[a] * step[b];
    }
}

static void fill_matrix(double m[ALL][ALL])
{
    add_smoothness(m, true, false);
    add_smoothness(m, false, true);
    add_smoothness(m, true, true);
    for (int i = 0; i < ROWS; i++) { // PULL·CᵀC
        m[i][i] += 2.0 * PULL;
        m[ROWS + i][ROWS + i] += 2.0 * PULL;
        m[i][ROWS + i] += PULL;
        m[ROWS + i][i] += PULL;
    }
    for (int half = 0; half < 2; half++)
        for (int c = 0; c < 3; c++)
            for (int i = 0; i < ROWS; i++) {
                int a = half * ROWS + i, b = SIZE + half * 3 + c;
                m[a][b] = m[b][a] = counts[c][i];
            }
}

// Gauss and Jordan, with the largest pivot.
static void invert(double m[ALL][ALL], double inverse[ALL][ALL])
{
    for (int i = 0; i < ALL; i++)
        inverse[i][i] = 1.0;
    for (int i = 0; i < ALL; i++) {
        int best = i;
        for (int r = i + 1; r < ALL; r++)
            best = fabs(m[r][i]) > fabs(m[best][i]) ? r : best;
        for (int c = 0; c < ALL; c++) {
            double t = m[i][c], v = inverse[i][c];
            m[i][c] = m[best][c], m[best][c] = t;
            inverse[i][c] = inverse[best][c], inverse[best][c] = v;
        }
        double pivot = m[i][i];
        for (int c = 0; c < ALL; c++) {
            m[i][c] /= pivot;
            inverse[i][c] /= pivot;
        }
        for (int r = 0; r < ALL; r++) {
            double factor = m[r][i];
            for (int c = 0; c < ALL && r != i && factor != 0.0; c++) {
                m[r][c] -= factor * m[i][c];
                inverse[r][c] -= factor * inverse[i][c];
            }
        }
    }
}

static void solve(double z[3][ROWS])
{
    static double m[ALL][ALL], inverse[ALL][ALL];
    double u[3][ROWS] = {{0.0}};
    fill_matrix(m);
    invert(m, inverse);
    for (int round = 0; round < ROUNDS; round++) {
        double right[ALL] = {0.0}, x[SIZE];
        for (int i = 0; i < ROWS; i++)
            for (int half = 0; half < 2; half++)
                right[half * ROWS + i] = PULL * (z[half][i] - u[half][i] - (z[2][i] - u[2][i] - 1.0));
        right[SIZE] = right[SIZE + 5] = 1.0; // red of the red wall, blue of the blue one
        for (int a = 0; a < SIZE; a++) {
            x[a] = 0.0;
            for (int b = 0; b < ALL; b++)
                x[a] += inverse[a][b] * right[b];
        }
        for (int i = 0; i < ROWS; i++) {
            double y[3] = {x[i], x[ROWS + i], 1.0 - x[i] - x[ROWS + i]};
            for (int k = 0; k < 3; k++) {
                z[k][i] = fmax(y[k] + u[k][i], 0.0);
                u[k][i] += y[k] - z[k][i];
            }
        }
    }
}

int main(int count, char **arguments)
{
    bool check = count > 1 && strcmp(arguments[1], "--check") == 0;
    static double z[3][ROWS];
    fill_counts();
    solve(z);
    double worst = 0.0;
    for (int wall = 0; wall < 2; wall++) {
        Colour colours[2] = {{1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
        for (int i = 0; i < ROWS; i++) {
            float known = reflectance_at(colours[wall], WAVELENGTH_FIRST + (float)(STEP_NM * i));
            worst = fmax(worst, fabs((double)known - z[wall][i]));
            if (!check)
                printf("%.5ff,%s", z[wall][i], i % 9 == 8 ? "\n" : " ");
        }
    }
    if (check && worst > 2e-5)
        printf("the library's walls differ by %.6f\n", worst);
    return check && worst > 2e-5;
}
