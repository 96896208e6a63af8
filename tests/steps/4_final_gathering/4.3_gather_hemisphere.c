// Step 4.3: E = (π/MN) Σ L_jk, in two rooms where every wall receives the same irradiance: one of a single colour, and one
// without a ceiling whose walls tell by colour and distance which cell looks where.
#include "judge/checks/directions.h"

#define SCENE  "tests/steps/scenes/gather_room.yaml"
#define M      GATHER_RINGS
#define N      GATHER_SECTORS
#define CALLS  2 // of each case, with random numbers of their own
#define FLOATS (3 + 4 * M * N)

static const double pi = 3.14159265358979323846;
static const Vec3d irradiance = {2.0, 3.0, 4.0};

static size_t plan_hit(Plan *plan, Vec3d from, Vec3d to)
{
    Vec3d d = vec3d_unit(vec3d_along(to, from, -1.0));
    return plan_call_in(plan, SCENE, CALLS,
                        (double[]){irradiance.x, irradiance.y, irradiance.z, from.x, from.y, from.z, d.x, d.y, d.z}, 9);
}

static bool sums_up(const float *found, Vec3d expected)
{
    return vec3d_length(vec3d_along(vec3d_of(found), expected, -1.0)) <= 1e-3 * vec3d_length(expected);
}

static double ratio_of(const float *found, Vec3d expected)
{
    return ((double)found[0] + (double)found[1] + (double)found[2]) / (expected.x + expected.y + expected.z);
}

// E by what the step itself has kept.
static Vec3d sum_of_seen(const float *seen)
{
    Vec3d sum = {0, 0, 0};
    for (int i = 0; i < M * N; i++)
        sum = vec3d_along(sum, vec3d_of(seen + 4 * i), pi / (M * N));
    return sum;
}

// ---- one colour all around ----

#define CLOSED 4

// On the floor, two walls and the ceiling.
static void plan_uniform(Plan *plan)
{
    double a = drawn_input(plan->seed, 977, -0.5, 0.5), b = drawn_input(plan->seed, 978, -0.5, 0.5);
    const Vec3d middle = {10, 0.75, 0};
    plan_hit(plan, middle, vec3d(10 + a, 0, b));
    plan_hit(plan, middle, vec3d(9, 0.75 + a, b));
    plan_hit(plan, middle, vec3d(10 + b, 0.75 + a, 1.2));
    plan_hit(plan, middle, vec3d(10 + b, 1.5, a));
}

static void judge_uniform(const Results *results, Finding *finding)
{
    const Vec3d expected = {0.6 * irradiance.x, 0.3 * irradiance.y, 0.9 * irradiance.z};
    for (int i = 0; i < CLOSED; i++) {
        const float *found = numbers_of(results, (size_t)i, CALLS * FLOATS, finding);
        if (found && all_finite(found, 3, "an irradiance", "surroundings of a single colour", i, finding) &&
            !sums_up(found, expected))
            finding_fail(finding, i,
                         "for surroundings of radiance L = %s everywhere: expected E = πL = %s W/m², found %s, %.4g "
                         "times as much",
                         text_of(vec3d_along(vec3d(0, 0, 0), expected, 1.0 / pi)), text_of(expected),
                         text_of_floats(found), ratio_of(found, expected));
        finding_feature(finding, found ? ratio_of(found, expected) - 1.0 : (double)NAN, 0.0);
        finding_feature(
            finding, found ? ratio_of(found + 3, vec3d(0.6 * 2 / pi, 0.3 * 3 / pi, 0.9 * 4 / pi)) - 1.0 : (double)NAN,
            0.0);
    }
}

// ---- cell by cell ----

typedef enum { FLOOR, LEFT, RIGHT, BACK, FRONT, WALLS, OPEN = WALLS } Wall;
static const char *const wall_names[] = {"the floor",     "the left wall",  "the right wall",
                                         "the back wall", "the front wall", "the open"};
static const double colours[WALLS + 1][3] = {{0.4, 0.5, 0.3}, {0, 0, 0},       {0.8, 0.8, 0.8},
                                             {0.7, 0.2, 0.1}, {0.1, 0.3, 0.7}, {0, 0, 0}};

typedef struct {
    const char *what;
    Wall wall; // that it lies on
    Vec3d place, normal;
} Point;

#define POINTS 4

static Point point_of(int i, uint64_t seed)
{
    double a = drawn_input(seed, 987 + i, -0.15, 0.15), b = drawn_input(seed, 997 + i, -0.15, 0.15);
    const Point points[POINTS] = {
        {"a point on the floor", FLOOR, {0.3 + a, 0, -0.3 + b}, {0, 1, 0}},
        {"a point on the left wall", LEFT, {-1, 0.7 + a, 0.4 + b}, {1, 0, 0}},
        {"a point on the back wall", BACK, {0.2 + a, 0.8 + b, -1.2}, {0, 0, 1}},
        {"a point on the floor, in a corner", FLOOR, {0.75 + a, 0, 0.9 + b}, {0, 1, 0}},
    };
    return points[i];
}

static void plan_cells(Plan *plan)
{
    for (int i = 0; i < POINTS; i++)
        plan_hit(plan, vec3d(0, 0.6, 0), point_of(i, plan->seed).place);
}

// Where a direction from the point ends, and how far away.
static Wall look(const Point *point, Vec3d d, double *distance)
{
    const Vec3d p = point->place;
    const double to[WALLS] = {-p.y / d.y, (-1.0 - p.x) / d.x, (1.0 - p.x) / d.x, (-1.2 - p.z) / d.z, (1.2 - p.z) / d.z};
    Wall nearest = OPEN;
    *distance = (double)INFINITY;
    for (int w = FLOOR; w < WALLS; w++) {
        if (w == (int)point->wall || !(to[w] > 0.0) || to[w] >= *distance)
            continue;
        nearest = (Wall)w;
        *distance = to[w];
    }
    if (nearest == OPEN || p.y + *distance * d.y > 1.5) {
        *distance = (double)INFINITY;
        return OPEN;
    }
    return nearest;
}

// What a cell can see: one wall alone (or WALLS + 1: several), and how far it is at least and at most.
typedef struct {
    int wall;
    double least, most; // of what is not open; 0 and 0: all is
    bool some_open;
} View;
#define SEVERAL (WALLS + 1)
#define FINE    9 // directions a side

static View view_of(const Point *point, int ring, int sector)
{
    Frame frame = frame_about(vec3((float)point->normal.x, (float)point->normal.y, (float)point->normal.z));
    const Vec3d axis = vec3d_widened(frame.normal), tangent = vec3d_widened(frame.tangent);
    const Vec3d bitangent = vec3d_widened(frame.bitangent);
    View view = {-1, 0.0, 0.0, false};
    for (int i = 0; i < FINE * FINE; i++) {
        double sin2 = (ring + (double)(i / FINE) / (FINE - 1)) / M;
        double phi = 2.0 * pi * (sector + (double)(i % FINE) / (FINE - 1)) / N;
        double distance;
        Wall wall = look(point, vec3d_about(axis, tangent, bitangent, sqrt(1.0 - sin2), phi), &distance);
        view.wall = view.wall < 0 || view.wall == (int)wall ? (int)wall : SEVERAL;
        view.some_open = view.some_open || wall == OPEN;
        if (wall == OPEN)
            continue;
        view.least = view.most > 0.0 ? fmin(view.least, distance) : distance;
        view.most = fmax(view.most, distance);
    }
    double slack = 0.02 * view.most + 0.2 * (view.most - view.least);
    view.least -= slack;
    view.most += view.some_open ? 0.3 * view.most : slack; // between two of the directions the wall may go on
    return view;
}

static bool is_distance(const View *view, double distance)
{
    if (isinf(distance))
        return distance > 0.0 && view->some_open;
    return view->most > 0.0 && distance >= view->least && distance <= view->most;
}

static const char *cell_words(const Point *point, int ring, int sector)
{
    return words("for %s, cell (ring %d, sector %d)", point->what, ring, sector);
}

static void judge_distance(const Point *point, const View *view, int cell, double found, long number, Finding *finding)
{
    const char *where = cell_words(point, cell / N, cell % N);
    const char *expected = "of INFINITY", *text = words(isinf(found) ? "INFINITY" : "%.4g", found);
    if (view->most > 0.0)
        expected =
            words("between %.2f m and %.2f m%s", view->least, view->most, view->some_open ? ", or INFINITY" : "");
    if (found == -77.0)
        finding_fail(finding, number, "%s: expected a distance in seen->distance; found it left as it was", where);
    else
        finding_fail(finding, number, "%s, which looks at %s: expected a distance %s, found %s", where,
                     view->wall == SEVERAL ? "several walls" : wall_names[view->wall], expected, text);
}

typedef struct {
    double radiances, distances; // cells that are wrong
} Wrong;

static Wrong judge_seen(const Point *point, const float *seen, long number, Finding *finding)
{
    Wrong wrong = {0.0, 0.0};
    for (int i = 0; i < M * N; i++, seen += 4) {
        View view = view_of(point, i / N, i % N);
        if (!is_distance(&view, (double)seen[3])) {
            judge_distance(point, &view, i, (double)seen[3], number, finding);
            wrong.distances += 1.0 / (M * N);
        }
        if (view.wall == SEVERAL)
            continue;
        const double *colour = colours[view.wall];
        Vec3d expected =
            vec3d(colour[0] * irradiance.x / pi, colour[1] * irradiance.y / pi, colour[2] * irradiance.z / pi);
        if (vec3d_length(vec3d_along(vec3d_of(seen), expected, -1.0)) <= 2e-3 * vec3d_length(expected) + 1e-6)
            continue;
        wrong.radiances += 1.0 / (M * N);
        finding_fail(finding, number, "%s, which looks at %s: expected seen->radiance %s, found %s",
                     cell_words(point, i / N, i % N), wall_names[view.wall], text_of(expected), text_of_floats(seen));
    }
    return wrong;
}

static void judge_cells(const Results *results, Finding *finding)
{
    for (int i = 0; i < POINTS; i++) {
        Point point = point_of(i, results->seed);
        const float *found = numbers_of(results, (size_t)i, CALLS * FLOATS, finding);
        Wrong wrong = {(double)NAN, (double)NAN};
        double ratio = (double)NAN;
        for (int call = 0; found && call < CALLS; call++, found += FLOATS) {
            if (!all_finite(found, 3, "an irradiance", point.what, i, finding))
                continue;
            wrong = judge_seen(&point, found + 3, i, finding);
            Vec3d expected = sum_of_seen(found + 3);
            ratio = ratio_of(found, expected);
            if (!sums_up(found, expected))
                finding_fail(finding, i,
                             "for %s: expected E = (π/MN) Σ L_jk = %s W/m², of the radiances that were kept; found %s, "
                             "%.4g times as much",
                             point.what, text_of(expected), text_of_floats(found), ratio);
        }
        finding_feature(finding, ratio - 1.0, 0.0);
        finding_feature(finding, wrong.radiances, 0.02);
        finding_feature(finding, wrong.distances, 0.02);
    }
}

// ---- random numbers ----

static void judge_random(const Results *results, Finding *finding)
{
    for (int i = 0; i < POINTS; i++) {
        const float *found = numbers_of(results, (size_t)i, CALLS * FLOATS, finding);
        int same = 0, closed = 0;
        for (int c = 0; found && c < M * N; c++) {
            const float *a = found + 3 + 4 * c, *b = a + FLOATS;
            closed += isfinite(a[3]) && isfinite(b[3]);
            same += isfinite(a[3]) && a[3] == b[3];
        }
        if (found && 2 * same > closed)
            finding_fail(finding, i,
                         "for %s: expected other rays with other random numbers; found %d of %d as long as before",
                         point_of(i, results->seed).what, same, closed);
        finding_feature(finding, found ? (double)same / fmax(1.0, closed) : (double)NAN, 0.02);
    }
}

DEFINE_CHECKS(gather_hemisphere,
              {"uniform", "Where all surroundings send L, irradiance is πL", CHECK_VALUES, plan_uniform, judge_uniform},
              {"cells", "Each cell has what its own ray brought, and how far it flew", CHECK_VALUES, plan_cells,
               judge_cells},
              {"random", "Rays follow the random numbers", CHECK_INVARIANT, plan_cells, judge_random}, PICTURE(4))
