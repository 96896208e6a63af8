#!/usr/bin/env bash
# Photons of single wavelengths against a spectral sum, that is the sum over 31 lamps of one line each, which photons of our own
# carry; beside them red, green and blue alone, and bands as that sum has them, but fewer. Then what hero wavelengths gain, and
# whether the walls' reflectances are those that their command computes.
# Usage: spectra.sh PROGRAM REFLECTANCES
set -u
here=$(dirname "$0")
. "$here/common.sh"
program=$1
reflectances=$2

# lines SCENE N: the scene with N lamps in place of its beam, each of a single line
lines() {
    awk -v n="$2" '/type: beam/ {
        match($0, /power: \[[0-9.]*/)
        power = substr($0, RSTART + 8, RLENGTH - 8) / n
        for (i = 0; i < n; i++) {
            row = $0
            sub(/type: beam/, sprintf("type: beam, spectrum: \"%.3f\"", 380 + 350 * (i + 0.5) / n), row)
            sub(/power: [^}]*/, "power: [" power ", " power ", " power "]", row)
            print row
        }
        next
    } { print }' "$1"
}

# picture NAME SCENE PHOTONS FLAGS…
picture() {
    local name=$1 scene=$2 photons=$3
    shift 3
    "$program" render "$scene" --photons "$photons" --quiet "$@" -o "$work/$name.pfm" || bad "$scene $*: does not run"
}

# error NAME REFERENCE: relMSE over all channels
error() {
    number "$("$program" diff "$work/$1.pfm" "$work/$2.pfm" --json)" relmse_all
}

# hue SCENE LIMIT MILLIONS BANDS…: so many millions of photons
hue() {
    local scene=$here/spectra/$1.yaml limit=$2 photons=${3}000000 name=$1 bands
    shift 3
    lines "$scene" 31 >"$work/31.yaml"
    picture sum "$work/31.yaml" "$photons" --spectral
    picture spectral "$scene" "$photons" --spectral
    picture rgb "$scene" "$photons"
    found=$(error spectral sum)
    rgb=$(error rgb sum)
    check "$found < $limit" "$name: single wavelengths have relMSE $found against a sum over 31 (at most $limit)"
    echo "  $name: red, green and blue alone have $rgb"
    for bands in "$@"; do
        lines "$scene" "$bands" >"$work/bands.yaml"
        picture bands "$work/bands.yaml" "$photons" --spectral
        echo "  $name: $bands lines have $(error bands sum)"
    done
}

# The gain of three wavelengths a photon where nothing disperses: errors of equally many photons.
hero() {
    local scene=scenes/box_glossy.yaml size="--spectral --size 64x64 --samples 16 --reuse 0 --k 100"
    # shellcheck disable=SC2086
    {
        picture many $scene 6400000 $size --k 400
        picture one $scene 200000 $size --wavelengths 1
        picture three $scene 200000 $size --wavelengths 3
    }
    local one three
    one=$(error one many)
    three=$(error three many)
    check "$three < 0.5 * $one" "hero wavelengths: relMSE falls from $one to $three with as many photons"
}

hue ball 5e-4 16 4 8
hue fan 2e-2 4 3 4 8 16
check "$rgb > 1e-2 && $rgb > 10 * $found" "fan: red, green and blue alone have more, as three spots are no fan"
hero
[ -z "$reflectances" ] || ok "walls' reflectances are what their command computes" "$reflectances" --check
finish
