// What step 1.3 draws: 1_cosine OUT.dat OUT.txt
// OUT.dat, block 0: cosθ, measured density, its standard error, for 20 cells of 100 000 samples; block 1: x and y of
// 500 samples, their feet on the unit disk. OUT.txt: means.
#include "photonlab.h"

#include <stdio.h>

enum { SAMPLES = 100000, CELLS = 20, FEET = 500 };

int main(int count, char **names)
{
    Error error = {{0}};
    FILE *data = count == 3 ? fopen(names[1], "w") : NULL;
    FILE *text = count == 3 ? fopen(names[2], "w") : NULL;
    if (!data || !text || !steps_load(NULL, &error)) {
        fprintf(stderr, "usage: 1_cosine OUT.dat OUT.txt %s\n", error.message);
        return 1;
    }
    long cells[CELLS] = {0};
    double sum = 0.0;
    long within_45 = 0;
    Rng rng = rng_create(1, 3);
    for (long i = 0; i < SAMPLES; i++) {
        Vec3 d = steps.scatter_diffuse(vec3(0, 0, 1), &rng);
        int cell = (int)(d.z * CELLS);
        cells[cell < CELLS ? cell : CELLS - 1]++;
        sum += (double)d.z;
        within_45 += d.z * d.z > 0.5f;
    }
    for (int c = 0; c < CELLS; c++) {
        double share = (double)cells[c] / SAMPLES;
        fprintf(data, "%.4f %.5f %.5f\n", (c + 0.5) / CELLS, share * CELLS,
                sqrt(share * (1.0 - share) / SAMPLES) * CELLS);
    }
    fprintf(data, "\n\n");
    for (int i = 0; i < FEET; i++) {
        Vec3 d = steps.scatter_diffuse(vec3(0, 0, 1), &rng);
        fprintf(data, "%.4f %.4f\n", (double)d.x, (double)d.y);
    }
    fprintf(text, "mean_cos %.4f\nwithin_45 %.4f\n", sum / SAMPLES, (double)within_45 / SAMPLES);
    return fclose(data) | fclose(text);
}
