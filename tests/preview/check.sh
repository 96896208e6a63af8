#!/usr/bin/env bash
# The preview's window under Xvfb, and its pictures without a display. Usage: check.sh PROGRAM BUILD COMMAND [few], where
# COMMAND builds a step: sh -c COMMAND sh SOURCE.c OBJECT.so; few: one drill of each sort.
set -u
program=$1
preview_build=$3
few=${4:-}
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
. "$here/common.sh"
. "$here/pictures.sh"
. "$here/drills.sh"
. "$here/keys.sh"
. "$here/verdicts.sh"

trap 'window_end; rm -rf "$work"' EXIT
for tool in Xvfb xdotool; do
    command -v $tool >/dev/null || bad "$tool is missing: make setup"
done
student_start || bad "the reference does not build as a student's code"
check_pictures
cp scenes/box_diffuse.yaml "$work/"
display_start && window_start "$work/box_diffuse.yaml" --photons 20000 --size 640x480 || bad "the window does not open: $(cat "$log")"
check_drills
check_keys
check_close
check_verdicts "$2"
finish
