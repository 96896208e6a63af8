#!/usr/bin/env bash
# Everything `make check` runs, part by part, with the sum of all tests at the end. Usage: check.sh MAKE
set -u
make=${1:-make}
passed=0
failed=0
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT

# Each part closes with "N passed, N failed"; one that does not has failed as a whole.
part() {
    local title=$1 start=$SECONDS
    shift
    "$@" >"$logs/part" 2>&1
    count "$title" "$logs/part" $? $((SECONDS - start))
}

# A part that waits more than it works, beside the others; `join` counts it.
aside() {
    aside_title=$1
    shift
    aside_start=$SECONDS
    {
        "$@" >"$logs/aside" 2>&1
        echo $? $((SECONDS - aside_start)) >"$logs/aside.code"
    } &
}

join() {
    local code seconds
    wait
    read -r code seconds <"$logs/aside.code"
    count "$aside_title" "$logs/aside" "$code" "$seconds"
}

# count TITLE LOG CODE SECONDS
count() {
    local log=$2 code=$3 seconds=$4 sum
    echo "── $1"
    sum=$(grep -E '^[0-9]+ passed, [0-9]+ failed$' "$log" | tail -1)
    if [ -z "$sum" ]; then
        if [ $code = 0 ]; then sum="1 passed, 0 failed"; else sum="0 passed, 1 failed"; fi
    elif [ $code != 0 ] && [[ $sum == *" 0 failed" ]]; then
        sum="${sum%% *} passed, 1 failed"
    fi
    if [[ $sum == *" 0 failed" ]]; then
        grep -E '^[✓○] ' "$log"
    else
        tail -80 "$log"
    fi
    set -- $sum
    passed=$((passed + $1))
    failed=$((failed + $3))
    echo "   $seconds s"
}

part "build" "$make" --no-print-directory judge class-tools
aside "attacks" "$make" --no-print-directory check-attacks
part "unit tests" "$make" --no-print-directory check-unit
part "unit tests under sanitizers" "$make" --no-print-directory check-sanitized
part "gcc and clang, threads: the same bytes" "$make" --no-print-directory check-bytes
part "command line" "$make" --no-print-directory check-cli
part "command line under sanitizers" "$make" --no-print-directory check-cli-sanitized
part "probe" "$make" --no-print-directory check-probe
part "exercises" "$make" --no-print-directory check-exercises
join
part "the grader graded" env HANDS=b "$make" --no-print-directory check-grader-quick
part "judge" "$make" --no-print-directory check-judge
part "sandbox" "$make" --no-print-directory check-sandbox
part "reports" "$make" --no-print-directory check-reports
part "class, handout, submitting" "$make" --no-print-directory check-class
part "against an independent renderer" "$make" --no-print-directory reference
part "photons against the path tracer" "$make" --no-print-directory agreement

echo
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
