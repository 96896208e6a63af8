#!/bin/sh
# Chapter 0's first try at step 1.1, rendered. It is the wrong one that the chapter tests, so nothing is given away here.
# Usage: 0_first_try.sh PICTURE
set -eu
folder=$BUILD/figures/0_first_try/1_diffuse_photon_map
mkdir -p "$folder"
cat >"$folder/1.1_reflect.c" <<'STEP'
#include "photonlab.h"

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    float depth = vec3_dot(direction, normal);
    return vec3_along(direction, normal, -depth);
}
STEP
# shellcheck disable=SC2086  # flags are meant to fall apart into words
${PHOTONLAB_CC:-cc} ${PHOTONLAB_FLAGS:--std=c99 -O2 -fPIC} -Ilib ${PHOTONLAB_LINK:--shared} "$folder/1.1_reflect.c" \
    -o "$folder/1.1_reflect.so"
"$BUILD/photonlab" render scenes/box_glass.yaml -o "$1" --code "${folder%/*}" --size 1024x1024 --samples 16 --quiet
