#!/usr/bin/env bash
# The integrators against the images of an independent renderer (README.md beside this file). Usage: compare.sh PROGRAM [few],
# where few leaves out the box of matt walls alone, which the other has, too.
set -u
here=$(dirname "$0")
. "$here/../common.sh"
program=$1

# compare NAME SCENE RELMSE_LIMIT FLAGS…: mean ratio within 0.5 % per channel; trimmed relMSE below the limit (0: not asked).
compare() {
    local name=$1 scene=$2 limit=$3
    shift 3
    "$program" render "scenes/$scene.yaml" --size 512x512 --quiet -o "$work/image.pfm" "$@" || { bad "$name: does not run"; return; }
    local json
    json=$("$program" diff "$work/image.pfm" "$work/$scene.pfm" --mask 204,56,308,90 --json)
    same_means "$name" "$json"
    local error
    error=$(number "$json" relmse_trimmed)
    if [ "$limit" = 0 ]; then return; fi
    check "$error < $limit" "$name: trimmed relMSE is $error"
}

scenes="box_diffuse box_glass"
[ "${2:-}" != few ] || scenes=box_glass
for scene in $scenes; do
    # POV-Ray's own errors; and paths find the lamp through glass by chance only, which takes more of them.
    if [ $scene = box_diffuse ]; then gathered=2.6e-4 paths=4; else gathered=4.2e-4 paths=16; fi
    xz -dc "$here/${scene}_512.pfm.xz" >"$work/$scene.pfm"
    compare "$scene, path" $scene 0 --integrator path --samples $paths --depth 64
    compare "$scene, gather" $scene $gathered --integrator gather --photons 400000 --k 60 --samples 16 --depth 64
    compare "$scene, photons" $scene 2e-3 --photons 2000000 --k 200 --samples 8 --depth 64
done
finish
