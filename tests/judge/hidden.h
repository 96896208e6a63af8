#ifndef PHOTONLAB_JUDGE_HIDDEN_H
#define PHOTONLAB_JUDGE_HIDDEN_H

#include "arguments.h"

// The sandbox that there is, and what it must not show, which is closed to others where a user of its own runs the code. False: none, and
// for credit there has to be one; it has said so.
bool choose_sandbox(Arguments *a);

#endif
