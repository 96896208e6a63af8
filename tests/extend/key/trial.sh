# A key of a rectangle, `lift`: how far it is raised.
most=2
place lib/scene/file/scene_shapes.c '{"edge_v", KEY_THREE' '    {"lift", KEY_NUMBER, "0", RANGE_METRES, "raises it"},' "lift"
place lib/scene/file/scene_shapes.c 'Flat flat = {.origin = scene_three(entry, "corner")' '    flat.origin.y += scene_number(entry, "lift");' "lift"
written scenes/README.md scene-page "scenes/README.md is not current"

# A box whose floor is raised by the key, and one where it stands higher.
try() {
    local floor='  - {type: rectangle, material: white, corner: \[-1, -1, -1\]'
    build all check-scene-page || return 1
    sed "s/^$floor/  - {type: rectangle, lift: 0.25, material: white, corner: [-1, -1, -1]/" "scenes/box_diffuse.yaml" >lifted.yaml
    sed "s/lift: 0.25, //; s/^$floor/  - {type: rectangle, material: white, corner: [-1, -0.75, -1]/" lifted.yaml >higher.yaml
    build/photonlab render lifted.yaml --size 16x16 --photons 2000 --quiet -o lifted.pfm 2>&1 &&
        build/photonlab render higher.yaml --size 16x16 --photons 2000 --quiet -o higher.pfm 2>&1 &&
        cmp lifted.pfm higher.pfm || return 1
    sed "s/lift/lit/" lifted.yaml >misspelt.yaml
    build/photonlab render misspelt.yaml -o misspelt.png 2>&1 | grep "did you mean 'lift'"
}
