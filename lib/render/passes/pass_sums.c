#include "render/passes/pass_sums.h"
#include "base/parallel.h"
#include "steps/steps.h"

#include <string.h>

// a becomes the mean over both.
static void join(Image *a, int m, const Image *b, int n)
{
    OMP(omp parallel for schedule(static))
    for (int row = 0; row < a->height; row++)
        for (int column = 0; column < a->width; column++) {
            Colour *pixel = image_at(a, column, row);
            *pixel = steps.join_means(*pixel, m, *image_at(b, column, row), n);
        }
}

void pass_sums_add(PassSums *sums, PassRun run)
{
    sums->runs[sums->count++] = run;
    while (sums->count > 1) {
        PassRun *a = &sums->runs[sums->count - 2];
        PassRun *b = &sums->runs[sums->count - 1];
        if (a->count != b->count || a->first % (2 * a->count) != 0)
            return;
        join(&a->mean, a->count, &b->mean, b->count);
        a->count += b->count;
        image_free(&b->mean);
        sums->count--;
    }
}

bool pass_sums_mean(const PassSums *sums, Image *mean, Error *error)
{
    const PassRun *last = &sums->runs[sums->count - 1];
    if (!image_create(mean, last->mean.width, last->mean.height, error))
        return false;
    memcpy(mean->pixels, last->mean.pixels, (size_t)mean->width * (size_t)mean->height * sizeof *mean->pixels);
    int count = last->count;
    for (int i = sums->count - 2; i >= 0; i--) { // the smaller ones first
        join(mean, count, &sums->runs[i].mean, sums->runs[i].count);
        count += sums->runs[i].count;
    }
    return true;
}

void pass_sums_free(PassSums *sums)
{
    while (sums->count > 0)
        image_free(&sums->runs[--sums->count].mean);
}
