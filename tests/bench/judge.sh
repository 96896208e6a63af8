#!/usr/bin/env bash
# How long `make test` takes, with the limits that it is meant to keep: the whole submission in 20 s on two cores, one step
# with its build in 2 s; and what half a processor with 768 MB needs, as Gradescope gives. Usage: judge.sh BUILD
set -u
cd "$(dirname "$0")/../.."
build=$1
. tests/common.sh
cp -r solutions "$work/code"

# cost CORES FLAGS…: seconds, processor seconds, MB of `make test` on so many cores.
cost() {
    local cores=$1
    shift
    taskset -c "0-$((cores - 1))" make --no-print-directory -s BUILD="$build" test CODE="$work/code" "$@" \
        JUDGE_FLAGS="--verbose --jobs $cores" >"$work/out" 2>"$work/err" || { cat "$work/out" "$work/err"; exit 1; }
    sed -n 's/^took \([0-9.]*\) s, \([0-9.]*\) s of processor time, \([0-9]*\) MB.*/\1 \2 \3/p' "$work/err"
}

# best CORES FLAGS…: the fastest of three.
best() {
    for _ in 1 2 3; do cost "$@"; done | sort -n | head -1
}

cores=$(getconf _NPROCESSORS_ONLN)
[ "$cores" -lt 2 ] || cores=2
read -r whole processor memory < <(best "$cores")
check "$whole <= 20" "a complete submission on $cores cores: $whole s (at most 20, aim 10), $processor s of processor time"
check "$processor * 2 <= 600" "the same on half a processor: about $(awk "BEGIN { print 2 * $processor }") s (at most 600)"
check "$memory <= 768" "its largest process: $memory MB (at most 768)"
read -r whole processor memory < <(best 1)
good "a complete submission on one core: $whole s"
for step in 1.5 2.1 3.4; do
    read -r one processor memory < <(best "$cores" STEP=$step)
    check "$one <= 2" "step $step with its build: $one s (at most 2)"
done
finish
