#ifndef PHOTONLAB_TEST_KILLED_JUDGE_H
#define PHOTONLAB_TEST_KILLED_JUDGE_H

#include "judge/sandbox/sandbox.h"

// A judge that runs something without end, as compiler or as probe, in the sandbox of that name. Returns only if it cannot.
int killed_judge(const char *self, const char *name, bool compiler);

// Starts a hundred of them, as `self --sleep NAME compiler|probe`, and kills each: what it started must end with it.
void kill_judges(const char *self, SandboxKind kind);

#endif
