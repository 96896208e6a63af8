#!/bin/sh
# What the terminal shows in chapter 0, by running it: 0_terminal.sh CASE OUT. The code is the chapter's own, in a folder
# that is called exercises/ in what is written. Points and lists follow tests/judge/points.txt and lib/steps/steps.def : made anew with them.
set -eu
root=$BUILD/figures/0_terminal
code=$root/exercises
rm -rf "$root"
mkdir -p "$root"
cp -r exercises "$code"

# reflect LINE…: step 1.1 with these lines in it.
reflect() {
    printf '%s\n' '// Step 1.1: the mirror direction. Contract: lib/steps/1_diffuse_photon_map.h' '#include "photonlab.h"' '' \
        'Vec3 reflect(Vec3 direction, Vec3 normal)' '{' "$@" '}' >"$code/1_diffuse_photon_map/1.1_reflect.c"
}
depth='    float depth = vec3_dot(direction, normal);'
case $1 in
    first | rendered) reflect "$depth" '    return vec3_along(direction, normal, -depth);' ;;
    right | all | submit) reflect "$depth" '    return vec3_along(direction, normal, -2.0f * depth);' ;;
    broken) reflect "$depth" '    return vec3_along(direction, normal, -depth)' ;;
    crash) reflect '    const Vec3 *nowhere = NULL;' '    return vec3_along(*nowhere, normal, direction.x);' ;;
    endless) reflect '    while (vec3_dot(direction, normal) < 2.0f) direction = vec3_negate(direction);' '    return direction;' ;;
esac

make() {
    env -u MAKEFLAGS -u MAKELEVEL make --no-print-directory BUILD="$BUILD" CODE="$code" "$@" 2>&1 || true
}

# By a copy of its script, beside this code.
submit() {
    mkdir -p "$root/tests/class"
    cp tests/class/submit.sh "$root/tests/class/"
    ln -s "$PWD/lib" "$root/lib"
    PHOTONLAB_CC=${PHOTONLAB_CC:-cc} PHOTONLAB_FLAGS=${PHOTONLAB_FLAGS:--std=c99 -O2 -fPIC} PHOTONLAB_LINK=${PHOTONLAB_LINK:--shared} \
        PHOTONLAB_NAME=jane PHOTONLAB_BUILD=build bash "$root/tests/class/submit.sh" | head -2
}

case $1 in
    all) make test | tail -3 ;;
    rendered) make render SCENE=scenes/box_glass.yaml FLAGS="--size 256x256 --samples 4" | sed -n '/^your code/,/plays the rest/p; /paths ended/p' ;;
    submit) submit ;;
    *) make test STEP=1.1 | sed '1{/^$/d;}' ;;
esac | sed "s|$code|exercises|g; s/ *\$//" >"$2"
