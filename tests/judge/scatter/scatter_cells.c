#include "judge/scatter/scatter_cells.h"

#include <math.h>

// The cells that a photon belongs to; how many.
static int cells_of(const PhotonNumbers *photon, int cells[6])
{
    int material = (int)photon->material, path = (int)photon->path, bounce = (int)photon->bounce;
    cells[0] = CELL(scene);
    cells[1] = CELL(material) + material;
    cells[2] = CELL(path) + path;
    cells[3] = CELL(path_on_material) + 3 * material + path;
    cells[4] = CELL(colour_on_material) + 4 * material + (int)photon->colour;
    cells[5] = CELL(bounce) + (bounce < BOUNCES ? bounce : BOUNCES - 1);
    return 6;
}

ScatterCell cell_describe(int cell)
{
    ScatterCell c = {-1, -1, -1, -1};
    if (cell >= CELL(bounce)) {
        c.bounce = cell - CELL(bounce);
    } else if (cell >= CELL(colour_on_material)) {
        c.material = (cell - CELL(colour_on_material)) / 4;
        c.colour = (cell - CELL(colour_on_material)) % 4;
    } else if (cell >= CELL(path_on_material)) {
        c.material = (cell - CELL(path_on_material)) / 3;
        c.path = (cell - CELL(path_on_material)) % 3;
    } else if (cell >= CELL(path)) {
        c.path = cell - CELL(path);
    } else if (cell >= CELL(material)) {
        c.material = cell - CELL(material);
    }
    return c;
}

static Measures measure(const PhotonNumbers *photon)
{
    Measures measures = {.of = {.count = 1.0}};
    for (int k = 0; k < 3; k++) {
        measures.of.flux[k] = (double)photon->power[k];
        measures.of.place[k] = (double)photon->position[k];
        measures.of.way[k] = (double)photon->from[k];
    }
    return measures;
}

static void find_means(const ScatterPhotons *photons, Tally *tally)
{
    int cells[6];
    for (int c = 0; c < CELLS; c++)
        tally->cells[c].last = -1.0;
    for (long i = 0; i < photons->count; i++) {
        double path = (double)photons->items[i].emission;
        Measures measures = measure(&photons->items[i]);
        for (int n = cells_of(&photons->items[i], cells); n-- > 0;) {
            Cell *cell = &tally->cells[cells[n]];
            cell->count += 1.0;
            cell->hits += cell->last != path;
            cell->last = path;
            for (size_t k = 0; k < MEASURES; k++)
                cell->mean.all[k] += measures.all[k];
        }
    }
    for (int c = 0; c < CELLS; c++)
        for (size_t k = 0; k < MEASURES && tally->cells[c].count > 0.0; k++)
            tally->cells[c].mean.all[k] /= tally->cells[c].count;
}

static void find_centres(const Tally *yours, const Tally *reference, Measures centres[CELLS])
{
    for (int c = 0; c < CELLS; c++) {
        const Cell *a = &yours->cells[c], *b = &reference->cells[c];
        double n = a->count + b->count;
        for (int k = 0; k < 3 && n > 0.0; k++) {
            centres[c].of.place[k] = (a->count * a->mean.of.place[k] + b->count * b->mean.of.place[k]) / n;
            centres[c].of.way[k] = (a->count * a->mean.of.way[k] + b->count * b->mean.of.way[k]) / n;
        }
    }
}

static double square_off(const Measures *measures, const Measures *centre, int axis)
{
    double off = measures->of.place[axis] - centre->of.place[axis];
    return off * off;
}

// Places and ways count from the centre, spreads from their own.
static void add_squares(const ScatterPhotons *photons, const Measures *centres, Tally *tally, double squares[CELLS][3])
{
    int cells[6];
    for (long i = 0; i < photons->count; i++) {
        Measures measures = measure(&photons->items[i]);
        for (int n = cells_of(&photons->items[i], cells); n-- > 0;) {
            Cell *cell = &tally->cells[cells[n]];
            for (int k = 0; k < 3; k++) {
                double square = square_off(&measures, &centres[cells[n]], k);
                squares[cells[n]][k] += square;
                cell->mean.of.spread[k] += square / cell->count;
            }
        }
    }
}

static void add_batches(const ScatterPhotons *photons, const Measures *centres, Tally *tally)
{
    int cells[6];
    for (long i = 0; i < photons->count; i++) {
        const PhotonNumbers *photon = &photons->items[i];
        long batch = (long)((double)photon->emission * BATCHES / (double)photons->head.emitted);
        Measures measures = measure(photon);
        for (int n = cells_of(photon, cells); n-- > 0;) {
            const Measures *centre = &centres[cells[n]];
            Measures *sums = &tally->cells[cells[n]].batch[batch];
            for (int k = 0; k < 3; k++)
                measures.of.spread[k] = square_off(&measures, centre, k);
            for (size_t k = 0; k < MEASURES; k++)
                sums->all[k] += measures.all[k] - centre->all[k];
        }
    }
}

void cells_fill(const ScatterPhotons *const photons[2], Tally *tallies[2])
{
    Measures centres[CELLS] = {{{0}}};
    double squares[CELLS][3] = {{0}};
    for (int i = 0; i < 2; i++)
        find_means(photons[i], tallies[i]);
    find_centres(tallies[0], tallies[1], centres);
    for (int i = 0; i < 2; i++)
        add_squares(photons[i], centres, tallies[i], squares);
    for (int c = 0; c < CELLS; c++)
        for (int k = 0; k < 3; k++)
            centres[c].of.spread[k] =
                squares[c][k] / fmax(1.0, tallies[0]->cells[c].count + tallies[1]->cells[c].count);
    for (int i = 0; i < 2; i++)
        add_batches(photons[i], centres, tallies[i]);
}
