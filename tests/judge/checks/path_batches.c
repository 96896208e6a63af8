#include "judge/checks/path_batches.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const char *const channel_names[3] = {"red", "green", "blue"};

PathCase path_case(const Results *results, long number, long photons, Finding *finding)
{
    PathCase c = {.photons = photons, .number = number, .finding = finding};
    double numbers[BATCH_NUMBERS];
    const Numbers *given = (size_t)number < results->count ? &results->cases[number] : NULL;
    bool whole = given && given->values && given->count == BATCH_NUMBERS;
    for (size_t i = 0; i < BATCH_NUMBERS; i++)
        numbers[i] = whole ? (double)given->values[i] : (double)NAN;
    memcpy(&c.batch, numbers, sizeof c.batch);
    if (!whole)
        finding_fail(finding, number, "expected the books of %ld photons; found none", photons);
    return c;
}

void expect_share(PathCase *c, double found, double share, const char *where)
{
    double n = (double)c->photons;
    double expected = share * n;
    bool certain = share <= 0.0 || share >= 1.0;
    finding_feature(c->finding, (found - expected) / n, certain ? 0.0 : sqrt(share * (1.0 - share) / n));
    if (share <= 0.0 && !(found == 0.0))
        finding_fail(c->finding, c->number, "expected no photons %s; found %.0f, of %.0f emitted", where, found, n);
    else if (certain && !(fabs(found - expected) < 0.5))
        finding_fail(c->finding, c->number, "expected %.0f photons %s, of %.0f emitted; found %.0f", expected, where, n,
                     found);
    if (!certain)
        finding_p(c->finding, found >= 0.0 && found <= n ? binomial_p((long)found, c->photons, share) : 0.0, c->number,
                  "expected about %.0f photons %s, of %.0f emitted; found %.0f", expected, where, n, found);
}

void expect_value(PathCase *c, double found, double expected, double scale, const char *what)
{
    finding_feature(c->finding, (found - expected) / scale, 0.0);
    if (!(fabs(found - expected) <= 1e-3 * scale))
        finding_fail(c->finding, c->number, "expected %.4g %s; found %.4g", expected, what, found);
}

void expect_mean(PathCase *c, double found, double expected, double error, const char *what)
{
    finding_feature(c->finding, found - expected, error);
    finding_p(c->finding, normal_p((found - expected) / error), c->number,
              "expected %s to be %.4g ± %.2g on average; found %.4g", what, expected, error, found);
}

static double largest_of(const double v[3])
{
    return fmax(fabs(v[0]), fmax(fabs(v[1]), fabs(v[2])));
}

// Three numbers of photons that landed alike.
static void expect_three(PathCase *c, const double found[3], const double expected[3], double scale, const char *what)
{
    double worst = 0.0;
    for (int i = 0; i < 3; i++) {
        finding_feature(c->finding, (found[i] - expected[i]) / scale, 0.0);
        worst = isnan(found[i]) ? INFINITY : fmax(worst, fabs(found[i] - expected[i]));
    }
    if (worst > 1e-3 * scale)
        finding_fail(c->finding, c->number, "expected %s (%.4g, %.4g, %.4g); found (%.4g, %.4g, %.4g)", what,
                     expected[0], expected[1], expected[2], found[0], found[1], found[2]);
}

static void mean_of(const double sum[3], double count, double mean[3])
{
    for (int i = 0; i < 3; i++)
        mean[i] = sum[i] / count;
}

// Nobody there to measure: NaN keeps the features' order.
static void no_features(PathCase *c, int count)
{
    for (int i = 0; i < count; i++)
        finding_feature(c->finding, (double)NAN, 0.0);
}

void expect_landed(PathCase *c, const BatchSum *sum, const Landed *landed, const char *which)
{
    if (!(sum->count > 0.0)) {
        no_features(c, 3 * (1 + (landed->place != NULL) + (landed->from != NULL)));
        return;
    }
    char what[300];
    double mean[3], flux[3];
    mean_of(sum->flux, 1e-3 * sum->count, mean);
    mean_of(landed->flux, 1e-3 * (double)c->photons, flux);
    snprintf(what, sizeof what, "%s to carry, in mW each,", which);
    expect_three(c, mean, flux, largest_of(flux), what);
    if (landed->place) {
        mean_of(sum->place, sum->count, mean);
        snprintf(what, sizeof what, "%s to land at", which);
        expect_three(c, mean, landed->place, 1.0, what);
    }
    if (landed->from) {
        mean_of(sum->from, sum->count, mean);
        snprintf(what, sizeof what, "%s to have come from direction", which);
        expect_three(c, mean, landed->from, 1.0, what);
    }
}

// The books balance by construction but for `chance`; its standard error is 0 where nothing is drawn.
static void expect_no_gain(PathCase *c)
{
    for (int i = 0; i < 3; i++) {
        double emitted = c->batch.emitted[i];
        double gain = -c->batch.chance[i] / emitted;
        double error = c->batch.chance_error[i] / emitted + 1e-5;
        finding_feature(c->finding, gain, error);
        finding_p(
            c->finding, normal_p(gain / error), c->number,
            "expected photons to keep their power, on average, but for what surfaces absorb; found %.3g %% of the "
            "light's %s power %s",
            100.0 * fabs(gain), channel_names[i], gain > 0.0 ? "made out of nothing" : "lost");
    }
}

void expect_books(PathCase *c)
{
    finding_feature(c->finding, c->batch.unsound / (double)c->photons, 0.0);
    finding_feature(c->finding, c->batch.unusual / (double)c->photons, 0.0);
    if (!(c->batch.unsound == 0.0))
        finding_fail(c->finding, c->number, "expected directions of length 1; found %.0f flights in another one",
                     c->batch.unsound);
    if (!(c->batch.unusual == 0.0))
        finding_fail(c->finding, c->number,
                     "expected powers of 0 W or more; found %.0f stored photons with another one", c->batch.unusual);
    expect_no_gain(c);
}

static void add_sum(BatchSum *sum, const BatchSum *part)
{
    sum->count += part->count;
    for (int i = 0; i < 3; i++) {
        sum->flux[i] += part->flux[i];
        sum->place[i] += part->place[i];
        sum->from[i] += part->from[i];
    }
}

BatchSum stored_on(const PathCase *c, int material)
{
    BatchSum sum = {0};
    for (int colour = 0; colour < BATCH_COLOURS; colour++)
        add_sum(&sum, &c->batch.stored[material][colour]);
    return sum;
}

double stored_of_colour(const PathCase *c, PhotonColour colour)
{
    double count = 0.0;
    for (int m = 0; m < BATCH_MATERIALS; m++)
        count += c->batch.stored[m][colour].count;
    return count;
}

double exact_cos_t(double cos_i, double eta)
{
    return sqrt(fmax(0.0, 1.0 - eta * eta * (1.0 - cos_i * cos_i)));
}

double exact_fresnel(double cos_i, double eta)
{
    double cos_t = exact_cos_t(cos_i, eta);
    if (cos_t <= 0.0)
        return 1.0;
    double s = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    double p = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    return 0.5 * (s * s + p * p);
}
