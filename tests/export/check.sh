#!/usr/bin/env bash
# Exported scenes, rendered by Mitsuba 3, are as bright as the path tracer's pictures; and what is written for pbrt-v4, of which no package is
# known to us, is what its file format's page allows. Usage: check.sh PROGRAM PYTHON, a Python that has Mitsuba (or is not there)
set -u
here=$(dirname "$0")
. "$here/../common.sh"
program=$1
python=$2

for scene in scenes/*.yaml tests/agreement/*.yaml; do
    name=$(basename "$scene" .yaml)
    "$program" export "$scene" -o "$work/$name.pbrt" --quiet || bad "$scene is not exported"
done
ok "$(ls "$work"/*.pbrt | wc -l) files for pbrt-v4 are what its format allows (pbrt itself was not run)" python3 "$here/pbrt_check.py" "$work"/*.pbrt
for edit in s/AttributeEnd// s/reflectance/reflection/ s/NamedMaterial.*/NamedMaterial\ "none"/ s/ply\"/plz\"/; do
    sed "$edit" "$work/box_glossy.pbrt" >"$work/broken.pbrt"
    ok "$edit is noticed" not python3 "$here/pbrt_check.py" "$work/broken.pbrt"
done

# same SCENE SAMPLES [FLAGS…]: Mitsuba's picture of it is as bright as ours, in each colour
same() {
    local scene=$1 name samples=$2
    name=$(basename "$scene" .yaml)
    "$program" export "$scene" -o "$work/$name.xml" --size 64x64 --samples "$samples" --quiet &&
        "$python" "$here/mitsuba_render.py" "$work/$name.xml" "$work/mitsuba.pfm" &&
        "$program" render "$scene" --integrator path --size 64x64 --samples "$samples" --quiet -o "$work/path.pfm" ||
        { bad "$name: does not run"; return; }
    same_means "$name" "$("$program" diff "$work/mitsuba.pfm" "$work/path.pfm" --json)"
}

if [ ! -x "$python" ]; then
    echo "skipped: the pictures by Mitsuba 3, which needs python3-venv (on Debian: apt-get install python3-venv) and a way to PyPI"
    finish
    exit
fi
ln -s "$PWD/scenes/meshes" "$work/meshes"
agreement=tests/agreement
# Two balls of glass, one of them a mesh with smooth normals; all lamps but the beam, on surfaces that both know.
sed -e 's/indices: .*}/index: 1.5}/' \
    -e 's|{type: prism.*|{type: mesh, file: meshes/bumpy_sphere.obj, material: flint, scale: 0.35, translate: [0.5, 0.4, 0]}|' \
    $agreement/dispersion.yaml >"$work/mesh_of_glass.yaml"
sed -e '/type: beam/d' -e 's/type: glossy, diffuse\(.*\), specular.*/type: diffuse, reflectance\1}/' $agreement/lights.yaml >"$work/lamps.yaml"
if "$program" render scenes/box_glass.yaml --size 61x47 --samples 1 --photons 1000 --quiet -o "$work/ours.exr" 2>"$work/err"; then
    "$program" render scenes/box_glass.yaml --size 61x47 --samples 1 --photons 1000 --quiet -o "$work/ours.pfm"
    "$python" "$here/mitsuba_render.py" "$work/ours.exr" "$work/theirs.pfm" "$work/theirs.exr"
    for file in theirs.pfm theirs.exr; do
        expect 0 "relMSE 0, trimmed 0" "$program" diff "$work/$file" "$work/ours.pfm"
    done
else
    echo "skipped: pictures in EXR: $(cat "$work/err")"
fi
same scenes/cornell_box.yaml 1024   # a mesh
same scenes/box_glass.yaml 1024     # a mirror and a ball of glass
same "$work/mesh_of_glass.yaml" 1024
same "$work/lamps.yaml" 512
same $agreement/matt_in_glass.yaml 1024
finish
