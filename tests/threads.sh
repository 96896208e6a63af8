#!/usr/bin/env bash
# Every scene, looked at in every way, on several numbers of threads: the same bytes as on one. Of a program built for
# ThreadSanitizer, no race either. Usage: threads.sh PROGRAM THREADS…
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/common.sh"
program=$1
shift
# What OpenMP's own library does for order is told to the sanitizer by a library beside clang's.
export TSAN_OPTIONS="exitcode=66 ignore_noninstrumented_modules=1" OMP_TOOL_LIBRARIES
OMP_TOOL_LIBRARIES=$(clang -print-file-name=libarcher.so 2>/dev/null || :)

# same SCENE NAME ENDING ARGUMENTS…: what the arguments write by one thread, and by each other number.
same() {
    local scene=$1 name=$2 ending=$3 t code wrong=""
    shift 3
    rm -f "$work"/one* "$work"/many*
    "$program" "$@" --quiet --threads 1 -o "$work/one$ending" >"$work/said" 2>&1 || wrong="does not run on one: $(tail -3 "$work/said")"
    for t in $threads; do
        "$program" "$@" --quiet --threads "$t" -o "$work/many$ending" >"$work/said" 2>&1
        code=$?
        compared=$((compared + 1))
        [ $code != 66 ] || wrong+=" a race on $t: $(grep -A4 'WARNING: Thread' "$work/said" | head -6)"
        [ $code = 0 ] && cmp -s "$work/one$ending" "$work/many$ending" || wrong+=" differs on $t (exit code $code)"
    done
    [ -z "$wrong" ] && good "$scene, $name" || bad "$scene, $name:$wrong"
}

threads=$*
compared=0
for path in scenes/*.yaml; do
    scene=$(basename "$path" .yaml)
    small="--size 41x29 --photons 20000 --samples 1"
    same "$scene" photons .pfm render "$path" $small
    same "$scene" gather .pfm render "$path" $small --integrator gather
    same "$scene" path .pfm render "$path" $small --integrator path --steps 3.4
    same "$scene" passes .pfm render "$path" $small --passes 3
    same "$scene" "stored photons" .ply photons "$path" --photons 20000
done
echo "$compared comparisons"
finish
