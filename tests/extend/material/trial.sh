# Velvet: a rough material with a BRDF that no step knows. Photons and the path tracer must see the same.
most=3
added lib/scene/materials/velvet.c "material_velvet"
place lib/scene/materials.def "MATERIAL(light)" "MATERIAL(velvet)" "material_velvet"
written scenes/README.md scene-page "scenes/README.md is not current"

try() {
    build all check-scene-page || return 1
    sed 's/^  - .*name: *white.*/  - {name: white, type: velvet, fibres: [0.6, 0.5, 0.4]}/' scenes/box_diffuse.yaml >velvet.yaml
    local kind
    for kind in photons path; do
        build/photonlab render velvet.yaml --integrator $kind --size 32x32 --samples 32 --photons 50000 --quiet --json -o $kind.pfm >$kind.json || return 1
    done
    holds "$(number "$(cat photons.json)" photons_stored) > 10000" || { echo "velvet stores no photons"; return 1; }
    local ratio
    ratio=$(number "$(build/photonlab diff photons.pfm path.pfm --json)" mean_ratio)
    holds "$ratio > 0.95 && $ratio < 1.05" || { echo "velvet: photons are $ratio times the path tracer's light"; return 1; }
}
