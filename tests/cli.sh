#!/usr/bin/env bash
# The command line: exit codes, messages, and that nothing is half-written. Usage: cli.sh PROGRAM BUILD
set -u
here=$(dirname "$0")
. "$here/common.sh"
program=$1
build=$2
scene=scenes/box_glass.yaml
quick="--size 16x16 --photons 2000 --samples 1"

# expect CODE TEXT COMMAND…: the exit code, and the text somewhere in what is said (error messages go to standard error).
expect() {
    local code=$1 text=$2
    shift 2
    "$@" >"$work/out" 2>"$work/err"
    local got=$?
    if [ $got != "$code" ]; then
        bad "$* — exit code $got, expected $code: $(head -1 "$work/err")"
    elif [ -n "$text" ] && ! cat "$work/out" "$work/err" | grep -qF -- "$text"; then
        bad "$* — says '$(head -1 "$work/err")', expected '$text'"
    else
        local line="$(basename "$1") ${*:2}"
        good "${line//$work\//}"
    fi
}

expect 2 "usage" "$program"
expect 0 "usage" "$program" --help
expect 2 "no command \`paint\`" "$program" paint
for command in render photons diff bench; do
    expect 0 "usage: photonlab $command" "$program" $command --help
    expect 2 "--help lists the flags" "$program" $command --no-such-flag
done

# Wrong usage: 2.
expect 2 "expected one scene file" "$program" render -o "$work/a.png"
expect 2 "say where to write" "$program" render $scene
expect 2 "expected .png (to look at) or .pfm (to measure)" "$program" render $scene -o "$work/a.jpg"
expect 2 "--photons 0: expected a whole number" "$program" render $scene -o "$work/a.png" --photons 0
expect 2 "--photons 1e6: expected a whole number" "$program" render $scene -o "$work/a.png" --photons 1e6
expect 2 "--k -3" "$program" render $scene -o "$work/a.png" --k -3
expect 2 "--radius nan" "$program" render $scene -o "$work/a.png" --radius nan
expect 2 "--radius inf" "$program" render $scene -o "$work/a.png" --radius inf
expect 2 "--size 12: expected WIDTHxHEIGHT" "$program" render $scene -o "$work/a.png" --size 12
expect 2 "--size 0x5" "$program" render $scene -o "$work/a.png" --size 0x5
expect 2 "--seed -1" "$program" render $scene -o "$work/a.png" --seed -1
expect 2 "no choice \`4.2\`" "$program" render $scene -o "$work/a.png" --steps 4.2
expect 2 "--integrator magic: expected photons" "$program" render $scene -o "$work/a.png" --integrator magic
expect 2 "--glass-sides 3" "$program" render $scene -o "$work/a.png" --glass-sides 3
expect 2 "expected .ply or .csv" "$program" photons $scene -o "$work/a.txt"
expect 2 "expected two pictures" "$program" diff "$work/a.pfm"
expect 2 "--mask 1,2,3" "$program" diff a.pfm b.pfm --mask 1,2,3

# Wrong input or output: 1, and no file.
expect 1 "No such file" "$program" render "$work/none.yaml" -o "$work/a.png"
expect 1 "No such file" "$program" render $scene $quick -o "$work/no/such/place.png"
expect 1 "is a directory" "$program" render scenes -o "$work/a.png"
printf 'materials: [' >"$work/broken.yaml"
expect 1 "broken.yaml:2:1: this is not YAML" "$program" render "$work/broken.yaml" -o "$work/a.png"
expect 1 "No such file" "$program" diff "$work/none.pfm" "$work/none.pfm"
printf 'PF\n4 4\n-1.0\nshort' >"$work/short.pfm"
expect 1 "short.pfm" "$program" diff "$work/short.pfm" "$work/short.pfm"
if ls "$work"/a.* "$work"/*.tmp-* >/dev/null 2>&1; then bad "a failed run leaves a file behind"; else good "failed runs leave no file behind"; fi

# What works: 0.
expect 0 "" "$program" render $scene $quick -o "$work/a.png"
expect 0 "" "$program" render $scene $quick -o "$work/a16.png" --bits 16
expect 0 '"ledger":{"emitted":[' "$program" render $scene $quick -o "$work/a.pfm" --json
expect 0 "" "$program" render $scene $quick -o "$work/b.pfm" --quiet --k 5 --radius 0.3 --integrator photons-only
expect 0 "mean ratio" "$program" diff "$work/a.pfm" "$work/b.pfm" -o "$work/d.png"
expect 0 '"relmse_trimmed":0' "$program" diff "$work/a.pfm" "$work/a.pfm" --json
expect 0 "" "$program" photons $scene -o "$work/p.ply" --photons 500
expect 0 "" "$program" photons $scene -o "$work/p.csv" --photons 500
expect 0 "your code plays: nothing yet" "$program" render $scene $quick -o "$work/c.png" --code "$work/nowhere"

# Every photon is in both files.
stored=$(($(wc -l <"$work/p.csv") - 1))
if grep -aq "element vertex $stored" "$work/p.ply"; then good "PLY and CSV hold the same $stored photons"; else bad "PLY and CSV differ in count"; fi

# A student's step plays; the rest is the reference's. A stub counts as not started.
mkdir -p "$work/code/1_diffuse_photon_map"
cat >"$work/absorb.c" <<'C'
#include "photonlab.h"
bool russian_roulette(Colour *power, Colour reflectance, Rng *rng)
{
    (void)power, (void)reflectance, (void)rng;
    return false;
}
C
cat >"$work/stub.c" <<'C'
#include "photonlab.h"
Vec3 reflect(Vec3 direction, Vec3 normal)
{
    (void)normal;
    todo("1.1");
    return direction;
}
C
compile="${CC:-cc} -std=c99 -shared -fPIC -Ilib"
$compile "$work/absorb.c" -o "$work/code/1_diffuse_photon_map/1.4_russian_roulette.so"
$compile "$work/stub.c" -o "$work/code/1_diffuse_photon_map/1.1_reflect.so"
expect 0 "your code plays: 1.4;" "$program" render scenes/box_diffuse.yaml $quick -o "$work/c.png" --code "$work/code" --json
if grep -q '"photons_stored":0,' "$work/out"; then good "photons that all die leave no indirect light"; else bad "the student's step was not played"; fi
echo 'not an object' >"$work/code/1_diffuse_photon_map/1.4_russian_roulette.so"
expect 1 "step 1.4: cannot load" "$program" render $scene $quick -o "$work/c.png" --code "$work/code"
finish
