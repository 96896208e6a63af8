#!/usr/bin/env bash
# Grades one case of the grader's own tests: one source file at its own step. Prints "CASE STEP STATUS POINTS MISTAKE"
# (MISTAKE: what the diagnosis named, or -).
#
# Usage: grade_case.sh CASE STEP SOURCE [PATCH]      run from the checkout; SOURCE is copied to its place in a submission
# that holds nothing else, and patched; with a table as PATCH (more.txt), by the row of the case's name. Environment: PHOTONLAB_… (see tests/steps/exercises.mk), SALT, CASES (a
# directory to work in), FEATURES (not empty: print the judge's line of features instead), PIN (a core to stay on), JUDGE_FLAGS.
set -u
case=$1 step=$2 source=$3 patch=${4:-}
directory=$CASES/${case//\//__}
solution=$(echo solutions/*/"$step"_*.c)
place=${solution#solutions/}
rm -rf "$directory"
mkdir -p "$directory/code/${place%/*}" "$directory/work" "$directory/report"
cp "$source" "$directory/code/$place"
if [ "${patch##*.}" = txt ]; then
    awk -F '|' -v name="${case##*/}" '$1 == name { sub("^[^|]*[|][^|]*[|]", ""); print }' "$patch" >"$directory/edit"
    sed -i -f "$directory/edit" "$directory/code/$place"
    cmp -s "$source" "$directory/code/$place" && { echo "$case $step row-changes-nothing 0 -"; exit 0; }
elif [ -n "$patch" ] && ! patch -s -d "$directory/code" -p2 <"$patch" >"$directory/patch.log" 2>&1; then
    echo "$case $step patch-does-not-apply 0 -"
    exit 0
fi
run_judge() {
    # shellcheck disable=SC2086 # flags are words
    PHOTONLAB_SALT=${SALT:-} ${PIN:+taskset -c "$PIN"} "$PHOTONLAB_BUILD/judge" --build "$PHOTONLAB_BUILD" --work "$directory/work" --code "$directory/code" \
        --step "$step" --jobs 1 ${JUDGE_FLAGS:-} "$@"
}
if [ -n "${FEATURES:-}" ]; then
    echo "$case $(run_judge --features 2>"$directory/stderr")"
else
    run_judge --report "$directory/report" >"$directory/stdout" 2>"$directory/stderr"
    code=$?
    report=$directory/report/report.json
    # The step comes before its checks, so that the first of each name in the array is the step's own.
    value() { sed -n '/"steps"/,$ s/^ *"'"$1"'": "\{0,1\}\([^",]*\)"\{0,1\},\{0,1\}$/\1/p' "$report" 2>/dev/null | head -1; }
    status=$(value status) mistake=$(value mistake)
    echo "$case $step ${status:-no-report-$code} $(value points) ${mistake:--}"
fi
[ -n "${KEEP:-}" ] || rm -rf "$directory"
