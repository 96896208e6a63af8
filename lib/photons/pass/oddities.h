// What right steps never do: how a person is told of it after a photon pass.
#pragma once

#include "photons/pass/photon_pass.h"
#include "steps/steps.h"

#include <stddef.h>

#define ODDITIES_SIZE 640 // bytes that all of them fit in

typedef struct {
    const Ledger *ledger;
    long paths; // that the ledger is of
    const UnsoundPaths *unsound;
    long redraw_caps;
    const StepState *states; // STEP_COUNT of them: whose code played
} Oddities;

// Lobes redrawn too often, directions of no length with the student's steps that may have given them, flux from
// nowhere: a line for each that is there, each with its newline; an empty text when all is well.
void oddities_describe(const Oddities *found, char *text, size_t size);
