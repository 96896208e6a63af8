// What the program build/probe is made of. It runs one step of a student, or several together, and writes down what came out, as numbers; it
// judges nothing and knows no right answer.
//
// It reads cases, one a line, words parted by spaces:
//   call COUNT SEED ARGUMENT…      the step COUNT times, call i with the random stream (SEED, i); what its row in lib/steps/steps.def lists
//   paths SCENE PHOTONS BATCHES DEPTH STEPS SEED             photon passes in BATCHES parts; see probe_paths.c
//   picture INTEGRATOR SCENE WIDTH HEIGHT PHOTONS K DEPTH STEPS SEED    one picture, one eye ray a pixel
//   passes COUNT pass|pixel INTEGRATOR …                    the same by passes, with a radius for each of them or for each pixel
//   scatter SCENE PHOTONS ROOM DEPTH STEPS SEED              the photons of one pass, at most ROOM; see probe_sizes.h
// SCENE is a path from --root, STEPS what `--steps` takes. The numbers are written as they come off this machine, case by case:
//   "photonlab probe 1\n", then for every case two uint32 (its number from 0, how many floats) and the floats.
#pragma once

#include "photonlab.h"

#include <stdint.h>
#include <stdio.h>

// Results on their way out.
typedef struct {
    float *values;
    size_t count, capacity;
    bool out_of_memory;
} ProbeOutput;

void probe_put(ProbeOutput *output, float value);
void probe_put_vec3(ProbeOutput *output, Vec3 v);
void probe_put_colour(ProbeOutput *output, Colour c);

// One line's words, taken one after the other. A word that is missing or no number makes `broken` true.
typedef struct {
    char *rest;
    bool broken;
    Error *error; // what is wrong otherwise
} ProbeLine;

const char *probe_word(ProbeLine *line);
double probe_number(ProbeLine *line);
long probe_whole(ProbeLine *line, long low, long high);
uint64_t probe_seed(ProbeLine *line);
Vec3 probe_vec3(ProbeLine *line);
Colour probe_colour(ProbeLine *line);
bool probe_at_end(ProbeLine *line);
Scene *probe_scene(const char *path, Error *error); // from --root

// The kinds of case. False, with a reason, when a line is broken or a scene cannot be had.
bool probe_call(const StepInfo *step, ProbeLine *line, ProbeOutput *output);
bool probe_paths(ProbeLine *line, ProbeOutput *output);
bool probe_picture(ProbeLine *line, ProbeOutput *output);
bool probe_passes(ProbeLine *line, ProbeOutput *output);
bool probe_scatter(ProbeLine *line, ProbeOutput *output);

// A step whose result is another when it is called again has random numbers of its own, or reads a variable that it never set.
#define PROBE_NOT_AGAIN                                                                                                \
    "gave another result when it was called again with the same arguments and the same random numbers"
bool probe_same_again(const ProbeOutput *first, const ProbeOutput *again, Error *error);

// From here on, a crash writes one line to standard error before the program dies of it:
//   photonlab-crash signal=11 case=3 address=0x0 stack=near|far peak_kb=N step=ID frames=OFFSET,OFFSET…
// where frames are places in `object`, innermost first; of several objects, objects/ID/step.so, in the innermost one that
// is met, whose ID is told. So does running out of processor time (SIGXCPU). Either may be NULL.
void probe_watch(const char *object, const char *objects);
extern volatile int probe_case; // the case that runs
