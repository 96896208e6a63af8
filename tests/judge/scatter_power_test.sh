#!/usr/bin/env bash
# Which known mistakes the scatter of their stage shows: each mistake alone in a step, the reference's elsewhere.
#   scatter_power_test.sh [NAME…]     run from the checkout; NAME: of a folder of tests/mistakes; all by default
# Prints "a/NAME STATUS MESSAGE" each and, at the end, how many fail or do not get through, of how many.
set -u
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export work

one() {
    local patch=$1 name step stage solution place said
    name=${patch#tests/mistakes/}
    step=${name%%_*}
    stage=${step%%.*}
    solution=$(echo solutions/*/"$step"_*.c)
    place=$work/${name//\//__}
    mkdir -p "$place/code/$(basename "$(dirname "$solution")")" "$place/work"
    cp "$solution" "$place/code/${solution#solutions/}"
    patch -s -d "$place/code" -p2 <"$patch" >/dev/null || { echo "$name patch-does-not-apply"; return; }
    said=$("$PHOTONLAB_BUILD/judge" --build "$PHOTONLAB_BUILD" --work "$place/work" --code "$place/code" --jobs 1 --stage "$stage" --scatters 1 2>/dev/null | cut -d ' ' -f 2,5-)
    echo "$(basename "$name" .patch)/${name%/*} ${said:-not-played}"
    rm -rf "$place"
}
export -f one

if [ $# = 0 ]; then
    printf '%s\n' tests/mistakes/[0-9]*/[ab].patch
else
    for name in "$@"; do echo "tests/mistakes/$name/a.patch"; done
fi | nice xargs -P "${JOBS:-$(nproc)}" -I{} bash -c 'one "$1"' one {} | sort >"$work/found"
cat "$work/found"
awk '{ all++; seen += $2 == "fail" || $2 == "error" } END { printf "%d of %d are seen\n", seen, all }' "$work/found"
