# A stage with two steps, of which the second calls the first. It is the course's next: NUMBER stands for its number in the
# names of new/ and in the files.
most=7
n=$(($(grep -c '^STAGE(' lib/steps/steps.def) + 1))
(cd "$trials/stage/new" && find . -type f) | while read -r file; do sed -i "s/NUMBER/$n/g" "$file"; done
find . -depth -name '*NUMBER*' ! -path './tests/extend/*' | while read -r file; do mv "$file" "${file%/*}/$(basename "$file" | sed "s/NUMBER/$n/")"; done
added lib/steps/${n}_toy.h "${n}_toy.h"
added lib/steps/hints/$n.1_halve.txt "$n.1_halve"
added solutions/${n}_toy/$n.1_halve.c "$n.1_halve"
added tests/steps/${n}_toy/$n.1_halve.c "halve_checks"
added exercises/${n}_toy/README.md "exercises/${n}_toy/README.md"
added course_notes/${n}_toy.md "${n}_toy.html#halving is nowhere"
place lib/steps/steps.def '#undef FOLDER' "#define FOLDER \"${n}_toy\"
#include \"steps/${n}_toy.h\"
STAGE($n, \"scenes/box_glass.yaml\")

STEP($n, 1, halve, \"Halve a value\", \"halving\", PHOTON_PASS, \"\", arguments, float, VALUE(float, value))
STEP($n, 2, mean_of_two, \"The mean of two values\", \"mean\", PHOTON_PASS, \"$n.1\", arguments, float, VALUE(float, a) VALUE(float, b))

#undef FOLDER" "halve"
place tests/judge/points.txt "step 4.5" "step $n.1 2
step $n.2 2" "points.txt"
place README.md "| 4 final gathering" "| $n toy | $n.1 halve · $n.2 mean of two |" "README.md has no row"
place exercises/README.md "| [4 final gathering" "| [$n toy](${n}_toy/README.md) | a mean |" "exercises/README.md has no row"
place course_notes/0_start_here.md "| 4 | [final gathering]" "| $n | [toy](${n}_toy.html) | a mean |" "0_start_here.md has no row"
place course_notes/index.md "| 4.5 |" "| $n.1 | \`halve\` | [Halving](${n}_toy.html#halving) |
| $n.2 | \`mean_of_two\` | [The mean](${n}_toy.html#mean) |" "index.md has no row"

try() {
    build judge meshes && make -s exercises >/dev/null && build check-exercises || return 1
    local verdicts
    verdicts=$(make -s OPTIMISE=-O0 CC=gcc test STAGE=$n CODE=solutions 2>&1) || { echo "$verdicts"; return 1; }
    [[ $verdicts == *"2 passed, 0 failed"* ]] || { echo "$verdicts"; return 1; }
    verdicts=$(make -s OPTIMISE=-O0 CC=gcc test STEP=$n.1 2>&1)
    [[ $verdicts == *"1 not started"* ]] || { echo "the stub of $n.1: $verdicts"; return 1; }
    ! command -v pandoc >/dev/null || build check-notes
}
