# A stage with two steps, of which the second calls the first.
most=7
added lib/steps/4_toy.h "4_toy.h"
added lib/steps/hints/4.1_halve.txt "4.1_halve"
added solutions/4_toy/4.1_halve.c "4.1_halve"
added tests/steps/4_toy/4.1_halve.c "halve_checks"
added exercises/4_toy/README.md "exercises/4_toy/README.md"
added course_notes/4_toy.md "4_toy.html#halving is nowhere"
place lib/steps/steps.def '#undef FOLDER' '#define FOLDER "4_toy"
#include "steps/4_toy.h"
STAGE(4, "scenes/box_glass.yaml")

STEP(4, 1, halve, "Halve a value", "halving", PHOTON_PASS, "", arguments, float, VALUE(float, value))
STEP(4, 2, mean_of_two, "The mean of two values", "mean", PHOTON_PASS, "4.1", arguments, float, VALUE(float, a) VALUE(float, b))

#undef FOLDER' "halve"
place tests/judge/points.txt "step 3.5" "step 4.1 2
step 4.2 2" "points.txt"
place README.md "| 3 colour dispersion" "| 4 toy | 4.1 halve · 4.2 mean of two |" "README.md has no row"
place exercises/README.md "| [3 colour dispersion" "| [4 toy](4_toy/README.md) | a mean |" "exercises/README.md has no row"
place course_notes/0_start_here.md "| 3 | [colour dispersion]" "| 4 | [toy](4_toy.html) | a mean |" "0_start_here.md has no row"
place course_notes/index.md "| 3.5 |" "| 4.1 | \`halve\` | [Halving](4_toy.html#halving) |
| 4.2 | \`mean_of_two\` | [The mean](4_toy.html#mean) |" "index.md has no row"

try() {
    build judge meshes && make -s exercises >/dev/null && build check-exercises || return 1
    local verdicts
    verdicts=$(make -s OPTIMISE=-O0 CC=gcc test STAGE=4 CODE=solutions 2>&1) || { echo "$verdicts"; return 1; }
    [[ $verdicts == *"2 passed, 0 failed"* ]] || { echo "$verdicts"; return 1; }
    verdicts=$(make -s OPTIMISE=-O0 CC=gcc test STEP=4.1 2>&1)
    [[ $verdicts == *"1 not started"* ]] || { echo "the stub of 4.1: $verdicts"; return 1; }
    ! command -v pandoc >/dev/null || build check-notes
}
