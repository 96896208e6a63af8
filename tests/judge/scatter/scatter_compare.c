// Two scatters against each other: photons are counted and measured in cells (on one surface; there by one kind of
// path; of one colour; after so many surfaces), batch by batch of paths, since photons of one path depend on each other.
#include "judge/scatter/scatter_cells.h"
#include "judge/checks/statistics.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define FEWEST_HITS 20 // paths that reached a cell; with fewer, sums are not nearly normal

typedef struct {
    StageResult *result;
    const Scene *scene;
} Judge;

static void found(Judge *judge, int cell, ScatterStat stat, int axis, double yours, double reference, double z,
                  double p)
{
    StageResult *result = judge->result;
    result->tests++;
    if (p >= result->p)
        return;
    result->p = p;
    ScatterCell described = cell_describe(cell);
    scatter_describe(&described, stat, axis, yours, reference, fabs(z), judge->scene, result->message,
                     sizeof result->message);
}

// Of all paths that reached this cell, half should be the student's: exact, however few they are.
static void test_hits(Judge *judge, int c, const Cell *a, const Cell *b)
{
    double n = a->hits + b->hits;
    if (n >= FEWEST_HITS)
        found(judge, c, SCATTER_HITS, 0, a->hits, b->hits, (a->hits - b->hits) / sqrt(n),
              binomial_p((long)a->hits, (long)n, 0.5));
}

// Welch's test over the batches.
static void test_sums(Judge *judge, int c, const Cell *a, const Cell *b, size_t k, ScatterStat stat, int axis)
{
    Sums yours = {0}, reference = {0};
    double largest = 0.0;
    for (int i = 0; i < BATCHES; i++) {
        sums_add(&yours, a->batch[i].all[k]);
        sums_add(&reference, b->batch[i].all[k]);
        largest = fmax(largest, fmax(fabs(a->batch[i].all[k]), fabs(b->batch[i].all[k])));
    }
    double u = sums_error(&yours), v = sums_error(&reference), u2 = u * u, v2 = v * v;
    double difference = sums_mean(&yours) - sums_mean(&reference), error = sqrt(u2 + v2);
    if (error <= 1e-5 * largest) { // the same in every photon, as far as floats go
        if (fabs(difference) > 1e-3 * largest)
            found(judge, c, stat, axis, a->mean.all[k], b->mean.all[k], 1e3, 0.0);
        return;
    }
    double freedom = (u2 + v2) * (u2 + v2) / ((u2 * u2 + v2 * v2) / (BATCHES - 1));
    bool total = stat == SCATTER_COUNT || stat == SCATTER_FLUX;
    found(judge, c, stat, axis, a->mean.all[k] * (total ? a->count : 1.0), b->mean.all[k] * (total ? b->count : 1.0),
          difference / error, student_p(difference / error, freedom));
}

static void test_cell(Judge *judge, int c, const Cell *a, const Cell *b)
{
    test_hits(judge, c, a, b);
    if (a->hits < FEWEST_HITS || b->hits < FEWEST_HITS)
        return;
    test_sums(judge, c, a, b, MEASURE(count), SCATTER_COUNT, 0);
    for (int k = 0; k < 3; k++) {
        test_sums(judge, c, a, b, MEASURE(flux[0]) + (size_t)k, SCATTER_FLUX, k);
        test_sums(judge, c, a, b, MEASURE(place[0]) + (size_t)k, SCATTER_PLACE, k);
        test_sums(judge, c, a, b, MEASURE(way[0]) + (size_t)k, SCATTER_WAY, k);
        test_sums(judge, c, a, b, MEASURE(spread[0]) + (size_t)k, SCATTER_SPREAD, k);
    }
}

// A cell that holds all of its surface's photons tells nothing new.
static bool is_repeated(const Tally *a, const Tally *b, int c)
{
    ScatterCell cell = cell_describe(c);
    if (cell.material < 0 || (cell.path < 0 && cell.colour < 0))
        return false;
    int parent = CELL(material) + cell.material;
    return a->cells[c].count == a->cells[parent].count && b->cells[c].count == b->cells[parent].count;
}

// How many have a place or a power that is no number, or a power below 0.
static long count_odd(const ScatterPhotons *photons)
{
    long odd = 0;
    for (long i = 0; i < photons->count; i++) {
        const PhotonNumbers *p = &photons->items[i];
        bool good = true;
        for (int k = 0; k < 3; k++)
            good = good && fabsf(p->position[k]) < 1e6f && isfinite(p->from[k]) && p->power[k] >= 0.0f &&
                   p->power[k] < 1e12f;
        odd += !good;
    }
    return odd;
}

// What no right code does.
static bool find_certain(StageResult *result)
{
    const ScatterPhotons *yours = &result->yours;
    const PhotonNumbersHead *head = &yours->head;
    char *message = result->message;
    size_t size = sizeof result->message;
    long odd = count_odd(yours);
    if (odd > 0)
        snprintf(message, size, "%ld of %ld photons have a place or a power that is no sensible number", odd,
                 yours->count);
    else if (head->unsound > 0.0f)
        snprintf(message, size, "%.0f photons fly in a direction that is not of length 1", (double)head->unsound);
    else if (head->stored > (float)SCATTER_MOST)
        snprintf(message, size, "%.0f photons come to rest of %.0f emitted; about %.0f are right", (double)head->stored,
                 (double)head->emitted, (double)result->reference.head.stored);
    return *message;
}

void scatter_compare(StageResult *result, const Scene *scene)
{
    result->tests = 0;
    result->message[0] = '\0';
    result->p = find_certain(result) ? 0.0 : 1.0;
    if (result->p == 0.0)
        return;
    Judge judge = {result, scene};
    Tally *tallies[2] = {must(calloc(1, sizeof **tallies)), must(calloc(1, sizeof **tallies))};
    cells_fill((const ScatterPhotons *const[]){&result->yours, &result->reference}, tallies);
    for (int c = 0; c < CELLS; c++)
        if (!is_repeated(tallies[0], tallies[1], c))
            test_cell(&judge, c, &tallies[0]->cells[c], &tallies[1]->cells[c]);
    free(tallies[0]);
    free(tallies[1]);
}
