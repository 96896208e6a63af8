// CIE 1931 colour matching functions as sums of Gaussians of two widths (Wyman, Sloan & Shirley 2013), and linear sRGB.
#pragma once

#include <math.h>

static inline double bell(double nm, double peak, double left, double right)
{
    double x = (nm - peak) * (nm < peak ? left : right);
    return exp(-0.5 * x * x);
}

static inline void matching_xyz(double nm, double xyz[3])
{
    xyz[0] = 0.362 * bell(nm, 442.0, 0.0624, 0.0374) + 1.056 * bell(nm, 599.8, 0.0264, 0.0323) -
             0.065 * bell(nm, 501.1, 0.0490, 0.0382);
    xyz[1] = 0.821 * bell(nm, 568.8, 0.0213, 0.0247) + 0.286 * bell(nm, 530.9, 0.0613, 0.0322);
    xyz[2] = 1.217 * bell(nm, 437.0, 0.0845, 0.0278) + 0.681 * bell(nm, 459.0, 0.0385, 0.0725);
}

// IEC 61966-2-1. Spectral colours lie outside sRGB: one or two channels are negative.
static inline void xyz_to_srgb(const double xyz[3], double rgb[3])
{
    static const double m[3][3] = {{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}};
    for (int c = 0; c < 3; c++)
        rgb[c] = m[c][0] * xyz[0] + m[c][1] * xyz[1] + m[c][2] * xyz[2];
}
