#!/usr/bin/env bash
# Runs cmocka test programs, several at a time, and closes with their sum. Usage: run.sh PROGRAM… RUNNER: what to start
# them with (an emulator).
set -u
. "$(dirname "$0")/../common.sh"
jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
export OMP_NUM_THREADS=2 RUNNER=${RUNNER:-}
# shellcheck disable=SC2016  # $1 belongs to the inner shell
printf '%s\n' "$@" | OUT=$work xargs -P "$jobs" -I{} bash -c '$RUNNER "$1" >"$OUT/${1##*/}" 2>&1; echo $? >"$OUT/${1##*/}.code"' _ {}

for program in "$@"; do
    log=$work/${program##*/}
    good=$(grep -c '^\[       OK \]' "$log")
    bad=$(grep -c '^\[  FAILED  \] [a-z_0-9]*$' "$log")
    code=$(cat "$log.code" 2>/dev/null || echo 127)
    # cmocka prints each failed test twice: where it failed and in the closing list.
    bad=$((bad / 2))
    if [ "$code" != 0 ] && [ "$bad" = 0 ]; then bad=1; fi
    passed=$((passed + good))
    failed=$((failed + bad))
    if [ "$code" = 0 ]; then
        echo "✓ ${program##*/}: $good tests"
    else
        echo "✗ ${program##*/}: exit code $code"
        grep -v '^\[ RUN      \]\|^\[       OK \]' "$log" | head -60
    fi
done
finish
