# Passes that shrink, after 1, 8, 64 and 512 of them, and 512 that do not: 5_series.sh cusp|edge SIZE OUT, of scenes/ring.yaml
# from near by (5_ring.sh). Writes OUT_1.pfm … OUT_512.pfm, OUT_fixed.pfm. Each goes on from the one before.
set -e
: "${BUILD:=build}"
out=$3
sh course_notes/figures/src/5_ring.sh "$1" "$out.yaml"
size=$2
reuse=0.35
[ "$1" = cusp ] || reuse=0 # a curve would show where estimates are shared
passes() { "$BUILD/photonlab" render "$out.yaml" --size "$size" --radius 0.005 --photons 20000 --reuse $reuse --quiet "$@"; }
before=
for count in 1 8 64 512; do
    passes --passes $count $before -o "${out}_$count.part"
    "$BUILD/photonlab" merge "${out}_$count.part" -o "${out}_$count.pfm"
    before="--resume ${out}_$count.part"
done
passes --passes 512 --alpha 1 -o "${out}_fixed.pfm"
