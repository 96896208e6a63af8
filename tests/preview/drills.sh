# What students' code does to a window: nothing but a banner. One step is broken in every way there is, and mended.
broken=1_diffuse_photon_map/1.3_scatter_diffuse.c

# step HEAD BODY: step 1.3 with this before the function and this in it.
step() {
    printf '#include "photonlab.h"\n#include <stdlib.h>\n#include <string.h>\n%s\nVec3 scatter_diffuse(Vec3 normal, Rng *rng)\n{\n%s\n}\n' "$1" "$2"
}

# drill NAME PATTERN HEAD BODY: the window says PATTERN, keeps its photons, turns, and recovers with the next good save.
drill() {
    local name=$1 pattern=$2 before
    before=$(lines_of "$pattern")
    step "$3" "$4" | save $broken
    told "$name" "$pattern" 12 "$before"
    if picture_now fault_here && drag 1 40 12 && sleep 0.1 && picture_now fault_turned && photons_in fault_turned; then
        other "$name: it keeps its photons, and turns" fault_here.png fault_turned.png
    else
        bad "$name: no picture, or one without photons"
    fi
    mend "$name"
    kill -0 "$window" 2>/dev/null || bad "$name: the window is gone"
}

# To the window these are like those that check_drills has; tests/unit/preview/test_preview_faults.c tells their sentences apart.
more_drills() {
    drill "stack overflow" '1\.3.*deeper|1\.3.*stack' \
        'static Vec3 deeper(Vec3 n, Rng *rng, int d) { volatile char room[4096]; room[d % 4096] = 1; Vec3 v = deeper(n, rng, d + 1); v.x += (float)room[0]; return v; }' \
        'return deeper(normal, rng, 0);'
    drill "abort" '1\.3.*scatter_diffuse.*abort' '' 'if (rng) abort(); return normal;'
    drill "exit" '1\.3.*exit|exit\(' '' 'if (rng) exit(0); return normal;'
    drill "undefined symbol" '1\.3.*no_such_function|no_such_function.*1\.3' 'Vec3 no_such_function(Vec3);' 'return no_such_function(normal);'
}

mend() {
    local after
    after=$(lines_of 'after the save')
    save $broken <solutions/$broken
    told "$1: recovers at the next good save" 'after the save' 12 "$after"
}

# A picture without photons is much smaller as a PNG: an empty box of lines.
photons_in() {
    [ "$(wc -c <"$work/$1.png")" -gt $(($(wc -c <"$work/full.png") / 2)) ]
}

check_drills() {
    picture_now full || { bad "no picture of the whole"; return; }
    drill "segfault" '1\.3.*scatter_diffuse.*segmentation fault' '' \
        'volatile float *nothing = NULL; normal.x = *nothing; return normal;'
    drill "endless loop" '1\.3.*scatter_diffuse.*endless' '' \
        'volatile int forever = 1; while (forever) normal.x += 0.0f * rng_float(rng); return normal;'
    drill "memory bomb" '1\.3.*memory' '' \
        'for (;;) { char *room = malloc(64 << 20); memset(room, 1, 64 << 20); normal.x += (float)room[rng_u32(rng) % 64]; }'
    drill "build error" '1\.3_scatter_diffuse\.c:[0-9]+:.*error' '' 'return normal'
    [ -n "$few" ] || more_drills

    # These build and run, whatever they give; what the compiler knows is told.
    step '' 'rng_float(rng); normal.x += 0.0f;' | save $broken
    told "forgotten return" '1\.3_scatter_diffuse\.c:[0-9]+:.*warning.*return'
    mend "forgotten return"
    step '' 'return vec3_scale(normal, 0.5f + 0.0f * rng_float(rng));' | save $broken
    told "half a direction" 'one of your steps 1\.2, 1\.3 gave a direction whose length is 0\.5'
    mend "half a direction"
    flood
    not_played
    edited_scene
}

# A scene and its mesh are loaded anew when they change; what cannot be read is told, and the last good one stays.
edited_scene() {
    local scene=$work/box_diffuse.yaml anew='photons stored .* after the change of the scene'
    printf 'v 0 -1 0\nv 0.4 -1 0\nv 0 -0.3 0.2\nf 1 2 3\n' >"$work/corner.obj"
    picture_now before
    cp "$scene" "$work/saved.yaml"
    sed '/centre: \[0.40/c\  - {type: mesh, material: red, file: corner.obj}' "$work/saved.yaml" >"$scene"
    told "a scene that is edited" "$anew"
    picture_now after
    other "… is shown" before.png after.png
    echo '  - {type: sphere, material: nothing}' >>"$scene"
    told "a mistake in the scene" 'box_diffuse\.yaml:[0-9]+:[0-9]+: .*centre'
    picture_now wrong && photons_in wrong && good "… leaves the last good one" || bad "a mistake in the scene: no photons are left"
    sed '/centre: \[0.40/c\  - {type: mesh, material: red, file: corner.obj}' "$work/saved.yaml" >"$scene"
    told "the scene is mended" "$anew" 12 1
    echo 'f 1 3 2' >>"$work/corner.obj"
    told "a mesh that is edited" "$anew" 12 2
    cp "$work/saved.yaml" "$scene"
    told "the scene as it was" "$anew" 12 3
}

# With 3.4 written, the loop of 1.5 does not play: a save of it changes nothing, and that is said.
not_played() {
    local other=1_diffuse_photon_map/1.5_trace_photon.c
    save $other <solutions/$other
    told "not played" '1\.5 is built, but another step plays in its place'
}

# What a step prints, a million times perhaps, reaches the terminal in part.
flood() {
    step '#include <stdio.h>' 'static int calls; printf("call %d of the step\n", ++calls); return vec3_scale(normal, 1.0f + 0.0f * rng_float(rng));' | save $broken
    wait_for 12 said_again '[0-9]+ more lines that your code printed' 0
    local shown
    shown=$(lines_of 'call [0-9]+ of the step')
    check "$shown == 100 || $shown == 200" "a step that prints: $shown lines, then: $(grep 'more lines' "$log" | tail -1)"
    mend "a step that prints"
}
