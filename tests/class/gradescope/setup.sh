#!/usr/bin/env bash
# Gradescope runs this once, as root, when the autograder's image is built; the zip lies unpacked in /autograder/source.
# AUTOGRADER_ROOT: another directory than /autograder, to try it. NO_PACKAGES=1: they are there.
set -eu
source=${AUTOGRADER_ROOT:-/autograder}/source
cd "$source/photonlab"
[ "${NO_PACKAGES:-}" = 1 ] || { apt-get update -qq && apt-get install -y -qq make && sh tests/setup.sh; }
make -j"$(getconf _NPROCESSORS_ONLN)" class-tools meshes
# What shows solutions, or how they are judged, is for root alone; students' code runs as somebody else.
# Scenes are all of tests/ that it may read.
chmod -R go-rwx solutions build/solutions build/obj
find tests -mindepth 1 \( -path tests/steps -o -path 'tests/steps/scenes*' \) -prune -o -exec chmod go-rwx {} +
find tests/steps -mindepth 1 -path tests/steps/scenes -prune -o -exec chmod go-rwx {} +
chmod go-rwx "$source/run_autograder" "$source/setup.sh" "$source/salt"
