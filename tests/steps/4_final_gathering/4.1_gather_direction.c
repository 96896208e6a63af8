// Step 4.1: in cell (ring j, sector k), sin²θ = (j + u)/M and φ = 2π(k + v)/N.
#include "judge/checks/directions.h"

#define M      GATHER_RINGS
#define N      GATHER_SECTORS
#define A_FEW  20
#define FLOATS 4 // direction, numbers drawn

static const double pi = 3.14159265358979323846;

// Where in its cell a direction lies, both 0…1; outside it when it lies in another cell.
typedef struct {
    double across, along;
} Place;

static Place place_of(const float *d, int ring, int sector)
{
    double sin2 = (double)d[0] * (double)d[0] + (double)d[1] * (double)d[1];
    double turn = atan2((double)d[1], (double)d[0]) / (2.0 * pi) * N - sector;
    turn -= N * floor((turn + 0.5 * (N - 1)) / N); // the turn nearest to the cell
    return (Place){sin2 * M - ring, turn};
}

static const char *cell_words(int ring, int sector)
{
    return words("ring %d, sector %d", ring, sector);
}

static void plan_cell(Plan *plan, int ring, int sector, long count)
{
    plan_call(plan, count, (double[]){ring, sector}, 2);
}

static void plan_cells(Plan *plan)
{
    for (int i = 0; i < M * N; i++)
        plan_cell(plan, i / N, i % N, A_FEW);
}

static void judge_place(const float *d, int ring, int sector, long number, Finding *finding)
{
    const double slack = 1e-3; // of a cell
    Place place = place_of(d, ring, sector);
    double sin2 = (place.across + ring) / M, phi = (place.along + sector) * 360.0 / N;
    if (!(place.across > -slack && place.across < 1.0 + slack))
        finding_fail(finding, number,
                     "for %s: expected sin²θ between %d/%d = %.4f and %d/%d = %.4f; found %.4f, with the direction %s",
                     cell_words(ring, sector), ring, M, (double)ring / M, ring + 1, M, (ring + 1.0) / M, sin2,
                     text_of_floats(d));
    else if (sin2 > 1e-6 && !(place.along > -slack - 1e-6 / sin2 && place.along < 1.0 + slack + 1e-6 / sin2))
        finding_fail(finding, number, "for %s: expected φ between %.0f° and %.0f°; found %.2f°, with the direction %s",
                     cell_words(ring, sector), sector * 360.0 / N, (sector + 1) * 360.0 / N, phi, text_of_floats(d));
}

static void judge_cells(const Results *results, Finding *finding)
{
    double observed[COSINES] = {0}, expected[COSINES];
    Sums across = {0, 0, 0}, along = {0, 0, 0}, cosine = {0, 0, 0}, turned = {0, 0, 0}, length = {0, 0, 0};
    for (int i = 0; i < M * N; i++) {
        int ring = i / N, sector = i % N;
        const float *d = numbers_of(results, (size_t)i, FLOATS * A_FEW, finding);
        for (int s = 0; d && s < A_FEW; s++, d += FLOATS) {
            if (!direction_is_above(d, vec3d(0, 0, 1), cell_words(ring, sector), i, finding))
                continue;
            judge_place(d, ring, sector, i, finding);
            Place place = place_of(d, ring, sector);
            sums_add(&across, place.across - 0.5);
            sums_add(&along, place.along - 0.5);
            sums_add(&turned, fabs(place.along - 0.5));
            sums_add(&cosine, (double)d[2]);
            sums_add(&length, vec3d_length(vec3d_of(d)));
            observed[(int)fmin(fmax(0.0, (double)d[2]) * COSINES, COSINES - 1)]++;
        }
    }
    for (int i = 0; i < COSINES; i++)
        expected[i] = M * N * A_FEW * (2.0 * i + 1.0) / (COSINES * COSINES);
    finding_histogram(finding, "cosθ of gather rays, all cells together", 0.0, 1.0, observed, expected, COSINES);
    mean_feature(&across, 0.0, finding);
    mean_feature(&along, 0.0, finding);
    mean_feature(&turned, 0.25, finding);
    mean_feature(&cosine, 2.0 / 3.0, finding);
    mean_feature(&length, 1.0, finding);
}

// ---- within a cell ----

#define SAMPLES 20000
#define GRID    10

static const int within[][2] = {{0, 0}, {0, N - 1}, {M / 2, N / 3}, {M - 1, 1}};
#define WITHIN (int)(sizeof within / sizeof *within)

static void plan_within(Plan *plan)
{
    for (int i = 0; i < WITHIN; i++)
        plan_cell(plan, within[i][0], within[i][1], SAMPLES);
}

static int grid_cell(double place)
{
    return (int)fmin(fmax(place, 0.0) * GRID, GRID - 1);
}

static void judge_within(const Results *results, Finding *finding)
{
    for (int i = 0; i < WITHIN; i++) {
        int ring = within[i][0], sector = within[i][1];
        double observed[GRID * GRID] = {0}, expected[GRID * GRID];
        Sums across = {0, 0, 0}, along = {0, 0, 0}, together = {0, 0, 0}, spread = {0, 0, 0};
        const float *d = numbers_of(results, (size_t)i, FLOATS * SAMPLES, finding);
        for (long s = 0; d && s < SAMPLES; s++, d += FLOATS) {
            if (!direction_is_sound(d, cell_words(ring, sector), i, finding))
                continue;
            Place place = place_of(d, ring, sector);
            observed[grid_cell(place.across) * GRID + grid_cell(place.along)]++;
            sums_add(&across, place.across);
            sums_add(&along, place.along);
            sums_add(&together, (place.across - 0.5) * (place.along - 0.5));
            sums_add(&spread, (place.across - 0.5) * (place.across - 0.5));
        }
        for (int c = 0; c < GRID * GRID; c++)
            expected[c] = (double)SAMPLES / (GRID * GRID);
        finding_p(finding, d ? chi_square_p(observed, expected, GRID * GRID) : 1.0, i,
                  "expected directions spread evenly over their cell, in sin²θ and in φ, each by a number of its own; "
                  "for %s they lie on average at %.3f of its width in sin²θ and at %.3f of its width in φ (0.5 each), "
                  "with a variance of %.4f in sin²θ (0.0833) and a covariance of %.4f (0)",
                  cell_words(ring, sector), sums_mean(&across), sums_mean(&along), sums_mean(&spread),
                  sums_mean(&together));
        mean_feature(&across, 0.5, finding);
        mean_feature(&along, 0.5, finding);
        mean_feature(&together, 0.0, finding);
        mean_feature(&spread, 1.0 / 12.0, finding);
    }
}

// ---- random numbers ----

static void plan_draws(Plan *plan)
{
    plan_cell(plan, M / 3, N / 4, A_FEW);
    plan_cell(plan, M / 2, N - 2, A_FEW);
}

static void judge_draws(const Results *results, Finding *finding)
{
    for (int i = 0; i < 2; i++) {
        const float *d = numbers_of(results, (size_t)i, FLOATS * A_FEW, finding);
        for (int s = 0; d && s < A_FEW; s++, d += FLOATS) {
            double draws = (double)d[3];
            if (draws > 50.0 && draws != 2.0)
                finding_fail(finding, i, "expected two numbers to be drawn from *rng; found it in another state");
            else if (draws != 2.0)
                finding_fail(finding, i, "expected two numbers to be drawn from *rng, u and v; found %.0f%s", draws,
                             draws == 0.0 ? ": the next ray would get the same ones" : "");
            if (i == 0 && s == 0)
                finding_feature(finding, draws - 2.0, 0.0);
        }
    }
}

DEFINE_CHECKS(gather_direction,
              {"cells", "Each direction is a unit vector in its cell", CHECK_VALUES, plan_cells, judge_cells},
              {"within", "Directions spread evenly over their cell", CHECK_SAMPLES, plan_within, judge_within},
              {"draws", "Two random numbers are drawn", CHECK_INVARIANT, plan_draws, judge_draws}, PICTURE(4))
