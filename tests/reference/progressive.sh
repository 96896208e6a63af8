#!/usr/bin/env bash
# What more passes are worth. Usage: progressive.sh PROGRAM TABLE
#
# box_glass at 128×128, against the reference's means over 4×4 pixels: the squared error over three decades of passes, which theory
# has fall with N^(−2/3) at α = 2/3 (Knaus & Zwicker 2011), for both kinds of radii. Then the caustic of `ring`: with radii that stay
# as they are its error stays as well. The numbers go into TABLE: "passes KIND error", for a figure.
set -u
here=$(dirname "$0")
. "$here/../common.sh"
program=$1 table=$2
: >"$table"
xz -dc "$here/box_glass_512.pfm.xz" >"$work/box_glass.pfm"

# error IMAGE REFERENCE FLAGS…
error() {
    number "$("$program" diff "$@" --json)" relmse_trimmed
}

# passes KIND MOST REFERENCE "DIFF FLAGS" RENDER FLAGS…: after 1, FACTOR, FACTOR² … passes, each going on from those before.
passes() {
    local kind=$1 most=$2 reference=$3 flags=$4 n resume=""
    shift 4
    rm -f "$work/$kind.part"
    for ((n = 1; n <= most; n *= factor)); do
        # shellcheck disable=SC2086  # flags fall apart into words
        "$program" render "$@" --passes $n $resume --quiet -o "$work/$kind.part" &&
            "$program" merge "$work/$kind.part" -o "$work/$kind.pfm" || { bad "$kind: does not run"; return; }
        resume="--resume $work/$kind.part"
        # shellcheck disable=SC2086
        echo "$n $kind $(error "$work/$kind.pfm" "$reference" $flags)" >>"$table"
        tail -1 "$table"
    done
}

# slope KIND: of log error over log passes, by least squares
slope() {
    awk -v kind="$1" '$2 == kind { x = log($1); y = log($3); n++; sx += x; sy += y; sxx += x * x; sxy += x * y }
                      END { printf "%.4f\n", (n * sxy - sx * sy) / (n * sxx - sx * sx) }' "$table"
}

# gain KIND: what share of its error after 16 passes is left after 64
gain() {
    awk -v kind="$1" '$2 == kind { error[$1] = $3 } END { printf "%.3f\n", error[64] / error[16] }' "$table"
}

factor=2
for radii in pass pixel; do
    passes $radii 1024 "$work/box_glass.pfm" "--blocks 4 --mask 204,56,308,92" scenes/box_glass.yaml --size 128x128 \
        --photons 20000 --k 3 --radii $radii
done
for radii in pass pixel; do
    check "$(slope $radii) <= -0.6667" "radii by $radii: the squared error falls with passes to the power of $(slope $radii)"
done

factor=4
ring="scenes/ring.yaml --size 256x256 --photons 100000"
"$program" render $ring --passes 400 --radius 0.00125 --seed 9 --quiet -o "$work/ring.pfm"
passes fixed 64 "$work/ring.pfm" "" $ring --alpha 1
passes shrinking 64 "$work/ring.pfm" "" $ring
# With α = 2/3 four times the passes make radii, and so the width of blurred edges, 4^(−1/6) = 0.79 times as large.
check "$(gain fixed) > 0.9" "caustic of ring: a radius that stays keeps $(gain fixed) of its error from 16 to 64 passes"
check "$(gain shrinking) < 0.79" "caustic of ring: radii that shrink keep $(gain shrinking) of it"
finish
