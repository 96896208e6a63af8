#!/usr/bin/env bash
# The autograder for Gradescope: autograder.zip with setup.sh, run_autograder and the framework. `make gradescope` runs
# it.
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/files.sh"
cd "$here/../.." || exit 2
command -v zip >/dev/null || { echo "gradescope: zip is missing (on Debian: apt-get install zip)" >&2; exit 2; }
"$PHOTONLAB_BUILD/class_table" --points "${PHOTONLAB_POINTS:-tests/judge/points.txt}" >/dev/null || exit 2
mkdir -p "$PHOTONLAB_OUT" || exit 2
work=$(mktemp -d "$PHOTONLAB_OUT/.making.XXXXXX") || exit 2
trap 'rm -rf "$work"' EXIT
unused='^tests/(alternatives|attacks|unit|bench|fuzz|shortage|malformed|extend|scene_page|agreement)/|^tests/mistakes/.*/|^exercises/[^.]|\.png$|\.pfm\.xz$'
framework_files | grep -vE "$unused" | copy_files "$work/photonlab" || exit 1
[ -z "${PHOTONLAB_POINTS:-}" ] || cp "$PHOTONLAB_POINTS" "$work/photonlab/tests/judge/points.txt" || exit 1
cp "$here/gradescope/setup.sh" "$here/gradescope/run_autograder" "$work/" || exit 1
# Cases that students have not seen at home, the same for all: made once, and kept when the zip is made again.
archive=$PHOTONLAB_OUT/autograder.zip
salt=${PHOTONLAB_SALT:-$(unzip -p "$archive" salt 2>/dev/null)}
[ -n "$salt" ] || salt=$(head -c 18 /dev/urandom | od -An -tx1 | tr -d ' \n')
[ -n "$salt" ] || exit 1
printf '%s\n' "$salt" >"$work/salt"
chmod 755 "$work/setup.sh" "$work/run_autograder"
(cd "$work" && zip -q -X -r archive.zip setup.sh run_autograder salt photonlab) && mv "$work/archive.zip" "$archive" ||
    exit 1
echo "$archive: $(du -k "$archive" | cut -f1) kB. Upload it in Gradescope under Configure Autograder, as a zip file."
