#include "judge/scatter/scatter_cells.h"

#include "judge/probe/probe_scatter.h"

#include <math.h>

static const float *photon_at(const Photons *photons, long i)
{
    return photons->numbers + SCATTER_HEAD + i * SCATTER_NUMBERS;
}

// The cells that a photon belongs to; how many.
static int cells_of(const float *photon, int cells[6])
{
    int material = (int)photon[SCATTER_MATERIAL], path = (int)photon[SCATTER_PATH];
    int bounce = (int)photon[SCATTER_BOUNCE];
    cells[0] = 0;
    cells[1] = CELLS_MATERIAL + material;
    cells[2] = CELLS_PATH + path;
    cells[3] = CELLS_ON_PATH + 3 * material + path;
    cells[4] = CELLS_IN_COLOUR + 4 * material + (int)photon[SCATTER_COLOUR];
    cells[5] = CELLS_BOUNCE + (bounce < BOUNCES ? bounce : BOUNCES - 1);
    return 6;
}

ScatterCell cell_describe(int cell)
{
    ScatterCell c = {-1, -1, -1, -1};
    if (cell >= CELLS_BOUNCE) {
        c.bounce = cell - CELLS_BOUNCE;
    } else if (cell >= CELLS_IN_COLOUR) {
        c.material = (cell - CELLS_IN_COLOUR) / 4;
        c.colour = (cell - CELLS_IN_COLOUR) % 4;
    } else if (cell >= CELLS_ON_PATH) {
        c.material = (cell - CELLS_ON_PATH) / 3;
        c.path = (cell - CELLS_ON_PATH) % 3;
    } else if (cell >= CELLS_PATH) {
        c.path = cell - CELLS_PATH;
    } else if (cell >= CELLS_MATERIAL) {
        c.material = cell - CELLS_MATERIAL;
    }
    return c;
}

static bool whole_below(float value, double limit)
{
    return value >= 0.0f && (double)value < limit && value == floorf(value);
}

// Whatever the steps do, the library stores photons like this.
static bool is_well_formed(const Photons *photons)
{
    float path = 0.0f;
    for (long i = 0; i < photons->count; i++) {
        const float *p = photon_at(photons, i);
        if (!whole_below(p[SCATTER_COLOUR], 4) || !whole_below(p[SCATTER_PATH], 3) ||
            !whole_below(p[SCATTER_MATERIAL], SCATTER_MOST_MATERIALS) || !whole_below(p[SCATTER_BOUNCE], 256) ||
            !whole_below(p[SCATTER_EMISSION], (double)photons->emitted) || p[SCATTER_EMISSION] < path)
            return false;
        path = p[SCATTER_EMISSION];
    }
    return true;
}

bool photons_take(const float *numbers, long room, long emitted, Photons *photons)
{
    *photons = (Photons){numbers, 0, emitted};
    bool good = whole_below(numbers[SCATTER_STORED], 1e12) && whole_below(numbers[SCATTER_UNSOUND], 1e12) &&
                numbers[SCATTER_EMITTED] == (float)emitted;
    if (!good)
        return false;
    photons->count = numbers[SCATTER_STORED] < (float)room ? (long)numbers[SCATTER_STORED] : room;
    return is_well_formed(photons);
}

long photons_count_odd(const Photons *photons)
{
    long odd = 0;
    for (long i = 0; i < photons->count; i++) {
        const float *p = photon_at(photons, i);
        bool good = true;
        for (int k = 0; k < 3; k++)
            good = good && fabsf(p[SCATTER_POSITION + k]) < 1e6f && isfinite(p[SCATTER_FROM + k]) &&
                   p[SCATTER_POWER + k] >= 0.0f && p[SCATTER_POWER + k] < 1e12f;
        odd += !good;
    }
    return odd;
}

static void measure(const float *photon, double values[PLACE + 6])
{
    values[COUNT] = 1.0;
    for (int k = 0; k < 3; k++) {
        values[FLUX + k] = (double)photon[SCATTER_POWER + k];
        values[PLACE + k] = (double)photon[SCATTER_POSITION + k];
        values[WAY + k] = (double)photon[SCATTER_FROM + k];
    }
}

static void find_means(const Photons *photons, Side *side)
{
    double values[SPREAD];
    int cells[6];
    for (int c = 0; c < CELLS; c++)
        side->cells[c].last = -1.0;
    for (long i = 0; i < photons->count; i++) {
        const float *photon = photon_at(photons, i);
        measure(photon, values);
        for (int n = cells_of(photon, cells); n-- > 0;) {
            Cell *cell = &side->cells[cells[n]];
            double path = (double)photon[SCATTER_EMISSION];
            cell->count += 1.0;
            cell->hits += cell->last != path;
            cell->last = path;
            for (int k = 0; k < SPREAD; k++)
                cell->mean[k] += values[k];
        }
    }
    for (int c = 0; c < CELLS; c++)
        for (int k = 0; k < SPREAD && side->cells[c].count > 0.0; k++)
            side->cells[c].mean[k] /= side->cells[c].count;
}

static void find_centres(const Side *yours, const Side *reference, double centres[CELLS][SUMS])
{
    for (int c = 0; c < CELLS; c++) {
        const Cell *a = &yours->cells[c], *b = &reference->cells[c];
        double n = a->count + b->count;
        for (int k = 0; k < SUMS; k++)
            centres[c][k] =
                k < PLACE || k >= SPREAD || n == 0.0 ? 0.0 : (a->count * a->mean[k] + b->count * b->mean[k]) / n;
    }
}

// Places and ways count from the centre, spreads from their own.
static void add_squares(const Photons *photons, double centres[CELLS][SUMS], Side *side, double squares[CELLS][3])
{
    double values[SPREAD];
    int cells[6];
    for (long i = 0; i < photons->count; i++) {
        const float *photon = photon_at(photons, i);
        measure(photon, values);
        for (int n = cells_of(photon, cells); n-- > 0;) {
            int c = cells[n];
            for (int k = 0; k < 3; k++) {
                double off = values[PLACE + k] - centres[c][PLACE + k];
                squares[c][k] += off * off;
                side->cells[c].mean[SPREAD + k] += off * off / side->cells[c].count;
            }
        }
    }
}

static void add_batches(const Photons *photons, double centres[CELLS][SUMS], Side *side)
{
    double values[SPREAD];
    int cells[6];
    for (long i = 0; i < photons->count; i++) {
        const float *photon = photon_at(photons, i);
        long batch = (long)((double)photon[SCATTER_EMISSION] * BATCHES / (double)photons->emitted);
        measure(photon, values);
        for (int n = cells_of(photon, cells); n-- > 0;) {
            const double *centre = centres[cells[n]];
            double *sums = side->cells[cells[n]].batch[batch];
            for (int k = 0; k < SPREAD; k++)
                sums[k] += values[k] - centre[k];
            for (int k = 0; k < 3; k++) {
                double off = values[PLACE + k] - centre[PLACE + k];
                sums[SPREAD + k] += off * off - centre[SPREAD + k];
            }
        }
    }
}

void cells_fill(const Photons photons[2], Side *sides[2])
{
    double centres[CELLS][SUMS], squares[CELLS][3] = {{0}};
    for (int i = 0; i < 2; i++)
        find_means(&photons[i], sides[i]);
    find_centres(sides[0], sides[1], centres);
    for (int i = 0; i < 2; i++)
        add_squares(&photons[i], centres, sides[i], squares);
    for (int c = 0; c < CELLS; c++)
        for (int k = 0; k < 3; k++)
            centres[c][SPREAD + k] = squares[c][k] / fmax(1.0, sides[0]->cells[c].count + sides[1]->cells[c].count);
    for (int i = 0; i < 2; i++)
        add_batches(&photons[i], centres, sides[i]);
}
