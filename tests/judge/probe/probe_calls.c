// `call` cases: a step's arguments out of a line, its results into the output, both as its row in lib/steps/steps.def lists
// them. A line has what the row's reader takes, then the parameters; out come the result, then what was changed or filled.
// Vectors and colours are three numbers, a photon is position, direction, power, colour, bounce, path, from, flown.
// All calls of a case draw from one stream, and look into one Gather: what one of them spoils, the next one shows.
#include "judge/probe/probe_given.h"

#include <stdlib.h>
#include <string.h>

#define MOST_CALLS   2000000L
#define MOST_PHOTONS 4096   // given to step 1.6 in one case
#define UNTOUCHED    -77.0f // left where a step must not write

// One value of each type: how it is read, what stands there before a step fills it, how it is written.
#define READ_int(line)                (int)probe_whole(line, -1000000, 1000000)
#define READ_float(line)              (float)probe_number(line)
#define READ_Vec3(line)               probe_vec3(line)
#define READ_Colour(line)             probe_colour(line)
#define READ_PointStatistics(line)    read_point(line)
#define READ_PhotonColour(line)       (PhotonColour) probe_whole(line, WHITE, BLUE)
#define UNTOUCHED_float               UNTOUCHED
#define UNTOUCHED_Vec3                vec3(UNTOUCHED, UNTOUCHED, UNTOUCHED)
#define UNTOUCHED_Colour              colour_grey(UNTOUCHED)
#define UNTOUCHED_Hemisphere          untouched_hemisphere()
#define UNTOUCHED_Photon              photon_create(vec3(UNTOUCHED, 0, 0), vec3(0, 0, 1), colour_grey(UNTOUCHED))
#define PUT_bool(output, value)       probe_put(output, (value) ? 1.0f : 0.0f)
#define PUT_int(output, value)        probe_put(output, (float)(value))
#define PUT_float                     probe_put
#define PUT_Vec3                      probe_put_vec3
#define PUT_Colour                    probe_put_colour
#define PUT_Photon                    put_photon
#define PUT_Hemisphere(output, value) put_hemisphere(output, &(value))
#define PUT_PointStatistics           put_point

static void put_photon(ProbeOutput *output, Photon photon)
{
    probe_put_vec3(output, photon.position);
    probe_put_vec3(output, photon.direction);
    probe_put_colour(output, photon.power);
    probe_put(output, (float)photon.colour);
    probe_put(output, (float)photon.bounce);
    probe_put(output, (float)photon.path);
    probe_put(output, (float)photon.from);
    probe_put(output, photon.flown);
}

static Hemisphere untouched_hemisphere(void)
{
    Hemisphere seen;
    for (int j = 0; j < GATHER_RINGS; j++)
        for (int k = 0; k < GATHER_SECTORS; k++) {
            seen.radiance[j][k] = colour_grey(UNTOUCHED);
            seen.distance[j][k] = UNTOUCHED;
        }
    return seen;
}

// Cell by cell: radiance, distance.
static void put_hemisphere(ProbeOutput *output, const Hemisphere *seen)
{
    for (int j = 0; j < GATHER_RINGS; j++)
        for (int k = 0; k < GATHER_SECTORS; k++) {
            probe_put_colour(output, seen->radiance[j][k]);
            probe_put(output, seen->distance[j][k]);
        }
}

// N, R, τ.
static PointStatistics read_point(ProbeLine *line)
{
    PointStatistics point;
    point.count = (float)probe_number(line);
    point.radius = (float)probe_number(line);
    point.flux = probe_colour(line);
    return point;
}

static void put_point(ProbeOutput *output, PointStatistics point)
{
    probe_put(output, point.count);
    probe_put(output, point.radius);
    probe_put_colour(output, point.flux);
}

#define MOST_DRAWS 100

// How many numbers were taken from the stream; MOST_DRAWS: as many, or more, or it was set to something else.
static int draws_between(Rng before, const Rng *after)
{
    int count = 0;
    for (; count < MOST_DRAWS && before.state != after->state; count++)
        rng_u32(&before);
    return count;
}

// A step's parameters, to be read once and then copied for each call.
#define VALUE(type, name)               type name;
#define CHANGED(type, name)             type name[1];
#define FILLED_ARRAY(type, name, count) type name[count];
#define GIVEN(type, name)
#define RNG
#define REDRAWS
#define DRAWS
#define SCENE_STEP(...)
#define STEP(stage, number, symbol, title, anchor, pass, needs, reader, result, ...)                                   \
    struct symbol##_parameters {                                                                                       \
        char none;                                                                                                     \
        __VA_ARGS__                                                                                                    \
    } symbol;
typedef union {
#include "steps/steps.def"
} Parameters;

static bool read_call(const StepInfo *step, ProbeLine *line, Given *given, Parameters *parameters)
{
    bool ok = false;
#define VALUE(type, name)   p->name = READ_##type(line);
#define CHANGED(type, name) p->name[0] = READ_##type(line);
#define FILLED_ARRAY(type, name, count)                                                                                \
    for (int i = 0; i < count; i++)                                                                                    \
        p->name[i] = UNTOUCHED_##type;
#define GIVEN(type, name)
#define RNG
#define REDRAWS
#define DRAWS
#define SCENE_STEP(stage, number, symbol, ...)                                                                         \
    case STEP_##symbol:                                                                                                \
        return error_set(line->error, "step %s is not called alone; use paths or picture", step->id);
#define STEP(stage, number, symbol, title, anchor, pass, needs, reader, result, ...)                                   \
    case STEP_##symbol: {                                                                                              \
        struct symbol##_parameters *p = &parameters->symbol;                                                           \
        p->none = 0;                                                                                                   \
        ok = read_##reader(line, given);                                                                               \
        __VA_ARGS__                                                                                                    \
        break;                                                                                                         \
    }
    switch (step - step_table) {
#include "steps/steps.def"
    }
    if (ok && (line->broken || !probe_at_end(line)))
        ok = error_set(line->error, "the arguments do not fit step %s", step->id);
    return ok;
}

// Calls the step with what was read and writes its result; what it changed or filled is in `parameters`.
static void call_step(const StepInfo *step, Given *given, const Parameters *read, Parameters *parameters, Rng *rng,
                      ProbeOutput *output)
{
#define VALUE(type, name)               , p->name
#define CHANGED(type, name)             , p->name
#define FILLED_ARRAY(type, name, count) , p->name
#define GIVEN(type, name)               , given->name
#define RNG                             , rng
#define REDRAWS
#define DRAWS
#define SCENE_STEP(...)
#define STEP(stage, number, symbol, title, anchor, pass, needs, reader, result, ...)                                   \
    case STEP_##symbol: {                                                                                              \
        struct symbol##_parameters *p = &parameters->symbol;                                                           \
        *p = read->symbol;                                                                                             \
        PUT_##result(output, steps.symbol(STEP_PARAMETERS(none __VA_ARGS__)));                                         \
        break;                                                                                                         \
    }
    switch (step - step_table) {
#include "steps/steps.def"
    }
}

// What a call did beside its results.
typedef struct {
    long redraws;
    int draws;
} Taken;

static void put_parameters(const StepInfo *step, const Parameters *parameters, const Taken *taken, ProbeOutput *output)
{
#define VALUE(type, name)
#define CHANGED(type, name) PUT_##type(output, p->name[0]);
#define FILLED_ARRAY(type, name, count)                                                                                \
    for (int i = 0; i < count; i++)                                                                                    \
        PUT_##type(output, p->name[i]);
#define GIVEN(type, name)
#define RNG
#define REDRAWS probe_put(output, (float)taken->redraws);
#define DRAWS   probe_put(output, (float)taken->draws);
#define SCENE_STEP(...)
#define STEP(stage, number, symbol, title, anchor, pass, needs, reader, result, ...)                                   \
    case STEP_##symbol: {                                                                                              \
        const struct symbol##_parameters *p = &parameters->symbol;                                                     \
        (void)p, (void)taken;                                                                                          \
        __VA_ARGS__                                                                                                    \
        break;                                                                                                         \
    }
    switch (step - step_table) {
#include "steps/steps.def"
    }
}

static void call_once(const StepInfo *step, Given *given, const Parameters *read, Rng *rng, ProbeOutput *output)
{
    static Parameters fresh;
    Rng start = *rng;
    long redraws = redraw_cap_count();
    given_renew(given);
    call_step(step, given, read, &fresh, rng, output);
    Taken taken = {redraw_cap_count() - redraws, draws_between(start, rng)};
    put_parameters(step, &fresh, &taken, output);
}

bool probe_call(const StepInfo *step, ProbeLine *line, ProbeOutput *output)
{
    static Given given; // large, and one case runs at a time
    memset(&given, 0, sizeof given);
    static Parameters parameters;
    long count = probe_whole(line, 1, MOST_CALLS);
    uint64_t seed = probe_seed(line);
    bool ok = read_call(step, line, &given, &parameters);
    Rng rng = rng_create(seed, 0), same = rng;
    ProbeOutput trial = {0};
    Gather kept = *given.gather; // what one call spoils is to show in the next that counts
    if (ok && count > 1)         // those that draw are called often
        call_once(step, &given, &parameters, &same, &trial);
    *given.gather = kept;
    for (long i = 0; ok && i < count; i++) {
        call_once(step, &given, &parameters, &rng, output);
        ok = i > 0 || count == 1 || probe_same_again(&trial, output, line->error);
    }
    free(trial.values);
    given_free(&given);
    return ok;
}
