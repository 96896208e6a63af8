#!/usr/bin/env bash
# The diagnosis on mistakes that its table was not made from: tests/mistakes/fresh/, written after it, in another style. A file
# is right code, and with -DMISTAKE=N a mistake of it; its first lines say which names fit: `-` is one that the table does not
# have. At least half are to be named rightly, at most 2 % wrongly.
#
# Usage: fresh_mistakes.sh      run from the checkout; environment as for grade_case.sh; JOBS, ONLY (a pattern of STEP.N)
set -u
. "${BASH_SOURCE%/*}/../common.sh"
. "${BASH_SOURCE%/*}/grader_cases.sh"
export CASES=$work/cases

grade() {
    local file=$1 number=$2 fits=$3 name
    name=${file##*/}
    PHOTONLAB_FLAGS="$PHOTONLAB_FLAGS -DMISTAKE=$number" bash tests/mistakes/grade_case.sh "${name%%_*}.$number" "${name%%_*}" "$file" |
        sed "s/$/ $fits/"
}
export -f grade

for file in tests/mistakes/fresh/*/*.c; do
    echo "$file 0 -"
    sed -n 's|^// *\([0-9]*\) *\([^ ]*\).*|\1 \2|p' "$file" | sed "s|^|$file |"
done | awk -v only="^${ONLY:-}" '{ name = $1; sub(/.*\//, "", name); sub(/_.*/, "", name); if (name "." $2 ~ only) print }' |
    nice xargs -P "${JOBS:-$(nproc)}" -L 1 bash -c 'grade "$@"' _ | sort -V >"$work/found"

# Lines "STEP.N STEP STATUS POINTS NAMED FITS".
awk '
    NR == FNR { name = $1; sub(/^[^\t]*\t/, ""); text[name] = $0; next }
    # By its words: several names may have the same.
    function fits(    i, n, wanted) {
        n = split($6, wanted, "|")
        for (i = 1; i <= n; i++)
            if (wanted[i] == $5 || text[$2 "_" wanted[i]] == text[$2 "_" $5] "") return $5 != "-" && wanted[i] != "-"
        return 0
    }
    $1 ~ /\.0$/ { if ($3 != "pass") print "✗ " $1 ": right code, and " $3; next }
    { all++ }
    $3 == "pass" { uncaught++; print "  " $1 ": passes, and should not"; next }
    fits() { right++; next }
    $5 == "-" { silent++; if ($6 != "-") print "  " $1 ": nothing said of " $6; next }
    $5 == "factor" { facts++; print "  " $1 ": a factor, true: " $6; next }
    { wrong++; print "  " $1 ": called " $5 ", is " $6 }
    END { print "SUM", all + 0, right + 0, wrong + 0, silent + 0, facts + 0, uncaught + 0 }' <(mistake_texts) "$work/found" >"$work/said"
grep -v '^SUM\|^✗' "$work/said"
failed=$(grep -c '^✗' "$work/said")
grep '^✗' "$work/said"
read -r _ all right wrong silent facts uncaught < <(grep '^SUM' "$work/said")
check "$right >= 0.5 * $all" "$right of $all fresh mistakes are named rightly ($facts more by their factor alone, $silent not at all)"
check "$uncaught <= 0.01 * $all" "all but $uncaught of $all fresh mistakes are caught"
check "$wrong <= 0.02 * $all" "$wrong of $all are named wrongly"
finish
