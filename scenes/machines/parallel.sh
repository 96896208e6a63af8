#!/usr/bin/env bash
# One picture by several machines: GNU parallel shares out the parts of its passes, and the files come back and are merged.
# Usage: parallel.sh PROGRAM SCENE OUT PASSES PARTS HOSTS [FLAG…]
#
#   HOSTS   as `parallel --sshlogin` takes them: `anna,bert,:` are two machines and this one
#
# Each machine has photonlab, built, in a folder of the same name as this one, or sees this very folder. Parts that are there
# already, in OUT.parts/, are not made again: after a failure call it once more.
set -eu
program=$1 scene=$2 out=$3 passes=$4 parts=$5 hosts=$6
shift 6
command -v parallel >/dev/null || { echo "This needs GNU parallel; on Debian: sudo apt-get install parallel" >&2; exit 1; }
mkdir -p "$out.parts"
lost=$(for part in $(seq "$parts"); do [ -s "$out.parts/$part.part" ] || echo "$part"; done)

# One part at a time on a machine, as it uses all cores. A part that fails stops no other; merge says which are not there.
[ -z "$lost" ] || parallel --will-cite --sshlogin "$hosts" --workdir "$PWD" --jobs 1 --return "$out.parts/{}.part" \
    mkdir -p "$out.parts" '&&' "$program" render "$scene" -o "$out.parts/{}.part" --passes "$passes" --part "{}/$parts" --quiet "$@" \
    ::: $lost || echo "some parts have failed; the same command makes them again" >&2
"$program" merge "$out.parts"/*.part -o "$out"
echo "$out"
