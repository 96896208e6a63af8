// Photon passes in small scenes (tests/steps/scenes/): what the probe found, held against what must be.
//
// The scenes are made so that what must be is known without tracing a photon: how many land where is a binomial number
// (each photon of the light ends in one of a few ways, by chances from the contract), and those that land in the same
// way all carry the same power and, behind thin beams, lie in the same place.
#pragma once

#include "judge/checks/step_checks.h"

#include "judge/probe/probe_sizes.h"

// One case of one batch.
typedef struct {
    Batch batch; // NaN throughout if the case gave nothing
    long photons;
    long number; // of the case within the check
    Finding *finding;
} PathCase;

PathCase path_case(const Results *results, long number, long photons, Finding *finding);

// Of the light's photons a share is expected `where` ("stored on the screen"). Exact for a share of 0 or 1, otherwise
// by the binomial distribution. Feature: share found less share expected.
void expect_share(PathCase *c, double found, double share, const char *where);

// A number that has no chance in it, within 0.1 % of `scale`; `what` with its unit: "W of red on the screen".
// Feature: the difference over scale.
void expect_value(PathCase *c, double found, double expected, double scale, const char *what);

// A mean with a known standard error. Feature: the difference.
void expect_mean(PathCase *c, double found, double expected, double error, const char *what);

// Photons that landed alike. Of them each has the same power, lies at `place` (m; NULL: not asked) and came from
// direction `from` (unit; NULL: not asked).
typedef struct {
    double flux[3]; // of one photon, times the number of photons that the light emits
    const double *place, *from;
} Landed;
void expect_landed(PathCase *c, const BatchSum *sum, const Landed *landed, const char *which);

// What holds in every scene: directions of unit length, powers that are numbers, the ledger's `chance` 0 within its
// standard error. Features: unsound and unusual ones per photon, chance per watt.
void expect_books(PathCase *c);

// Sums over colours, and over materials as well.
BatchSum stored_on(const PathCase *c, int material);
double stored_of_colour(const PathCase *c, PhotonColour colour);

// Optics in double precision. `cos_t` is 0 under total reflection.
double exact_cos_t(double cos_i, double eta);
double exact_fresnel(double cos_i, double eta);

extern const char *const channel_names[3]; // "red", …
