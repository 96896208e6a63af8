#!/usr/bin/env bash
# Two methods, one answer: photons against the path tracer, on the scenes that both can render (light through glass or off mirrors from a
# point, spot or beam is out of a path tracer's reach). Tenfold photons at a smaller radius must come closer.
# Usage: agreement.sh PROGRAM
set -u
here=$(dirname "$0")
. "$here/common.sh"
program=$1

# relative error and mean ratio of photons against the path image of the same flags
agree() {
    local name=$1 scene=$2
    shift 2
    local size="--size 128x128 --quiet"
    "$program" render "$scene" $size --integrator path --samples 256 "$@" -o "$work/path.pfm" || { bad "$name: does not run"; return; }
    "$program" render "$scene" $size --photons 100000 --k 50 --radius 0 --samples 32 "$@" -o "$work/few.pfm"
    "$program" render "$scene" $size --photons 1000000 --k 160 --radius 0 --samples 32 "$@" -o "$work/many.pfm"
    local few many c
    few=$("$program" diff "$work/few.pfm" "$work/path.pfm" --json)
    many=$("$program" diff "$work/many.pfm" "$work/path.pfm" --json)
    for c in 0 1 2; do
        check "$(number "$many" mean_ratio $c) > 0.995 && $(number "$many" mean_ratio $c) < 1.005" \
            "$name: mean ratio of channel $c is $(number "$many" mean_ratio $c)"
    done
    check "$(number "$many" relmse_trimmed) < $(number "$few" relmse_trimmed)" \
        "$name: relMSE falls from $(number "$few" relmse_trimmed) to $(number "$many" relmse_trimmed)"
}

for scene in box_diffuse box_glass box_glossy cornell_box; do
    agree $scene scenes/$scene.yaml
done
agree "box_glossy, step 2.3" scenes/box_glossy.yaml --steps 2.3
for scene in "$here"/agreement/*.yaml; do
    agree "$(basename "$scene" .yaml)" "$scene"
done
finish
