#!/usr/bin/env bash
# Is the grader right? Run from the checkout: check_grader.sh quick|matrix|false-verdicts|write
#
#   quick            every known mistake, alternative, stub and solution once, at its own step; with HANDS=b only the second
#                    patch of each mistake, with EVERY=18 one in eighteen of mistakes, alternatives and stubs (both: part of
#                    `make check`); with ONLY='4.2|4.3_' the cases of these names alone
#   matrix           the same with gcc and clang, -O0 and -O2, two salts, on one core and on two: same verdict, same points
#   false-verdicts   right solutions over many salts, one round without confirmation: how often is one called wrong?
#   write            puts what quick, matrix and false-verdicts found last into tests/README.md, and the diagnosis' confusions
#                    into tests/mistakes/confusion.txt
#
# Environment: PHOTONLAB_… (see tests/steps/exercises.mk), JOBS (all cores), SALTS of false-verdicts (40)
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/common.sh"
. "$here/mistakes/grader_cases.sh"
mode=${1:?quick, matrix, false-verdicts or write}
PHOTONLAB_BUILD=$(cd "$PHOTONLAB_BUILD" && pwd)
export CASES=$work/cases
found=$PHOTONLAB_BUILD/grader
mkdir -p "$found" "$CASES" "$work/stubs"
grader_cases "$work/stubs" >"$work/list"

# count PATTERN FILE: how many lines match.
count() {
    grep -cE "$1" "$2"
}

# all_are KIND STATUS TEXT FILE: a check for each case of the kind; one line says it for those that are as they should be.
all_are() {
    local total right case step status rest
    total=$(count "^($1)/" "$4")
    right=$(count "^($1)/[^ ]* [^ ]* $2 " "$4")
    if [ "$right" -gt 0 ]; then
        good "$right of $total $3"
        passed=$((passed + right - 1))
    fi
    while read -r case step status rest; do
        bad "$case: $status at step $step, expected $2"
    done < <(grep -E "^($1)/" "$4" | grep -vE "^[^ ]* [^ ]* $2 ")
    [ "$total" -gt 0 ] || [ -n "${ONLY:-}" ] || bad "no cases of kind $1"
}

# Named rightly, wrongly, or not at all: one line of three numbers for the cases of a kind. A factor that all results have in
# common is a fact, and names nothing.
named() {
    grep -E "^$1/" "$2" | awk "$named_rightly"'{
        right += named_rightly()
        silent += $5 == "-" || $5 == "factor"
    } END { print right + 0, NR - right - silent, silent + 0 }'
}

check_diagnosis() {
    local right wrong silent total
    read -r right wrong silent < <(named b "$1")
    total=$((right + wrong + silent))
    check "$right >= 0.80 * $total" "diagnosis: $right of $total mistakes in another's hand are named rightly"
    check "$wrong <= 0.02 * $total" "diagnosis: $wrong of $total are named wrongly, $silent not at all"
    read -r right wrong silent < <(named unknown "$1")
    check "$silent >= 10 && $wrong == 0" "diagnosis: silent about $silent of $((wrong + silent)) mistakes that it does not know"
}

quick() {
    local results=$found/quick.txt
    [ "${EVERY:-1}${ONLY:-}" = 1 ] || results=$found/some.txt # no table is written of these
    grep -E "^([^/]{2,}|[${HANDS:-ab}])/(${ONLY:-})" "$work/list" |
        awk -F/ -v every="${EVERY:-1}" '$1 !~ /^([ab]|more|right|stub)$/ || n[$1]++ % every == 0' |
        grade_cases | sort >"$results"
    all_are "a|b|more" fail "known mistakes fail at the step that they name" "$results"
    all_are unknown fail "unknown mistakes fail at their step" "$results"
    all_are right pass "differently written right solutions pass" "$results"
    all_are solution pass "solutions pass" "$results"
    all_are stub todo "stubs are not started, and none passes" "$results"
    if [ -z "${ONLY:-}" ]; then check_diagnosis "$results"; else cat "$results"; fi
}

# One run of the matrix; its verdicts must be those of the first.
matrix_run() {
    local title=$1 file="$found/matrix_${1//[^A-Za-z0-9]/_}.txt" differ
    shift
    env "$@" bash -c '. tests/mistakes/grader_cases.sh; grade_cases' <"$work/list" | sort >"$file"
    [ -e "$found/matrix_first.txt" ] || cp "$file" "$found/matrix_first.txt"
    differ=$(diff <(cut -d ' ' -f 1-4 "$found/matrix_first.txt") <(cut -d ' ' -f 1-4 "$file") | grep '^[<>]')
    if [ -z "$differ" ]; then
        good "$title: verdict and points of $(wc -l <"$file") cases are the same"
    else
        bad "$title: verdicts differ"
        echo "$differ"
    fi
}

matrix() {
    rm -f "$found"/matrix_*.txt
    local flags=$PHOTONLAB_FLAGS compiler level salt
    for compiler in gcc clang; do
        for level in -O0 -O2; do
            for salt in photonlab another; do
                matrix_run "$compiler $level, salt $salt" PHOTONLAB_CC=$compiler SALT=$salt PHOTONLAB_FLAGS="${flags/-O2/$level}"
            done
        done
    done
    # The runs above have all cores; one after the other on the first core alone:
    matrix_run "gcc -O2, one core" JOBS=1 PIN=0
    cat "$found"/matrix_*salt*.txt >"$found/matrix.txt"
    check_diagnosis "$found/matrix.txt"
}

# A submission of right solutions only: the first, second, … alternative of every step; 0: the solutions.
right_submission() {
    local solution place files
    for solution in solutions/*/*.c; do
        place=${solution#solutions/}
        files=("tests/alternatives/${place%.c}"/*.c)
        mkdir -p "$2/${place%/*}"
        if [ "$1" = 0 ]; then cp "$solution" "$2/$place"; else cp "${files[$1 - 1]}" "$2/$place"; fi
    done
}

false_verdicts() {
    local i salt submission
    for submission in 0 1 2 3 4; do
        right_submission $submission "$work/right$submission"
        for ((i = 0; i < ${SALTS:-40}; i++)); do
            echo "$work/right$submission salt$i $CASES/$submission.$i"
        done
    done | nice xargs -P "${JOBS:-$(nproc)}" -L 1 bash "$here/mistakes/grade_right.sh" >"$found/false_verdicts.txt"
    local trials first confirmed
    trials=$(count " first-round " "$found/false_verdicts.txt")
    first=$(count " first-round fail" "$found/false_verdicts.txt")
    confirmed=$(count " confirmed fail" "$found/false_verdicts.txt")
    local other
    other=$(count " (error|todo|skip)" "$found/false_verdicts.txt")
    check "$trials >= 3000" "$trials steps of right solutions were graded, one round each"
    check "$other == 0" "$other of them ended in an error"
    # The promise: 0.1 % for a step's own checks, which in stage 5 and in 6.1 to 6.3 have no chance in them, and 0.2 % for its
    # picture, 0.4 % in steps 1.6, 5.1 and 5.2, where the noise counts, too.
    # More than this many would happen once in 10 000 times.
    check "$first <= $(most_at_level "$trials")" \
        "$first of them failed the first round (promised: 0.30 %); at most $(clopper_pearson "$first" "$trials" 0.95) % at 95 % confidence"
    check "$confirmed == 0" "$confirmed of them failed again on fresh random numbers; at most \
$(clopper_pearson "$confirmed" "$trials" 0.95) % at 95 % confidence"
}

# The most failures in $1 trials at a level of (21·0.1 + 25·0.2 + 3·0.4)/28 % that are still believable (upper tail 1e-4).
most_at_level() {
    awk -v n="$1" 'BEGIN {
        mean = n * (21 * 0.001 + 25 * 0.002 + 3 * 0.004) / 28
        term = sum = exp(-mean)
        for (k = 0; sum < 1 - 1e-4; ) { k++; term *= mean / k; sum += term }
        print k
    }'
}

start=$SECONDS
case $mode in
quick) quick ;;
matrix) matrix ;;
false-verdicts) false_verdicts ;;
write) . "$here/mistakes/grader_table.sh"; write_table ;;
*) echo "check_grader.sh quick|matrix|false-verdicts|write"; exit 2 ;;
esac
echo "took $((SECONDS - start)) s"
finish
