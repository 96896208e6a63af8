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

# Parts that wait more than they work, one after the other beside the rest; `join` counts them.
aside() {
    beside=("$@")
    for target in "$@"; do
        local start=$SECONDS
        "$make" --no-print-directory "$target" >"$logs/$target" 2>&1
        echo $? $((SECONDS - start)) >"$logs/$target.code"
    done &
}

join() {
    local code seconds target
    wait
    for target in "${beside[@]}"; do
        read -r code seconds <"$logs/$target.code"
        count "$target" "$logs/$target" "$code" "$seconds"
    done
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

part "build" "$make" --no-print-directory EXTRA=-Werror judge class-tools meshes
aside check-preview check-notes check-attacks check-class check-reports check-judge
part "unit tests" "$make" --no-print-directory EXTRA=-Werror check-unit
# The preview's start compilers and draw by software; under sanitizers that takes longer than it tells.
part "unit tests under sanitizers" "$make" --no-print-directory check-sanitized SKIP=tests/unit/preview/%
part "gcc and clang, threads: the same bytes" "$make" --no-print-directory check-bytes
part "command line" "$make" --no-print-directory check-cli
part "command line under sanitizers" "$make" --no-print-directory check-cli-sanitized
part "probe" "$make" --no-print-directory check-probe
part "exercises" "$make" --no-print-directory check-exercises
part "the grader graded" env HANDS=b "$make" --no-print-directory check-grader-quick
part "against an independent renderer" "$make" --no-print-directory reference
part "photons against the path tracer" "$make" --no-print-directory agreement SCENES=few
join
part "sandbox" "$make" --no-print-directory check-sandbox # counts seconds, so alone

echo
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
