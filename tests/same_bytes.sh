#!/usr/bin/env bash
# The same bytes for 1, 2 and 7 threads and from two compilers. Usage: same_bytes.sh PROGRAM OTHER_PROGRAM
# The same from another machine's program alone: same_bytes.sh PROGRAM OTHER_PROGRAM MACHINE ROUNDS; with fewer photons, as it is
# emulated. ROUNDS, an expression, tells the names where a function of that C library rounds otherwise: means are compared there.
set -u
here=$(dirname "$0")
. "$here/common.sh"
ours=$1
other=$2
threads="2 7" who="gcc and clang" fewer="" rounds='^$'
[ $# -lt 3 ] || threads="" who="here and $3" fewer="--photons 8000" rounds=$4

# same NAME ENDING ARGUMENTS…: what the arguments write, by every number of threads and both programs.
same() {
    local name=$1 ending=$2
    shift 2
    # shellcheck disable=SC2086  # falls apart into words
    set -- "$@" $fewer
    rm -f "$work"/one* "$work"/many* "$work"/other*
    "$ours" "$@" --quiet --threads 1 -o "$work/one$ending" || { bad "$name: does not run"; return; }
    local t
    for t in $threads; do
        rm -f "$work/many$ending"
        "$ours" "$@" --quiet --threads $t -o "$work/many$ending"
        compare $? "$work/one$ending" "$work/many$ending" "$name: 1 and $t threads"
    done
    "$other" "$@" --quiet --threads 2 -o "$work/other$ending"
    local code=$?
    if [ $code = 0 ] && [[ $name =~ $rounds ]]; then
        [ "$ending" != .pfm ] || same_means "$name: $who, rounded otherwise" "$("$ours" diff --json "$work"/{one,other}.pfm)"
        return
    fi
    compare $code "$work/one$ending" "$work/other$ending" "$name: $who"
}

# compare CODE ONE OTHER NAME: did the run that wrote the other file end with 0, and are both the same?
compare() {
    if [ "$1" != 0 ]; then
        bad "$4: exit code $1"
    elif cmp -s "$2" "$3"; then
        good "$4"
    else
        bad "$4 differ"
    fi
}

for scene in box_glass box_glossy box_dispersion diamond cornell_box; do
    same "$scene, photons" .pfm render "scenes/$scene.yaml" --size 97x61 --photons 60000 --samples 3 --k 40
done
same "box_glossy, steps 2.3 and 1.5" .pfm render scenes/box_glossy.yaml --steps 2.3,1.5 --size 97x61 --photons 60000 --samples 3
same "box_glass, gather" .pfm render scenes/box_glass.yaml --integrator gather --size 97x61 --photons 60000 --samples 3 --k 40
same "box_glass, by passes" .pfm render scenes/box_glass.yaml --passes 5 --size 97x61 --photons 20000
same "box_glass, by passes, radii by pixel" .pfm render scenes/box_glass.yaml --passes 3 --radii pixel --size 97x61 --photons 20000
same "box_dispersion, wavelengths" .pfm render scenes/box_dispersion.yaml --spectral --size 97x61 --photons 60000 --samples 3 --k 40
same "box_glass, photons only" .pfm render scenes/box_glass.yaml --integrator photons-only --size 97x61 --photons 60000 --samples 2
same "box_dispersion, path" .pfm render scenes/box_dispersion.yaml --integrator path --size 97x61 --samples 4
same "box_dispersion, stored photons" .ply photons scenes/box_dispersion.yaml --photons 50000
same "prism, PNG" .png render scenes/prism.yaml --size 96x54 --photons 60000 --samples 2
finish
