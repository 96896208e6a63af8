#!/usr/bin/env bash
# Speed against what a user would otherwise take, side by side in one run, as ratios (above 1: ours is faster). Ours and what is compiled here
# get the same flags, -O3 -march=native; Embree and POV-Ray come as others built them.
# Usage: run.sh [gather|rays|pictures|photons …]   (all four)
set -u
cd "$(dirname "$0")/../.."
here=tests/bench
out=build/bench
mkdir -p "$out"
. tests/common.sh
parts="${*:-photons gather rays pictures}"

sh tests/setup.sh bench || exit 1
flags="-O3 -march=native -ffp-contract=off -fno-math-errno -D_DEFAULT_SOURCE -Ilib -fopenmp"
make --no-print-directory -s BUILD=build/native EXTRA=-march=native all build/native/bench_photons meshes || exit 1
native=build/native/photonlab
libs="-Lbuild/native -lphotonlab -Wl,-rpath,$PWD/build/native -lm"

value() { # FILE KEY: median over the lines that KEY has in FILE
    awk -v key="$2" '$1 == key { v[n++] = $2 } END { for (i = 1; i < n; i++) for (j = i; j > 0 && v[j-1] > v[j]; j--) { t = v[j]; v[j] = v[j-1]; v[j-1] = t } print v[int(n / 2)] }' "$1"
}

# row LABEL KEY OURS PEER WANTED [inverse]: a ratio of two files' values, above 1 when ours is better
row() {
    local a b
    a=$(value "$3" "$2")
    b=$(value "$4" "$2")
    awk -v l="$1" -v a="$a" -v b="$b" -v w="$5" -v inverse="${6:-}" \
        'BEGIN { r = inverse ? b / a : a / b; printf "  %-46s %10.4g %10.4g   ratio %5.2f   wanted %s  %s\n", l, a, b, r, w, (r >= w ? "✓" : "✗") }'
}

photons() {
    echo "Photon pass, box_glass, every bounce (wanted: 1.3 M paths a second on a thread, 1.9 times that on two)"
    build/native/bench_photons --most 10000000
    echo
}

gather() {
    gcc -std=c99 $flags $here/gather.c -o $out/gather $libs
    g++ -std=c++17 $flags $here/gather_nanoflann.cpp -o $out/gather_nanoflann -lpthread
    local threads i
    for threads in 1 2; do
        rm -f $out/gather.txt $out/nanoflann.txt
        for i in 1 2 3; do
            $out/gather 1000000 $threads 50000 3 >>$out/gather.txt
            $out/gather_nanoflann 1000000 $threads 50000 3 >>$out/nanoflann.txt
        done
        echo "Gather, 1 M photons, $threads thread(s): photonlab, nanoflann"
        row "build, M photons/s" build_mpoints_s $out/gather.txt $out/nanoflann.txt 1
        row "50 nearest, k look-ups/s" knn50_kq_s $out/gather.txt $out/nanoflann.txt 1.5
        row "100 nearest, k look-ups/s" knn100_kq_s $out/gather.txt $out/nanoflann.txt 1.5
        row "fixed radius, ~50 found, k look-ups/s" radius_kq_s $out/gather.txt $out/nanoflann.txt 2
    done
    echo
}

# Embree comes from PyPI as a library in a wheel.
embreex=4.4.0.post1
rays() {
    [ -d $out/embreex.libs ] || { pip3 -q download --no-deps -d $out embreex==$embreex && unzip -qo $out/embreex-$embreex-*.whl -d $out; } || return
    gcc -std=c99 $flags $here/rays.c -o $out/rays $libs $out/embreex.libs/libembree4*.so* -Wl,--allow-shlib-undefined -Wl,-rpath,$PWD/$out/embreex.libs
    local scene threads
    for scene in box mesh; do
        for threads in 1 2; do
            echo "Rays, $scene, $threads thread(s): photonlab, Embree $embreex (rays in M/s, build in s; hits of both)"
            $out/rays $scene $threads | awk '{ wanted = $1 == "build" ? 0.25 : 1; printf "  %-46s %10.4g %10.4g   ratio %5.2f   wanted %s  %s  %s %s\n", $1, $2, $3, $4, wanted, ($4 >= wanted ? "✓" : "✗"), $5, $6 }'
        done
    done
    echo
}

seconds() { # COMMAND…: wall clock
    local start
    start=$(date +%s.%N)
    "$@" >/dev/null 2>&1
    echo "$(date +%s.%N) $start" | awk '{ printf "%.3f", $1 - $2 }'
}

# picture SCENE LABEL WANTED_ERROR WANTED_SHARE FLAGS…: ours and POV-Ray in turn, three times
picture() {
    local scene=$1 label=$2 error=$3 share=$4
    shift 4
    rm -f $out/ours.txt $out/povray.txt
    local i
    for i in 1 2 3; do
        echo "s $(seconds $native render scenes/$scene.yaml --size 512x512 --threads 2 --quiet -o $out/$scene.pfm "$@")" >>$out/ours.txt
        echo "s $(cd $here && seconds povray +I$scene.pov "+O../../$out/$scene-povray.png" +FN16 File_Gamma=srgb +W512 +H512 +A0.1 +AM1 +R2 -D +WT2)" >>$out/povray.txt
    done
    xz -dc tests/reference/${scene}_512.pfm.xz >$out/$scene-reference.pfm
    local json
    json=$($native diff $out/$scene.pfm $out/$scene-reference.pfm --mask 204,56,308,90 --json)
    awk -v s="$scene" -v l="$label" -v a="$(value $out/ours.txt s)" -v b="$(value $out/povray.txt s)" -v e="$(number "$json" relmse_trimmed)" -v we="$error" -v ws="$share" \
        'BEGIN { printf "  %-12s %-34s %6.2f s  POV-Ray %6.2f s  share %.2f (wanted %s)  relMSE %.2e (wanted %s)  %s\n", s, l, a, b, a / b, ws, e, we, (a / b <= ws && e <= we) ? "✓" : "✗" }'
}

# blotches SCENE FLAGS…: squared error of means over 16×16 pixels, and processor time
blotches() {
    local scene=$1 spent
    shift
    spent=$(TIMEFORMAT=%U; { time $native render scenes/$scene.yaml --size 512x512 --threads 1 --quiet -o $out/$scene.pfm "$@" >/dev/null 2>&1; } 2>&1)
    xz -dc tests/reference/${scene}_512.pfm.xz >$out/$scene-reference.pfm
    echo "$(number "$($native diff $out/$scene.pfm $out/$scene-reference.pfm --mask 204,56,308,90 --blocks 16 --json)" relmse_trimmed) $spent"
}

# low_frequency SCENE GATHER_PHOTONS PLAIN_PHOTONS PLAIN_K: the plain map has at least as much processor time
low_frequency() {
    echo "$1 $(blotches $1 --integrator gather --photons $2 --k 60 --samples 8) $(blotches $1 --photons $3 --k $4 --samples 8)" |
        awk '{ printf "  %-12s gathered %.2e in %.1f s, map %.2e in %.1f s of processor time: 1/%.1f (wanted 1/5)  %s\n", $1, $2, $3, $4, $5, $4 / $2, (($4 >= 5 * $2 && $5 >= 0.95 * $3) ? "✓" : "✗") }'
}

pictures() {
    echo "Pictures, 512×512, two threads, whole process: to pbrt-v3 SPPM's error in a third of its time, which is this share of POV-Ray's;"
    echo "then to POV-Ray's own error in its own time"
    picture box_diffuse "to 2.4e-3" 2.4e-3 0.68 --photons 500000 --k 120 --samples 4
    picture box_glass "to 3.4e-3" 3.4e-3 0.23 --photons 400000 --k 100 --samples 4
    picture box_diffuse "to POV-Ray's error (aim)" 2.6e-4 1 --photons 8000000 --k 2500 --samples 32
    picture box_glass "to POV-Ray's error (aim)" 4.2e-4 1 --photons 6000000 --k 1000 --samples 32
    echo "The same, gathered: in 0.4 of its time"
    picture box_diffuse "gathered, to POV-Ray's error" 2.6e-4 0.4 --integrator gather --photons 300000 --k 60 --samples 8
    picture box_glass "gathered, to POV-Ray's error" 4.2e-4 0.4 --integrator gather --photons 400000 --k 60 --samples 8
    echo "Blotches, gathered and straight from the map, in equal time"
    low_frequency box_diffuse 300000 2000000 400
    low_frequency box_glass 400000 1600000 320
    echo "By passes, whose radii shrink: to an eighth of the time that pbrt-v3's SPPM took to this error"
    picture box_glass "by 8 passes, to 8.6e-4" 8.6e-4 0.4 --passes 8 --photons 200000 --k 100
    echo
}

for part in $parts; do $part; done
