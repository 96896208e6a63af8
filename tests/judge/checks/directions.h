// What the checks of sampled directions share: counts in cells against a density, soundness, messages, exact integrals
// of the lobe. All in double; the student's numbers come as float.
#pragma once

#include "judge/checks/step_checks.h"

typedef struct {
    double x, y, z;
} Vec3d;

static inline Vec3d vec3d(double x, double y, double z)
{
    return (Vec3d){x, y, z};
}

static inline Vec3d vec3d_of(const float *v)
{
    return vec3d((double)v[0], (double)v[1], (double)v[2]);
}

static inline Vec3d vec3d_widened(Vec3 v)
{
    return vec3d((double)v.x, (double)v.y, (double)v.z);
}

static inline double vec3d_dot(Vec3d a, Vec3d b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// a + s·b
static inline Vec3d vec3d_along(Vec3d a, Vec3d b, double s)
{
    return vec3d(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}

static inline Vec3d vec3d_cross(Vec3d a, Vec3d b)
{
    return vec3d(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline double vec3d_length(Vec3d a)
{
    return sqrt(vec3d_dot(a, a));
}

Vec3d vec3d_unit(Vec3d a);

// As a student's code gets it: rounded to float.
Vec3d vec3d_rounded(Vec3d a);

// Two unit vectors at right angles to `axis` and each other; and a direction given by its angles about the
// axis, radians.
void vec3d_frame(Vec3d axis, Vec3d *tangent, Vec3d *bitangent);
Vec3d vec3d_about(Vec3d axis, Vec3d tangent, Vec3d bitangent, double cosine, double azimuth);

// A direction at this angle (degrees) from `axis`, at this azimuth (degrees) about it; the azimuth's zero is anywhere.
Vec3d direction_at(Vec3d axis, double degrees, double azimuth);

// The mirror direction of d at a surface of normal n.
Vec3d mirrored(Vec3d d, Vec3d n);

// The numbers of a case when there are `floats` of them; otherwise the finding fails and NULL comes back.
const float *numbers_of(const Results *results, size_t number, size_t floats, Finding *finding);

// Are these `count` numbers finite? Fails the finding otherwise, in words: "expected <what> made of numbers;
// found nan".
bool all_finite(const float *values, int count, const char *what, const char *inputs, long number, Finding *finding);

// A direction as right code gives it: finite, of length 1 (to 1e-3, since a frame near a pole costs digits).
// `inputs` says what it was called with: "n = (0, 0, 1)".
bool direction_is_sound(const float *d, const char *inputs, long number, Finding *finding);

// The same, and not below the surface (by more than 1e-4).
bool direction_is_above(const float *d, Vec3d normal, const char *inputs, long number, Finding *finding);

// A vector as it should be, to this tolerance. Fails the finding otherwise: "for <inputs>: expected …, found …".
bool vector_is(const float *found, Vec3d expected, double tolerance, const char *inputs, long number, Finding *finding);

// A direction of no special kind, rounded to float; the same number, the same direction.
Vec3d any_direction(uint64_t number);

// "(0.6, 0, -0.8)" for messages. Eight calls in one message at most: the texts lie in a ring.
const char *text_of(Vec3d v);
const char *text_of_floats(const float *v);
const char *text_of_power(Vec3d v); // the same, however small

// ---- χ² over cells (direction_counts.c) ----

#define ROWS      10 // rings about the axis, before it; evenly in cos^power, so that a lobe fills them evenly
#define BACK_ROWS 4  // rings behind it, evenly in cos
#define COLUMNS   20 // azimuths
#define CELLS     ((ROWS + BACK_ROWS) * COLUMNS)
#define COSINES   40 // bins of the histogram of cosines, from −1 to 1

typedef struct {
    Vec3d axis;                                            // unit
    double power;                                          // n+1 for a lobe cosⁿ about the axis, 2 for Lambert
    double (*density)(Vec3d direction, const void *input); // per steradian, of any scale, 0 where none belong
    const void *input;
} DirectionDensity;
double lambert(Vec3d direction, const void *normal); // a density; `normal` is a Vec3d

// What the density gives, its scale taken out.
typedef struct {
    double share[CELLS], cosines[COSINES], along, across, up;
} DirectionExpectation;

typedef struct {
    DirectionDensity density;
    DirectionExpectation expected;
    Vec3d tangent, bitangent;
    double observed[CELLS], cosines[COSINES];
    Sums along, across, up; // components along axis, tangent, bitangent
    float before[3];        // the direction before
    Sums repeated;          // is one the same as that before it?
} DirectionCount;

void directions_begin(DirectionCount *count, const DirectionDensity *density);
void directions_add(DirectionCount *count, const float *direction); // of any length but 0

// p-value of the counts; 1 when nothing was counted. Cells that expect fewer than 5 are taken together, with those that
// expect nothing.
double directions_p(const DirectionCount *count);

// Four features: means along axis, tangent and bitangent, less the expected; the share that are the same as the one before.
void directions_features(const DirectionCount *count, Finding *finding);

void directions_histogram(const DirectionCount *count, const char *title, Finding *finding);

// ---- very many samples of density cos/π about +z, in fine cells (fine_cells.c) ----

#define FINE_SAMPLES 1200000

// Case 0 must be that many directions. Finds what a coarse count cannot: φ in degrees (360·u is 1 % off), a gap of a
// few degrees, one angle that comes again and again. `axis` and `inputs` are words: "the normal", "n = (0, 0, 1)".
void judge_fine(const Results *results, const char *axis, const char *inputs, Finding *finding);

// A feature: a mean less the expected, with its standard error.
void mean_feature(const Sums *sums, double expected, Finding *finding);

// Three features: found − expected, without error; NaN where nothing was found.
void vector_features(const float *found, Vec3d expected, Finding *finding);

// ---- the lobe's integrals (Arvo 1995), by the incomplete beta function ----

// I_P = ∫cosⁿα dω and I_M = ∫cosⁿα cosθ_o dω over the upper hemisphere.
double lobe_above_exactly(double exponent, double cos_theta);
double lobe_weighted_exactly(double exponent, double cos_theta);
