#!/usr/bin/env bash
# Memory that is not there, at each place in turn: a message and code 1, nothing worse, and nothing half-written. Usage:
# run.sh PROGRAM [COMMAND…], of those below. EVERY=7: every seventh place.
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
program=$1
shift
asked=${*:-diff photons photons-csv render path gather passes pixels spectral mesh merge snapshot}
every=${EVERY:-1}
export GALLIUM_DRIVER=softpipe # the one that compiles nothing

if nm -D "$program" | grep -q __asan || ! ${CC:-cc} -shared -fPIC "$here/shortage.c" -o "$work/short.so" -ldl 2>"$work/why"; then
    echo "○ memory cannot be made short here"
    exit 0
fi
box=scenes/box_glass.yaml
tiny="--size 7x5 --photons 900 --samples 1 --quiet --threads 2"
"$program" render $box $tiny -o "$work/a.png" && "$program" render $box $tiny --seed 2 -o "$work/b.png" &&
    "$program" render $box $tiny --passes 4 --part 1/2 -o "$work/1.part" && "$program" render $box $tiny --passes 4 --part 2/2 -o "$work/2.part"

# arguments NAME OUT: the command line that writes OUT.
arguments() {
    case $1 in
    diff) echo "diff $work/a.png $work/b.png -o $2.png" ;;
    photons) echo "photons $box --photons 300 --threads 2 --quiet -o $2.ply" ;;
    photons-csv) echo "photons $box --photons 300 --threads 2 --quiet -o $2.csv" ;;
    render) echo "render $box $tiny -o $2.png" ;;
    path) echo "render $box $tiny --integrator path -o $2.pfm" ;;
    gather) echo "render $box $tiny --integrator gather -o $2.png" ;;
    passes) echo "render $box $tiny --passes 5 -o $2.png" ;;
    pixels) echo "render $box $tiny --passes 3 --radii pixel -o $2.png" ;;
    spectral) echo "render scenes/box_dispersion.yaml $tiny --spectral -o $2.png" ;;
    mesh) echo "render scenes/ring.yaml $tiny -o $2.png" ;;
    merge) echo "merge $work/1.part $work/2.part -o $2.png" ;;
    snapshot) echo "preview $box --photons 300 --size 96x64 --snapshot $2.png" ;;
    esac
}

# starve NAME: with each of its allocations failing.
starve() {
    local name=$1 all code i left told=0 wrong=""
    # shellcheck disable=SC2046  # the words are meant to fall apart
    COUNTED=$work/count LD_PRELOAD=$work/short.so "$program" $(arguments "$name" "$work/whole") >"$work/said" 2>&1 || wrong="does not run: $(tail -1 "$work/said"); "
    all=$(cat "$work/count")
    for ((i = 1; i <= all; i += every)); do
        rm -f "$work"/out.*
        FAILS=$i LD_PRELOAD=$work/short.so timeout 60 "$program" $(arguments "$name" "$work/out") >"$work/said" 2>&1
        code=$?
        [ $code -le 1 ] || wrong+="$i: exit code $code; "
        [ $code = 0 ] || [ -s "$work/said" ] || wrong+="$i: no word; "
        [ $code = 0 ] || told=$((told + 1))
        for left in "$work"/out.*; do # by passes, the picture of those before is there, and whole
            [ $code = 0 ] || [ ! -e "$left" ] || "$program" diff "$left" "$left" >/dev/null 2>&1 || wrong+="$i: left $left; "
        done
        if [ $code = 0 ] && ! ls "$work"/out.* >/dev/null 2>&1; then wrong+="$i: nothing written; "; fi
    done
    [ -z "$wrong" ] && good "$name: $all allocations, $(((all + every - 1) / every)) failed in turn, $told told, no harm otherwise" ||
        bad "$name: ${wrong:0:600}"
}

for name in $asked; do starve "$name"; done
finish
