#!/usr/bin/env bash
# Two methods, one answer: photons against the path tracer, on the scenes that both can render (light through glass or off mirrors from a
# point, spot or beam is out of a path tracer's reach). Tenfold photons must come closer: of 160 in place of 50 an estimate is less noisy, and
# the disk they are taken from, a third as large, blurs less. Either is worth a factor of about 1/3 in relMSE. The path image's own noise, the
# same in both comparisons, lifts that to 0.6 at most with the samples below; 0.7 is asked for.
# Gathered pictures must be as bright.
# Usage: agreement.sh PROGRAM [few], where few has half the pixels and leaves out the scenes whose surfaces and lights others have, too.
set -u
here=$(dirname "$0")
. "$here/common.sh"
program=$1
if [ "${2:-}" = few ]; then side=48; else side=64; fi

# agree NAME SCENE PATH_SAMPLES FLAGS…: relative error and mean ratio of photons against the path image of the same flags
agree() {
    local name=$1 scene=$2 samples=$3
    shift 3
    local size="--size ${side}x$side --quiet"
    rm -f "$work"/*.pfm
    "$program" render "$scene" $size --integrator path --samples "$samples" "$@" -o "$work/path.pfm" &&
        "$program" render "$scene" $size --photons 100000 --k 50 --radius 0 --samples 64 "$@" -o "$work/few.pfm" &&
        "$program" render "$scene" $size --photons 1000000 --k 160 --radius 0 --samples 64 "$@" -o "$work/many.pfm" ||
        { bad "$name: does not run"; return; }
    local few many
    few=$("$program" diff "$work/few.pfm" "$work/path.pfm" --json)
    many=$("$program" diff "$work/many.pfm" "$work/path.pfm" --json)
    same_means "$name" "$many"
    "$program" render "$scene" $size --integrator gather --photons 400000 --k 60 --radius 0 --samples 144 "$@" -o "$work/gather.pfm"
    same_means "$name, gathered" "$("$program" diff "$work/gather.pfm" "$work/path.pfm" --json)"
    check "$(number "$many" relmse_trimmed) < 0.7 * $(number "$few" relmse_trimmed)" \
        "$name: relMSE falls from $(number "$few" relmse_trimmed) to $(number "$many" relmse_trimmed)"
}

if [ "${2:-}" != few ]; then
    for scene in box_diffuse box_glossy cornell_box; do
        agree $scene scenes/$scene.yaml 1024
    done
    agree box_glass scenes/box_glass.yaml 2048
fi
agree "box_glossy, step 2.3" scenes/box_glossy.yaml 2048 --steps 2.3
agree "every kind of light" "$here/agreement/lights.yaml" 1024
# A path finds the lamp through glass by chance only, which takes more of them.
agree "dispersing glass" "$here/agreement/dispersion.yaml" 2048
agree "matt things in glass" "$here/agreement/matt_in_glass.yaml" 2048
finish
