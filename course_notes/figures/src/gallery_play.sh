#!/bin/sh
# The gallery of wrong pictures: plays every known mistake of tests/mistakes/ and measures whether a picture shows it.
#
# Usage: [BUILD=build] [FIGURES=course_notes/figures] sh course_notes/figures/src/gallery_play.sh [STEP …]
#
# Run from the checkout's root, after `make all meshes`. Without a STEP: all. Writes to FIGURES:
#   gallery_MISTAKE.png         the picture with this mistake (mistakes whose pictures cannot be told apart share one)
#   gallery_right_SCENE.png     the same without a mistake
#   gallery_seen.txt            all steps only: `MISTAKE SCENE EVERYWHERE SOMEWHERE LEVEL SEEN PICTURE` for each mistake, then sums
# EVERYWHERE and SOMEWHERE tell how far the picture is from the right one, in units of noise (gallery_patches.awk); they are measured
# on pictures of few pixels and many samples, as an eye does that looks from afar. 1 is noise; from SEEN_FROM on it is seen.
set -u
LC_ALL=C
export LC_ALL BUILD="${BUILD:-build}" FIGURES="${FIGURES:-course_notes/figures}"
work=$BUILD/gallery
self=course_notes/figures/src/gallery_play.sh
SEEN_FROM=2 # times the noise
PLAIN_FROM=5
SEEDS="11 12 13 14 15 16" # of the right pictures that tell the noise

# The scenes that a step may show in, the most telling first; a mistake takes the first that shows it plainly, or else the best.
scenes_of() {
    case $1 in
    1.1) echo box_glass picture_1 ;;
    1.[2346]) echo box_diffuse box_glossy picture_1 ;;
    1.5) echo box_glass box_glossy box_diffuse picture_1 ;;
    2.*) echo picture_2 box_glossy ;;
    3.1 | 3.2) echo box_glass picture_3 prism ;;
    3.3) echo picture_3 prism box_glass ;;
    3.5) echo picture_3 prism box_glass ;;
    3.4) echo picture_3 prism box_glass picture_1 ;;
    4.2) echo picture_4 box_glass box_diffuse ;;
    4.[13]) echo picture_4 box_diffuse ;;
    4.*) echo picture_4 box_glossy ;;
    5.*) echo picture_5 ;;
    6.*) echo picture_3 prism ;;
    *) echo box_glass box_dispersion ;;
    esac
}

# Where two steps do the same work, the mistaken one must play.
steps_of() {
    case $1 in
    1.5) echo 2.4,1.5 ;;
    2.3) echo 2.3,3.4 ;;
    6.*) echo 2.4,6.4 ;;
    *) echo 2.4,3.4 ;;
    esac
}

# What a right picture is called: that of 2.3 is another than that of 2.4, stage 4 gathers, stage 5 has passes, stage 6 wavelengths;
# all else gives the same.
right_of() {
    case $1 in 2.3) echo "$2_2.3" ;; 4.*) echo "$2_gathered" ;; 5.[12]) echo "$2_by_pass" ;; 5.*) echo "$2_by_pixel" ;; 6.*) echo "$2_spectral" ;; *) echo "$2" ;; esac
}

# render SCENE STEP fine|coarse SEED OUT [CODE]
render() {
    case $1 in picture_*) file=tests/steps/scenes/$1.yaml ;; *) file=scenes/$1.yaml ;; esac
    case $1:$3 in
    prism:fine) size=160x90 samples=4 ;;
    prism:coarse) size=80x45 samples=9 ;;
    *:fine) size=128x128 samples=4 ;;
    *:coarse) size=16x16 samples=64 ;;
    esac
    # Beams that draw thin lines need photons more than a lamp in a box does.
    case $1 in
    prism) light="--photons 300000 --k 60" ;;
    picture_3) light="--photons 200000 --k 70" ;;
    *) light="--photons 150000 --k 100" ;;
    esac
    integrator=photons-only
    # How far an estimate reaches hangs on the size of a pixel: not too coarse.
    case $2:$3 in
    4.*:coarse) integrator=gather size=32x32 samples=16 light="--photons 60000 --k 60" ;;
    4.*) integrator=gather light="--photons 60000 --k 60" ;;
    5.[12]:*) samples=2 light="--photons 10000 --passes 11 --radii pass" ;;
    5.*) integrator=photons samples=2 light="--photons 10000 --passes 11 --radii pixel" ;;
    esac
    # shellcheck disable=SC2086 # flags are words
    "$BUILD/photonlab" render "$file" --integrator $integrator --steps "$(steps_of "$2")" --size $size --samples $samples \
        $light --depth 12 --seed "$4" --threads 1 --quiet -o "$5" ${6:+--code "$6"}
}

# The linear values of a coarse picture on one line; three header lines go before them.
values() {
    tail -n +4 "$1" | od -A n -v -t f4 | tr '\n' ' '
    echo
}

# distance PICTURE RIGHT [OTHER]: EVERYWHERE SOMEWHERE LEVEL, from the right picture or, with its noise, from the other
distance() {
    { cat "$2" ${3:+"$3"}; values "$1"; } | awk -v rights="$(wc -l <"$2")" -v other="${3:+1}" -f course_notes/figures/src/gallery_patches.awk
}

# The right pictures of one scene: RIGHT.png to look at, RIGHT.values to measure with.
play_right() {
    step=${1%%:*} scene=${1#*:}
    right=$work/right_$(right_of "$step" "$scene")
    render "$scene" "$step" fine 1 "$right.png"
    # Gathered at few pixels, some seeds have a bright speck. Where that of the mistakes has one, each of them has it.
    case $step in 4.*) SEEDS="1 $SEEDS" ;; esac
    for seed in $SEEDS; do
        render "$scene" "$step" coarse "$seed" "$right.pfm"
        values "$right.pfm"
    done >"$right.values"
}

# The mistaken step alone, as a shared object laid out like the solutions; the reference plays all others.
build_mistake() {
    solution=$(echo solutions/*/"${1%%_*}"_*.c)
    place=${solution#solutions/}
    mkdir -p "$work/$1/${place%/*}" "$work/$1/code/${place%/*}"
    cp "$solution" "$work/$1/$place"
    patch -s -d "$work/$1" -p2 <"tests/mistakes/$1/a.patch" >"$work/$1/log" || return 1
    flags="-std=c99 -D_DEFAULT_SOURCE -D_XOPEN_SOURCE=700 -O2 -ffp-contract=off -fno-math-errno -fPIC"
    # shellcheck disable=SC2086 # flags are words
    ${PHOTONLAB_CC:-cc} ${PHOTONLAB_FLAGS:-$flags} -w -Ilib ${PHOTONLAB_LINK:--shared} \
        "$work/$1/$place" -o "$work/$1/code/${place%.c}.so" 2>>"$work/$1/log"
}

# Writes $work/MISTAKE/result: "SCENE EVERYWHERE SOMEWHERE LEVEL".
play_mistake() {
    rm -rf "${work:?}/$1"
    mkdir -p "$work/$1"
    if ! build_mistake "$1"; then
        echo "$1: does not build" >&2
        return 1
    fi
    step=${1%%_*} code=$work/$1/code
    ulimit -t 60 # seconds; an endless loop is no picture
    for scene in $(scenes_of "$step"); do
        render "$scene" "$step" coarse 1 "$work/$1/$scene.pfm" "$code" 2>>"$work/$1/log" || continue
        found=$(distance "$work/$1/$scene.pfm" "$work/right_$(right_of "$step" "$scene").values")
        echo "$scene $found"
        ! is_from $PLAIN_FROM "$found" || break
    done >"$work/$1/tried"
    awk '
        { most = $2 > $3 ? $2 : $3 }
        !best || most > highest { highest = most; best = $0 }
        END { print best ? best : "none 0 0 0" }' "$work/$1/tried" >"$work/$1/result"
    read -r scene found <"$work/$1/result"
    ! is_from $SEEN_FROM "$found" || render "$scene" "$step" fine 1 "$work/$1/fine.png" "$code"
}

# is_from LIMIT "EVERYWHERE SOMEWHERE …"
is_from() {
    echo "$2" | awk -v limit="$1" '{ exit !($1 >= limit || $2 >= limit) }'
}

# Is there a picture of this step and scene already that cannot be told from this one? Prints its mistake. The noise is that
# of the right picture, moved to where the other is.
twin_of() {
    right=$work/right_$(right_of "${1%%_*}" "$2").values
    while read -r other scene; do
        [ "$scene" = "$2" ] && [ "${other%%_*}" = "${1%%_*}" ] || continue
        values "$work/$other/$scene.pfm" >"$work/other"
        found=$(distance "$work/$1/$scene.pfm" "$right" "$work/other")
        ! is_from 1.4 "$found" && echo "$other" && return
    done <"$work/shown"
}

# figure_of NAME: its file; only letters, digits and underscores
figure_of() {
    echo "gallery_$(echo "$1" | tr . _).png"
}

# The table's line of a mistake; its picture to FIGURES when it is the first of its kind.
show_mistake() {
    read -r scene found <"$work/$1/result"
    seen=no picture=-
    if [ "$scene" = none ]; then
        seen=no-picture
    elif is_from $SEEN_FROM "$found"; then
        seen=yes
        picture=$(twin_of "$1" "$scene")
        if [ -z "$picture" ]; then
            picture=$1
            echo "$1 $scene" >>"$work/shown"
            cp "$work/$1/fine.png" "$FIGURES/$(figure_of "$1")"
            right=right_$(right_of "${1%%_*}" "$scene")
            cp "$work/$right.png" "$FIGURES/$(figure_of "$right")"
        fi
    fi
    echo "$1 $scene $found $seen $picture"
}

# mistakes_of STEP…: a name a line
mistakes_of() {
    for step in "$@"; do
        for mistake in tests/mistakes/"$step"_*/; do
            [ ! -d "$mistake" ] || basename "$mistake"
        done
    done
}

gallery() {
    rm -rf "$work"
    mkdir -p "$work" "$FIGURES"
    : >"$work/shown"
    for step in "$@"; do
        rm -f "$FIGURES/gallery_${step%.*}_${step#*.}_"*.png
        for scene in $(scenes_of "$step"); do echo "right $(right_of "$step" "$scene") $step:$scene"; done
    done | sort -u -k 2,2 | xargs -P "$jobs" -L 1 sh $self --play
    mistakes_of "$@" | sed 's/^/mistake - /' | xargs -P "$jobs" -L 1 sh $self --play
    for mistake in $(mistakes_of "$@"); do show_mistake "$mistake"; done >"$work/table"
    awk '{ print; count[$6]++ } $1 == $7 { pictures++ }
         END { print "known", NR; print "seen", count["yes"] + 0; print "not_seen", NR - count["yes"]; print "pictures", pictures + 0 }' \
        "$work/table" >"$work/seen.txt"
}

jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
case ${1:-} in
--play)
    "play_$2" "$4"
    ;;
'')
    # shellcheck disable=SC2046 # ids are words
    gallery $(ls solutions/*/ | sed -n 's/^\([0-9]*\.[0-9]*\)_.*\.c$/\1/p' | sort) && cp "$work/seen.txt" "$FIGURES/gallery_seen.txt"
    ;;
*)
    gallery "$@" && cat "$work/seen.txt"
    ;;
esac
