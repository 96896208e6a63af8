#include "judge/scatter/scatter.h"

#include <math.h>
#include <stdio.h>

// "31 % fewer", "2.4 times as many".
static void put_ratio(double yours, double reference, const char *more, const char *fewer, char *text, size_t size)
{
    double ratio = yours / reference;
    if (!(reference > 0.0))
        snprintf(text, size, "%s", more);
    else if (ratio > 2.0)
        snprintf(text, size, "%.3g times %s", ratio - 1.0, more);
    else if (fabs(ratio - 1.0) < 0.1)
        snprintf(text, size, "%.1f %% %s", 100.0 * fabs(ratio - 1.0), ratio > 1.0 ? more : fewer);
    else
        snprintf(text, size, "%.0f %% %s", 100.0 * fabs(ratio - 1.0), ratio > 1.0 ? more : fewer);
}

static void put_photons(const ScatterCell *cell, char *text, size_t size)
{
    static const char *const colours[] = {"white ", "red ", "green ", "blue "};
    static const char *const paths[] = {" straight from the light", " by way of mirrors and glass alone",
                                        " after a diffuse or glossy bounce"};
    char bounce[40] = "";
    if (cell->bounce >= 0)
        snprintf(bounce, sizeof bounce, " that met %d surface%s before", cell->bounce, cell->bounce == 1 ? "" : "s");
    snprintf(text, size, "%sphotons%s%s", cell->colour >= 0 ? colours[cell->colour] : "",
             cell->path >= 0 ? paths[cell->path] : "", bounce);
}

void scatter_describe(const ScatterCell *cell, ScatterStat stat, int axis, double yours, double reference, double z,
                      const Scene *scene, char *text, size_t size)
{
    static const char *const channels[] = {"red", "green", "blue"};
    const char *where = "scene";
    if (cell->material >= 0)
        where = scene && (size_t)cell->material < scene->material_count ? scene->materials[cell->material].name : "?";
    char photons[160], ratio[60];
    put_photons(cell, photons, sizeof photons);
    switch (stat) {
    case SCATTER_HITS:
    case SCATTER_COUNT:
        put_ratio(yours, reference, "more", "fewer", ratio, sizeof ratio);
        snprintf(text, size, "the %s gets %s %s than right (z = %.3g)", where, ratio, photons, z);
        break;
    case SCATTER_FLUX:
        put_ratio(yours, reference, "more", "less", ratio, sizeof ratio);
        snprintf(text, size, "the %s gets %s %s power from %s than right (z = %.3g)", where, ratio, channels[axis],
                 photons, z);
        break;
    case SCATTER_PLACE:
        snprintf(text, size, "%s land on the %s at %c = %.3f m on average, right: %.3f m (z = %.3g)", photons, where,
                 'x' + axis, yours, reference, z);
        break;
    case SCATTER_SPREAD:
        snprintf(text, size, "%s lie on the %s within ±%.3f m along %c on average, right: ±%.3f m (z = %.3g)", photons,
                 where, sqrt(fmax(0.0, yours)), 'x' + axis, sqrt(fmax(0.0, reference)), z);
        break;
    case SCATTER_WAY:
        snprintf(text, size, "%s come to the %s from a direction of %c = %.3f on average, right: %.3f (z = %.3g)",
                 photons, where, 'x' + axis, yours, reference, z);
        break;
    }
}
