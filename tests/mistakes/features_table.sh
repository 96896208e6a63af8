#!/usr/bin/env bash
# Makes the table that the diagnosis reads, tests/mistakes/features.txt: what each step's checks measure on the solution
# and on the a patch of each known mistake, and on each row of more.txt. Mean over SALTS gradings, and the error of a single one: what the check states,
# or half as much again as the gradings scatter, since a check need not state any. Pictures stay out: they are calibrated
# apart.
#
# Usage: features_table.sh > new table      run from the checkout; environment as for grade_case.sh. ONLY, a pattern: measures
# the names that fit it, and takes the others from the table as it is.
set -u
salts=${SALTS:-8}
jobs=${JOBS:-$(nproc)}
export FEATURES=1
. "${BASH_SOURCE%/*}/grader_cases.sh"

table=tests/mistakes/features.txt

# A record, its three lines as one; a name that comes twice is the first's, one that is gone goes. Its text is as it stands today.
joined() {
    paste -d $'\a' - - - | awk -F '\a' 'NR == FNR { split($0, known, "\t"); text[known[1]] = known[2]; next }
        seen[$1]++ { next }
        { name = $1; sub(" ", "_", name); right = name ~ /_right$/ }
        right || name in text { print $1 "\a" (right ? "right" : text[name]) "\a" $3 }' <(mistake_texts) -
}

list() {
    for solution in solutions/*/*.c; do
        step=${solution##*/}
        echo "${step%%_*}_right ${step%%_*} $solution"
    done
    for mistake in tests/mistakes/[0-9]*/; do
        name=$(basename "$mistake")
        echo "$name ${name%%_*} $(echo solutions/*/"${name%%_*}"_*.c) ${mistake}a.patch"
    done
    more_cases
}

for ((i = 0; i < salts; i++)); do
    list | grep -E "^${ONLY:-}" | SALT="table $i" xargs -P "$jobs" -L 1 bash tests/mistakes/grade_case.sh
done | sort -s -k 1,1 | awk '
    function flush(    f, value, scatter, error) {
        if (name == "")
            return
        split(name, part, "_")
        step = part[1]
        printf "%s %s\n\n", step, substr(name, length(step) + 2)
        for (f = 1; f <= count; f++) {
            if (check[f] == "picture")
                continue
            value = odd[f] != "" ? odd[f] : sprintf("%.6g", sum[f] / lines)
            scatter = odd[f] != "" || lines < 2 ? 0 : (spread[f] - sum[f] * sum[f] / lines) / (lines - 1)
            error = stated[f] / lines
            if (scatter > 0 && 1.5 * sqrt(scatter) > error)
                error = 1.5 * sqrt(scatter)
            printf "%s%s:%s:%.3g", (f > 1 ? " " : ""), check[f], value, error
        }
        printf "\n"
    }
    # A line: NAME STEP STATUS CHECK:value:error …
    {
        if ($1 != name) {
            flush()
            name = $1
            count = NF - 3
            lines = 0
            for (f = 1; f <= count; f++)
                sum[f] = spread[f] = stated[f] = odd[f] = ""
        }
        if (NF - 3 != count) {
            print name ": the number of features is not the same for every salt" | "cat >&2"
            next
        }
        lines++
        for (f = 1; f <= count; f++) {
            split($(f + 3), number, ":")
            check[f] = number[1]
            if (number[2] ~ /nan|inf/)
                odd[f] = number[2]
            else {
                sum[f] += number[2]
                spread[f] += number[2] * number[2]
            }
            if (number[3] !~ /nan|inf/)
                stated[f] += number[3]
        }
    }
    END {
        flush()
    }' | cat - ${ONLY:+"$table"} | joined | LC_ALL=C sort -t $'\a' -k 1,1 | tr '\a' '\n'
