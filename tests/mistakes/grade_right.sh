#!/usr/bin/env bash
# One grading of a whole right submission without confirmation, for check_grader.sh: a line "STEP first-round STATUS" a step. What
# fails is graded again with confirmation: "STEP confirmed STATUS". Usage: grade_right.sh CODE SALT DIRECTORY
set -u
code=$1 salt=$2 directory=$3
mkdir -p "$directory/work" "$directory/report"
judge() {
    PHOTONLAB_SALT=$salt "$PHOTONLAB_BUILD/judge" --build "$PHOTONLAB_BUILD" --work "$directory/work" --code "$code" --jobs 1 \
        --report "$directory/report" "$@" >"$directory/output" 2>&1
    # The first status after a step's id is its own; those of its checks follow.
    awk -F '"' '/"steps"/ { on = 1 } on && $2 == "id" { id = $4 } on && $2 == "status" && id != "" { print id, $4; id = "" }' \
        "$directory/report/report.json"
}
failures=$(judge --first-round | awk -v run="${code##*/} $salt" '{
    print $1, "first-round", $2, run > "/dev/stderr"
    if ($2 == "fail") print $1
}' 2>"$directory/first")
cat "$directory/first"
for step in $failures; do
    judge --step "$step" | while read -r id status; do echo "# $id confirmed $status ${code##*/} $salt"; done
done
rm -rf "$directory"
