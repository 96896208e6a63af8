// Data for chapter 3's plots, computed by the reference steps: 3_curves fresnel|index|deviation|total
#include "3_prism.h"

#include <string.h>

// Degrees; then R_s, R_p (from the formula) and R (step 3.2) into glass of 1.5, and the same three out of it.
static void print_fresnel(void)
{
    for (int tenth = 0; tenth < 900; tenth += 2) {
        double cos_i = cos(tenth / 10.0 / DEGREES);
        printf("%.1f", tenth / 10.0);
        for (int way = 0; way < 2; way++) {
            double eta = way == 0 ? 1.0 / 1.5 : 1.5;
            double cos2_t = 1.0 - eta * eta * (1.0 - cos_i * cos_i), cos_t = sqrt(fmax(cos2_t, 0.0));
            double r_s = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
            double r_p = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
            if (cos2_t <= 0.0)
                r_s = r_p = 1.0;
            printf(" %.5f %.5f %.5f", r_s * r_s, r_p * r_p, (double)steps.fresnel((float)cos_i, (float)eta));
        }
        printf("\n");
    }
}

// Wavelength in nm; n of six glasses; n − n_d of the six; Cauchy's n − n_d for the last two.
static void print_index(void)
{
    static const char *const names[] = {"water_20C", "fused_silica", "N-BK7", "diamond", "SF10", "N-SF11"};
    for (int nm = 400; nm <= 700; nm += 2) {
        printf("%d", nm);
        for (int i = 0; i < 6; i++)
            printf(" %.6f", index_of(names[i], nm));
        for (int i = 0; i < 6; i++)
            printf(" %.6f", index_of(names[i], nm) - index_of(names[i], 587.562));
        for (int i = 4; i < 6; i++) {
            double n_d = index_of(names[i], 587.562);
            double abbe = (n_d - 1.0) / (index_of(names[i], 486.133) - index_of(names[i], 656.273));
            printf(" %.6f", cauchy_index(n_d, abbe, nm) - n_d);
        }
        printf("\n");
    }
}

// Incidence on the 60° prism of N-SF11 in degrees; the deviation of red, green, blue (NaN: totally reflected).
static void print_deviation(void)
{
    static const double bands[3] = {WAVELENGTH_RED, WAVELENGTH_GREEN, WAVELENGTH_BLUE};
    for (int step = 800; step <= 1799; step++) {
        printf("%.2f", step / 20.0);
        for (int c = 0; c < 3; c++)
            printf(" %.4f", prism_deviation(index_of("N-SF11", bands[c]), step / 20.0));
        printf("\n");
    }
}

// Rays that meet the surface y = 0 at the origin, from inside glass of 1.5 (below): where they come from, where they go,
// and how much of the light goes there. The reflected share first, then the refracted one.
static void print_total(void)
{
    static const double degrees[] = {0.0, 20.0, 35.0, 41.0, 50.0, 65.0};
    for (int i = 0; i < 6; i++) {
        Vec3 d = at_angle(90.0 - degrees[i]), facing = vec3(0, -1, 0), on;
        float share = steps.fresnel((float)cos(degrees[i] / DEGREES), 1.5f);
        Vec3 back = steps.reflect(d, facing);
        printf("%g %.4f %.4f %.4f %.4f %.3f", degrees[i], (double)-d.x, (double)-d.y, (double)back.x, (double)back.y,
               (double)share);
        if (steps.refract(d, facing, 1.5f, &on))
            printf(" %.4f %.4f %.3f\n", (double)on.x, (double)on.y, 1.0 - (double)share);
        else
            printf(" 0 0 0\n");
    }
}

int main(int count, char **arguments)
{
    load_reference_steps();
    const char *which = count == 2 ? arguments[1] : "";
    if (strcmp(which, "fresnel") == 0)
        print_fresnel();
    else if (strcmp(which, "index") == 0)
        print_index();
    else if (strcmp(which, "deviation") == 0)
        print_deviation();
    else if (strcmp(which, "total") == 0)
        print_total();
    else
        return fprintf(stderr, "usage: 3_curves fresnel|index|deviation|total\n"), 2;
    return 0;
}
