# scenes/ring.yaml from near by: 5_ring.sh cusp|edge OUT.yaml
# cusp: 35 mm around the point of the curve. edge: a strip of 20 mm across the curve, where the light that makes it has met the
# mirror 30° from the beam's direction; left is the lit side. Less power, so that the curve is not burnt out.
set -e
case $1 in
    cusp) at="-0.053 0" up="0, 0, -1" view=5 ;;
    edge) at="-0.06495 0.0125" up="-0.375, 0, 0.6495" view=0.18 ;;
esac
set -- "$2" $at
sed -e "s/position: \[0.0, 0.40, 0.001\]/position: [$2, 0.40, $3]/" -e "s/target: \[0, 0, 0\]\$/target: [$2, 0, $3]/" \
    -e "s/up: .*/up: [$up]/" -e "s/vertical_fov: .*/vertical_fov: $view/" -e "s/power: \[0.04, 0.04, 0.04\]/power: [0.01, 0.01, 0.01]/" \
    -e "s|meshes/|$PWD/scenes/meshes/|" scenes/ring.yaml >"$1"
