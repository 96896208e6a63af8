# Two scenes by Mitsuba 3, by the path tracer and by photons: means against Mitsuba's, and one scene's pictures side by side.
# Usage: further_outside.sh OUT.png OUT.txt
set -eu
python=$BUILD/mitsuba/bin/python
[ -x "$python" ] || make -s "$python"
[ -x "$python" ] || { echo "Mitsuba 3 could not be had: it needs python3-venv and a way to PyPI"; exit 1; }
at=$BUILD/figures/further_outside
for scene in cornell_box box_glass; do
    size="--size 200x200 --quiet"
    "$BUILD/photonlab" export scenes/$scene.yaml -o "$at.xml" $size --samples 128
    "$python" tests/export/mitsuba_render.py "$at.xml" "${at}_$scene.mitsuba.pfm"
    "$BUILD/photonlab" render scenes/$scene.yaml -o "${at}_$scene.path.pfm" $size --samples 128 --integrator path
    "$BUILD/photonlab" render scenes/$scene.yaml -o "${at}_$scene.photons.pfm" $size --samples 16 --photons 1000000 --k 100
    for way in path photons; do
        "$BUILD/photonlab" diff "${at}_$scene.$way.pfm" "${at}_$scene.mitsuba.pfm" --json |
            sed "s/.*\"mean_ratio\":\[\([^]]*\)\].*/\1/" | tr , '\n' | awk -v name=${scene}_$way '{ printf "%s_%d %.4f\n", name, NR, $1 }'
    done
done >"$2"
"$BUILD/figures/1_join" "$1" "${at}_box_glass.mitsuba.pfm" "${at}_box_glass.path.pfm" "${at}_box_glass.photons.pfm"
