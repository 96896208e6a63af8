# A stage with two steps, of which the second calls the first.
most=7
added lib/steps/5_toy.h "5_toy.h"
added lib/steps/hints/5.1_halve.txt "5.1_halve"
added solutions/5_toy/5.1_halve.c "5.1_halve"
added tests/steps/5_toy/5.1_halve.c "halve_checks"
added exercises/5_toy/README.md "exercises/5_toy/README.md"
added course_notes/5_toy.md "5_toy.html#halving is nowhere"
place lib/steps/steps.def '#undef FOLDER' '#define FOLDER "5_toy"
#include "steps/5_toy.h"
STAGE(5, "scenes/box_glass.yaml")

STEP(5, 1, halve, "Halve a value", "halving", PHOTON_PASS, "", arguments, float, VALUE(float, value))
STEP(5, 2, mean_of_two, "The mean of two values", "mean", PHOTON_PASS, "5.1", arguments, float, VALUE(float, a) VALUE(float, b))

#undef FOLDER' "halve"
place tests/judge/points.txt "step 4.5" "step 5.1 2
step 5.2 2" "points.txt"
place README.md "| 4 final gathering" "| 5 toy | 5.1 halve · 5.2 mean of two |" "README.md has no row"
place exercises/README.md "| [4 final gathering" "| [5 toy](5_toy/README.md) | a mean |" "exercises/README.md has no row"
place course_notes/0_start_here.md "| 4 | [final gathering]" "| 5 | [toy](5_toy.html) | a mean |" "0_start_here.md has no row"
place course_notes/index.md "| 4.5 |" "| 5.1 | \`halve\` | [Halving](5_toy.html#halving) |
| 5.2 | \`mean_of_two\` | [The mean](5_toy.html#mean) |" "index.md has no row"

try() {
    build judge meshes && make -s exercises >/dev/null && build check-exercises || return 1
    local verdicts
    verdicts=$(make -s OPTIMISE=-O0 CC=gcc test STAGE=5 CODE=solutions 2>&1) || { echo "$verdicts"; return 1; }
    [[ $verdicts == *"2 passed, 0 failed"* ]] || { echo "$verdicts"; return 1; }
    verdicts=$(make -s OPTIMISE=-O0 CC=gcc test STEP=5.1 2>&1)
    [[ $verdicts == *"1 not started"* ]] || { echo "the stub of 5.1: $verdicts"; return 1; }
    ! command -v pandoc >/dev/null || build check-notes
}
