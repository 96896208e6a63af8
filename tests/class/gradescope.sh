#!/usr/bin/env bash
# The autograder for Gradescope: autograder.zip with setup.sh, run_autograder and the framework. `make gradescope` runs
# it.
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/files.sh"
cd "$here/../.." || exit 2
command -v zip >/dev/null || { echo "gradescope: zip is missing (on Debian: apt-get install zip)" >&2; exit 2; }
mkdir -p "$PHOTONLAB_OUT" || exit 2
work=$(mktemp -d "$PHOTONLAB_OUT/.making.XXXXXX") || exit 2
trap 'rm -rf "$work"' EXIT
unused='^tests/(alternatives|attacks|unit|bench|fuzz|malformed|agreement)/|^tests/mistakes/.*/|^exercises/[^.]|\.png$|\.pfm\.xz$'
framework_files | grep -vE "$unused" | copy_files "$work/photonlab" || exit 1
cp "$here/gradescope/setup.sh" "$here/gradescope/run_autograder" "$work/" || exit 1
chmod 755 "$work/setup.sh" "$work/run_autograder"
archive=$PHOTONLAB_OUT/autograder.zip
(cd "$work" && zip -q -X -r archive.zip setup.sh run_autograder photonlab) && mv "$work/archive.zip" "$archive" ||
    exit 1
echo "$archive: $(du -k "$archive" | cut -f1) kB. Upload it in Gradescope under Configure Autograder, as a zip file."
