#!/usr/bin/env bash
# Everything `make check` runs, part by part, with the sum of all tests at the end. The makefiles say which targets are parts, and
# when (see tests/tests.mk). Usage: check.sh MAKE MAKEFILE…
set -u
TIMEFORMAT='%0R s; processors: %0U s, and %0S s in the system'
export OMP_WAIT_POLICY=passive # parts run side by side: a thread that waits must not keep a core busy
. "$(dirname "$0")/common.sh"
make=$1
shift

# parts WHEN: the targets that are marked so, in the makefiles' order.
parts() {
    sed -n "s/^##check $1 \([^ ]*\) .*/\1/p" "${makefiles[@]}"
}
makefiles=("$@")

run() {
    { time "$make" --no-print-directory CHECK=1 "$1" >"$work/$1" 2>&1; } 2>"$work/$1.time"
    echo $? $(cat "$work/$1.time") >"$work/$1.code"
}

# Each part closes with "N passed, N failed"; one that does not has failed as a whole.
count() {
    local log=$work/$1 code seconds sum
    read -r code seconds <"$log.code"
    echo "── $1"
    sum=$(grep -E '^[0-9]+ passed, [0-9]+ failed$' "$log" | tail -1)
    if [ -z "$sum" ]; then
        if [ "$code" = 0 ]; then sum="1 passed, 0 failed"; else sum="0 passed, 1 failed"; fi
    elif [ "$code" != 0 ] && [[ $sum == *" 0 failed" ]]; then
        sum="${sum%% *} passed, 1 failed"
    fi
    if [[ $sum == *" 0 failed" ]]; then
        grep -E '^[✓○] ' "$log"
    else
        grep "^✗" "$log" | cut -c1-600
        tail -80 "$log"
    fi
    set -- $sum
    passed=$((passed + $1))
    failed=$((failed + $3))
    echo "   $seconds"
}

one_by_one() {
    local target
    for target in "$@"; do run "$target" && count "$target"; done
}

# two_at_once TARGET…: they wait more than they work.
two_at_once() {
    local target
    for target in "$@"; do
        run "$target" &
        [ "$(jobs -r | wc -l)" -lt 2 ] || wait -n
    done
    wait
}

one_by_one check-build
two_at_once $(parts beside) &
one_by_one $(parts first)
wait
for target in $(parts beside); do count "$target"; done
one_by_one $(parts alone)

echo
finish
