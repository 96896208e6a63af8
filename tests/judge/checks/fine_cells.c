// Directions of density cos/π about +z: φ/2π and cos² are even from 0 to 1.
#include "judge/checks/directions.h"

#define EIGHTHS 8
#define DEGREES 360
#define RINGS   1000

static const double pi = 3.14159265358979323846;

typedef struct {
    double eighths[EIGHTHS], degrees[DEGREES], rings[RINGS], count;
} FineCount;

static int cell_of(double share, int cells)
{
    int cell = (int)(share * cells);
    return cell < 0 ? 0 : cell < cells ? cell : cells - 1;
}

static void add_direction(FineCount *count, const float *d)
{
    double x = (double)d[0], y = (double)d[1], z = (double)d[2];
    double length2 = x * x + y * y + z * z;
    if (!(length2 > 0.0) || !isfinite(length2))
        return; // "density" says so
    int degree = cell_of((double)atan2f(d[1], d[0]) / (2.0 * pi) + 0.5, DEGREES);
    count->degrees[degree]++;
    count->rings[cell_of(z * z / length2, RINGS)]++;
    count->count++;
}

static double even_p(const double *observed, int cells, double total)
{
    double wanted[RINGS];
    for (int i = 0; i < cells; i++)
        wanted[i] = total / cells;
    return chi_square_p(observed, wanted, cells);
}

// Sorted, since where φ is 0 is everyone's own choice.
static void eighths_features(const FineCount *count, double off[EIGHTHS], Finding *finding)
{
    for (int i = 0; i < EIGHTHS; i++)
        off[i] = count->eighths[i] * EIGHTHS / count->count - 1.0;
    sort_values(off, EIGHTHS);
    for (int i = 0; i < EIGHTHS; i++)
        finding_feature(finding, off[i], sqrt((EIGHTHS - 1) / count->count));
}

// sinf(360·u), of an angle in degrees: u goes round 57.3 times, one stretch 58 times and the rest 57. Do the counts look
// like that, wherever the stretch begins?
static bool goes_round_in_degrees(const FineCount *count)
{
    const double turns = 180.0 / pi, most = ceil(turns) / turns, least = floor(turns) / turns;
    const int stretch = (int)((turns - floor(turns)) * DEGREES + 0.5);
    double wanted[DEGREES], sum = 0.0, fullest = 0.0;
    int begin = 0;
    for (int i = 0; i < 2 * DEGREES; i++) {
        sum += count->degrees[i % DEGREES] - (i < stretch ? 0.0 : count->degrees[(i - stretch) % DEGREES]);
        if (i >= DEGREES && sum > fullest) {
            fullest = sum;
            begin = i - stretch + 1;
        }
    }
    for (int i = 0; i < DEGREES; i++)
        wanted[(begin + i) % DEGREES] = (i < stretch ? most : least) * count->count / DEGREES;
    return fabs(fullest * DEGREES / (stretch * count->count) - most) < 0.006 &&
           chi_square_p(count->degrees, wanted, DEGREES) > 1e-3;
}

static void judge_azimuths(const FineCount *count, const char *axis, const char *inputs, Finding *finding)
{
    double off[EIGHTHS], least = count->count, most = 0.0;
    int empty = 0;
    for (int i = 0; i < DEGREES; i++) {
        empty += count->degrees[i] == 0.0;
        least = fmin(least, count->degrees[i]);
        most = fmax(most, count->degrees[i]);
    }
    eighths_features(count, off, finding);
    if (goes_round_in_degrees(count) && even_p(count->eighths, EIGHTHS, count->count) < 1e-6)
        finding_suspect(finding, "degrees",
                        "the angle φ is in degrees, 360·u, where sine and cosine take radians: 2π·u");
    double share = count->count / DEGREES;
    finding_p(finding, even_p(count->degrees, DEGREES, count->count), 0,
              "expected every angle φ about %s to be as likely as any other, over one whole turn; for %s, of 360 steps "
              "of 1° the emptiest gets %.0f %% of its share of directions and the fullest %.0f %% (%d get none)",
              axis, inputs, 100.0 * least / share, 100.0 * most / share, empty);
    finding_p(finding, even_p(count->eighths, EIGHTHS, count->count), 0,
              "expected every angle φ about %s to be as likely as any other, over one whole turn; for %s one eighth of "
              "the turn gets %.2f %% too few directions and another %.2f %% too many",
              axis, inputs, -100.0 * off[0], 100.0 * off[EIGHTHS - 1]);
}

static void judge_rings(const FineCount *count, const char *axis, const char *inputs, Finding *finding)
{
    int fullest = 0;
    for (int i = 0; i < RINGS; i++)
        fullest = count->rings[i] > count->rings[fullest] ? i : fullest;
    finding_p(finding, even_p(count->rings, RINGS, count->count), 0,
              "expected the angle to %s to take all values from 0° to 90°, each as often as the density says; for %s "
              "directions whose cosine with it is about %.3f come %.2f times too often",
              axis, inputs, sqrt((fullest + 0.5) / RINGS), count->rings[fullest] * RINGS / count->count);
}

void judge_fine(const Results *results, const char *axis, const char *inputs, Finding *finding)
{
    static FineCount count;
    count = (FineCount){.count = 0.0};
    const float *d = numbers_of(results, 0, 3 * FINE_SAMPLES, finding);
    for (long s = 0; d && s < FINE_SAMPLES; s++, d += 3)
        add_direction(&count, d);
    for (int i = 0; i < DEGREES; i++)
        count.eighths[i * EIGHTHS / DEGREES] += count.degrees[i];
    judge_azimuths(&count, axis, inputs, finding);
    judge_rings(&count, axis, inputs, finding);
}
