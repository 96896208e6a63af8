#!/usr/bin/env bash
# The command line: exit codes, messages, and that nothing is half-written. Usage: cli.sh PROGRAM BUILD
set -u
here=$(dirname "$0")
. "$here/common.sh"
program=$1
build=$2
scene=scenes/box_glass.yaml
quick="--size 16x16 --photons 2000 --samples 1"

expect 2 "usage" "$program"
expect 0 "usage" "$program" --help
expect 2 "no command \`paint\`" "$program" paint
expect 0 "usage: photonlab export" "$program" help export
for command in render merge photons diff export steps; do
    expect 0 "usage: photonlab $command" "$program" $command --help
    expect 2 "--help lists the flags" "$program" $command --no-such-flag
done

# Wrong usage: 2.
expect 2 "expected one scene file" "$program" render -o "$work/a.png"
expect 2 "say where to write" "$program" render $scene
expect 2 "expected .png (to look at), .pfm (to measure) or .exr" "$program" render $scene -o "$work/a.jpg"
expect 2 "--photons 0: expected a whole number" "$program" render $scene -o "$work/a.png" --photons 0
expect 2 "--photons 1e6: expected a whole number" "$program" render $scene -o "$work/a.png" --photons 1e6
expect 2 "--k -3" "$program" render $scene -o "$work/a.png" --k -3
expect 2 "--radius nan" "$program" render $scene -o "$work/a.png" --radius nan
expect 2 "--radius inf" "$program" render $scene -o "$work/a.png" --radius inf
expect 2 "from 0 to 1000000000" "$program" render $scene -o "$work/a.png" --radius 1e30
expect 2 "--size 12: expected WIDTHxHEIGHT" "$program" render $scene -o "$work/a.png" --size 12
expect 2 "--size 0x5" "$program" render $scene -o "$work/a.png" --size 0x5
expect 2 "--seed -1" "$program" render $scene -o "$work/a.png" --seed -1
expect 2 "no choice \`\`" "$program" render $scene -o "$work/a.png" --steps ""
expect 2 "no choice \`2.4\`" "$program" render $scene -o "$work/a.png" --steps 2.3,2.4
expect 2 "path tracer knows whole glass only" "$program" render $scene -o "$work/a.png" --integrator path --glass-sides 1
expect 2 "knows red, green and blue only" "$program" render $scene $quick -o "$work/a.png" --integrator path --spectral
expect 2 "--wavelengths 2: expected 1 or 3" "$program" render $scene -o "$work/a.png" --wavelengths 2
expect 2 "no such flag, or its value is missing" "$program" render $scene -o "$work/a.png" --photons
expect 2 "no choice \`4.2\`" "$program" render $scene -o "$work/a.png" --steps 4.2
expect 2 "--integrator magic: expected photons" "$program" render $scene -o "$work/a.png" --integrator magic
expect 2 "--glass-sides 3" "$program" render $scene -o "$work/a.png" --glass-sides 3
expect 2 "expected .ply or .csv" "$program" photons $scene -o "$work/a.txt"
expect 2 "expected two pictures" "$program" diff "$work/a.pfm"
expect 2 "expected .xml (Mitsuba 3) or .pbrt (pbrt-v4)" "$program" export $scene -o "$work/a.obj"
expect 2 "--mask 1,2,3" "$program" diff a.pfm b.pfm --mask 1,2,3

# For other renderers; make check-export has them render it.
expect 0 "glass has one index" "$program" export scenes/box_dispersion.yaml -o "$work/a.xml"
ok "it is XML" xmllint --noout "$work/a.xml"
expect 0 "renders by wavelength" "$program" export scenes/box_dispersion.yaml -o "$work/a.pbrt"
ok "glass has its index over wavelength" grep -q 'dielectric.*spectrum eta.* 590 2\.417' "$work/a.pbrt"
expect 1 "No such file" "$program" export $scene -o "$work/no/such/place.xml"
if "$program" render $scene $quick -o "$work/a.exr" --quiet 2>"$work/err"; then
    "$program" render $scene $quick -o "$work/a.pfm" --quiet
    expect 0 "relMSE 0, trimmed 0" "$program" diff "$work/a.exr" "$work/a.pfm"
else
    ok "without OpenEXR it is said" grep -q "built without OpenEXR" "$work/err"
fi

# The table of steps, and hints.
expect 0 "2.1	sample_lobe	2	2_glossy_lobe/2.1_sample_lobe	" "$program" steps
expect 0 "cosα = u₁^(1/(n+1))" "$program" steps --hint 2.1 --level 2
expect 2 "no such step; there are 1.1 1.2" "$program" steps --hint 9.9
expect 2 "of which step" "$program" steps --level 2
expect 2 "from 1 to 3" "$program" steps --hint 1.1 --level 4
expect 2 "expected no file" "$program" steps 1.1

# Wrong input or output: 1, and no file.
expect 1 "No such file" "$program" render "$work/none.yaml" -o "$work/a.png"
expect 1 "No such file" "$program" render $scene $quick -o "$work/no/such/place.png"
{ "$program" render $'\e[7m.yaml' -o "$work/a.png"; "$program" $'\e[7m'; "$program" steps --$'\e[7m'; } >"$work/out" 2>&1
ok "a name with escape codes upsets no terminal" [ "$(grep -c '?\[7m' "$work/out")" = 3 ]
expect 1 "is a directory" "$program" render scenes -o "$work/a.png"
printf 'materials: [' >"$work/broken.yaml"
expect 1 "broken.yaml:2:1: this is not YAML" "$program" render "$work/broken.yaml" -o "$work/a.png"
expect 1 "No such file" "$program" diff "$work/none.pfm" "$work/none.pfm"
printf 'PF\n4 4\n-1.0\nshort' >"$work/short.pfm"
expect 1 "short.pfm" "$program" diff "$work/short.pfm" "$work/short.pfm"
# The deepest path, in a box of mirrors, fits the stack; a deeper one is asked for neither by a scene nor by a flag.
sed 's/^  - {name.*type: diffuse.*/&/; s/type: diffuse.*}/type: mirror}/; $a \  - {type: rectangle, material: white, corner: [-1, -1, 4], edge_u: [0, 2, 0], edge_v: [2, 0, 0]}\nrender: {depth: 1000}' \
    $scene >"$work/mirrors.yaml"
expect 0 "" "$program" render "$work/mirrors.yaml" $quick --quiet -o "$work/mirrors.png"
sed -i 's/depth: 1000/depth: 10000/' "$work/mirrors.yaml"
expect 1 "depth is 10000; expected 1 to 1000" "$program" render "$work/mirrors.yaml" $quick -o "$work/a.png"
sed 's/{type: rectangle, corner.*/{type: spot, position: [0, 0.9, 0], target: [0, 0, 0], angle: 0.01, power: [1, 1, 1]}/' $scene >"$work/needle.yaml"
expect 1 "angle is 0.01; expected 0.1 to 180 degrees" "$program" render "$work/needle.yaml" $quick -o "$work/a.png"

# Where nothing can be written is said before the work, which here would take an hour.
expect 1 "No such file" timeout 20 "$program" render $scene --photons 1000000000 -o "$work/no/such/place.png"
expect 1 "No such file" timeout 20 "$program" photons $scene --photons 1000000000 -o "$work/no/such/place.ply"
for command in "steps" "render $scene $quick -o $work/full.png --json --quiet" "diff $work/full.png $work/full.png --json"; do
    "$program" $command >/dev/full 2>"$work/err"
    check "$? == 1" "${command%% *}: a full standard output is told: $(head -1 "$work/err")"
done

if ls "$work"/a.* "$work"/*.tmp-* >/dev/null 2>&1; then bad "a failed run leaves a file behind"; else good "failed runs leave no file behind"; fi

# What works: 0.
expect 0 "" "$program" render $scene $quick -o "$work/a.png"
expect 0 "" "$program" render $scene $quick -o "$work/a16.png" --bits 16
expect 0 '"ledger":{"emitted":[' "$program" render $scene $quick -o "$work/a.pfm" --json
expect 0 "" "$program" render $scene $quick -o "$work/b.pfm" --quiet --k 5 --radius 0.3 --integrator photons-only
expect 0 "mean ratio" "$program" diff "$work/a.pfm" "$work/b.pfm" -o "$work/d.png"
expect 0 '"relmse_trimmed":0' "$program" diff "$work/a.pfm" "$work/a.pfm" --json
if "$program" frame --help >/dev/null 2>&1; then # its letters are the preview's
    expect 2 "say where to: -o OUT.png" "$program" frame "$work/a.pfm"
    expect 0 "" "$program" frame "$work/a.pfm" "$work/b.pfm" -o "$work/framed.png" --title Ada --text 'one line\nanother'
    expect 0 "" "$program" frame "$work/a.pfm" "$work/b.pfm" -o "$work/bare.png" --title ' ' --text ' \n '
    if fc-list 2>/dev/null | grep -q DejaVu; then # without a font it has room for words alone
        cmp -s "$work/framed.png" "$work/bare.png" && bad "a frame has no words" || good "a frame has its words"
    else
        echo "○ a frame's words: there is no font"
    fi
    expect 1 "pixels high" "$program" frame "$work/a.pfm" "$work/framed.png" -o "$work/two.png"
fi
expect 0 "" "$program" photons $scene -o "$work/p.ply" --photons 500
expect 0 "" "$program" photons $scene -o "$work/p.csv" --photons 500

# A link leads where it led before. A run that is ended while it writes leaves nothing.
ln -s there.png "$work/link.png"
expect 1 "is a link that leads nowhere" "$program" render $scene $quick -o "$work/link.png"
: >"$work/there.png"
expect 0 "" "$program" render $scene $quick -o "$work/link.png"
ok "a picture goes where a link leads" test -L "$work/link.png" -a -s "$work/there.png"
"$program" photons $scene --photons 300000 -o "$work/ended.csv" --quiet &
until ls "$work"/ended.csv* >/dev/null 2>&1; do sleep 0.01; done
kill -TERM $!
wait $! 2>/dev/null
ok "ended while it writes, it leaves nothing half-written" not ls "$work"/ended.csv.tmp-*

# Memory that is not there: a message and code 1, nothing worse.
if ! nm -D "$program" | grep -q __asan; then
    ok "diff with each of its allocations failing" bash "$here/shortage/run.sh" "$program" diff
    expect 1 "not enough memory for the photons of 200000000 paths" \
        bash -c "ulimit -v 1000000; timeout 20 $program photons scenes/box_diffuse.yaml --photons 200000000 --threads 2 -o $work/many.ply"
    # What the picture takes later is told before it, by its own name.
    few="ulimit -v 900000; timeout 60 $program render scenes/box_diffuse.yaml --size 9x7 --quiet --threads 16 -o $work/many.png"
    expect 1 "not enough memory for 1000000 photons in an estimate" bash -c "$few --photons 1000000000 --k 1000000 --threads 40"
    expect 1 "not enough memory for the photons of 800000 paths" bash -c "$few --photons 800000 --passes 2 --radius 0.1"
    expect 1 "pictures of 1000 passes" bash -c "$few --size 4096x2048 --passes 1000 --photons 10 --radius 0.1"
fi

. "$here/cli_passes.sh"

# Every scene there is, in small.
for every in scenes/*.yaml; do
    expect 0 "" "$program" render "$every" --size 24x24 --photons 3000 --samples 2 -o "$work/s.png" --quiet
    expect 0 "" "$program" photons "$every" --photons 1000 -o "$work/s.ply" --quiet
done

# Every photon is in both files.
stored=$(($(wc -l <"$work/p.csv") - 1))
if grep -aq "element vertex $stored" "$work/p.ply"; then good "PLY and CSV hold the same $stored photons"; else bad "PLY and CSV differ in count"; fi
. "$here/cli_code.sh"
finish
