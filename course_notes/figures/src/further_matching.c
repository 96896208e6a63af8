// CIE 1931 colour matching functions against wavelength in nm, and the linear sRGB that each wavelength would need.
//   further_matching DATA NUMBERS
#include "3_matching.h"

#include <stdio.h>

int main(int count, char **arguments)
{
    FILE *data = count == 3 ? fopen(arguments[1], "w") : NULL, *numbers = count == 3 ? fopen(arguments[2], "w") : NULL;
    if (!data || !numbers)
        return fprintf(stderr, "usage: further_matching DATA NUMBERS, both writable\n"), 2;
    double sum[3] = {0, 0, 0};
    for (int nm = 360; nm <= 830; nm++) {
        double xyz[3], rgb[3];
        matching_xyz(nm, xyz);
        xyz_to_srgb(xyz, rgb);
        for (int c = 0; c < 3; c++)
            sum[c] += xyz[c];
        if (nm >= 380 && nm <= 720 && nm % 2 == 0)
            fprintf(data, "%d %.5f %.5f %.5f %.5f %.5f %.5f\n", nm, xyz[0], xyz[1], xyz[2], rgb[0], rgb[1], rgb[2]);
    }
    for (int c = 0; c < 3; c++)
        fprintf(numbers, "integral_%c %.1f\n", "xyz"[c], sum[c]);
    return fclose(data) == 0 && fclose(numbers) == 0 ? 0 : 1;
}
