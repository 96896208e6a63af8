// Checks that steps 1.5 and 3.4 share: what a photon does on rough surfaces and mirrors, and the energy of a whole
// room. The step that is graded plays.
#pragma once

#include "judge/checks/path_batches.h"

void plan_furnace(Plan *plan);
void judge_furnace(const Results *results, Finding *finding);
// path_spots.c
void plan_spot(Plan *plan);
void judge_spot(const Results *results, Finding *finding);
void plan_glossy_spot(Plan *plan);
void judge_glossy_spot(const Results *results, Finding *finding);
// path_scenes.c
void plan_mirrors(Plan *plan);
void judge_mirrors(const Results *results, Finding *finding);
void plan_room(Plan *plan);
void judge_room(const Results *results, Finding *finding);

// The power of the light in these scenes, W; the furnace's is its own.
extern const double scene_power[3];
// The chance to survive a surface that leaves `reflectance` of a photon of power `flux`: see step 1.4.
double survival(const double flux[3], const double reflectance[3]);

#define SCENES "tests/steps/scenes/"
