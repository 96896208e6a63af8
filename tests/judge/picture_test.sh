#!/bin/sh
# How good the image verdict is: false verdicts on right code, and how surely it sees known mistakes in the first round.
# `make check-pictures` runs it:
#     picture_test.sh BUILD [GROUPS_OF_RIGHT_CODE [GROUPS_PER_MISTAKE [SET]]]
# Fails when right code fails more often than promised (0.4 % where V counts, 0.2 % elsewhere; at 99.9 % confidence), or
# when a mistake that the picture should show gets past. 598 groups without a miss show 99.5 % at 95 % confidence. Mistakes are
# those of tests/mistakes/pictures.txt; one marked `unseen` is the business of its step's own checks.
set -eu
build=$1
right=${2:-3000}
wrong=${3:-598}
only=${4:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# An object of the step's solution, changed. A change that no longer fits the solution is an error here.
build_mistake() {
    source=$(find solutions -name "$1_*.c")
    sed "$2" "$source" >"$work/step.c"
    if cmp -s "$source" "$work/step.c"; then
        echo "$1: the change \`$2\` changes nothing in $source" >&2
        exit 1
    fi
    $PHOTONLAB_CC $PHOTONLAB_FLAGS -Ilib $PHOTONLAB_LINK "$work/step.c" -o "$work/step.so"
}

# "fail 3/600" in a line of calibrate's → 3
failed_groups() {
    sed -n 's|.*  fail \([0-9]*\)/.*|\1|p' "$1"
}

echo "Right code, $right groups a set:"
for set in 1 2_source 2_phong 3 4 5_pass 5_pixel 6; do
    [ -z "$only" ] || [ "$only" = "$set" ] || continue
    [ "$right" -gt 0 ] || continue
    "$build/calibrate" --build "$build" --measure "$right" "$set" >"$work/line"
    cat "$work/line"
    # The 0.1 % quantile of so many groups, by its normal approximation with a margin for small numbers.
    level=0.002
    case $set in 1 | 5_pass) level=0.004 ;; esac
    most=$(awk "BEGIN { m = $right * $level; print int(m + 3.1 * sqrt(m) + 2) }")
    if [ "$(failed_groups "$work/line")" -gt "$most" ]; then
        echo "   too many: at most $most were to be expected"
        failures=$((failures + 1))
    fi
done

[ "$wrong" -gt 0 ] && echo "Mistakes, $wrong groups each:"
grep -v '^#' tests/mistakes/pictures.txt >"$work/table"
while IFS='|' read -r set step seen name change; do
    [ "$wrong" -gt 0 ] || continue
    [ -z "$only" ] || [ "$only" = "$set" ] || continue
    build_mistake "$step" "$change"
    "$build/calibrate" --build "$build" --measure "$wrong" --step "$step" --object "$work/step.so" --name "$step $name" \
        "$set" >"$work/line" </dev/null
    cat "$work/line"
    if [ "$seen" = seen ] && [ "$(failed_groups "$work/line")" -lt "$wrong" ]; then
        echo "   the picture should show this every time"
        failures=$((failures + 1))
    fi
done <"$work/table"
[ "$failures" -eq 0 ] || { echo "$failures not as promised"; exit 1; }
