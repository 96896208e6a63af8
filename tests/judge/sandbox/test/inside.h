// The parts of test_sandbox.
#pragma once

#include "judge/sandbox/sandbox.h"

// ---- inside.c

// `what` is done, with `path` where it needs one. Returns the program's exit code; 99: there is no such thing to do.
int inside(const char *what, const char *path);

// ---- killed_judge.c

// A judge that runs something without end, as compiler or as probe, in the sandbox of that name. Returns only if it cannot.
int killed_judge(const char *self, const char *name, bool compiler);

// Starts a hundred of them, as `self --sleep NAME compiler|probe`, and kills each: what it started must end with it.
void kill_judges(const char *self, SandboxKind kind);
