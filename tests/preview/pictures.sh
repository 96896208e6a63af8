# Snapshots without a window: from OSMesa, EGL and a hidden window the same bytes; with neither library, what to install.

# shot NAME [FLAG…]
shot() {
    local name=$1
    shift
    "$program" preview scenes/box_glass.yaml --photons 20000 --size 480x360 --snapshot "$work/$name.png" "$@" >"$work/$name.log" 2>&1
}

# rendered PASSES "FLAGS" "FLAGS OF RENDER": the snapshot of a picture is what `photonlab render` makes, but for the camera's rounding.
rendered() {
    shot rendered --size 96x96 --bare --render "$1" $2 --code "$objects" || bad "a snapshot --render $1 $2: $(cat "$work/rendered.log")"
    "$program" render scenes/box_glass.yaml --size 96x96 --photons 20000 $3 --quiet -o "$work/render.png"
    local difference
    difference=$(number "$("$program" diff "$work/rendered.png" "$work/render.png" --json)" relmse_all)
    check "$difference < 3e-5" "a snapshot --render $1 $2: relMSE $difference to render $3"
}

check_renders() {
    rendered 1 "" "--samples 1"
    rendered 1 "--integrator gather" "--samples 1 --integrator gather"
    rendered 3 "--radii pass" "--passes 3"
    rendered 3 "--radii pixel" "--passes 3 --radii pixel"
    rendered 1 "--spectral" "--samples 1 --spectral"
}

# Each view from each context; where few are wanted, from OSMesa and one of the others, in turn.
check_contexts() {
    local view context one=osmesa others="egl window"
    display_start 640 480
    if ! shot osmesa --context osmesa && grep -q "there is no libOSMesa" "$work/osmesa.log"; then
        echo "  (no OSMesa here, which newer systems have dropped: EGL and a window are compared)"
        one=egl others=window
    fi
    for view in points paths lobe screen tree radii spectrum estimates; do
        [ "$few$one" != fewosmesa ] || others=$([ "$others" = egl ] && echo window || echo egl)
        for context in $one $others; do
            shot "$context" --view $view --split --context "$context" || bad "$view by $context: $(cat "$work/$context.log")"
        done
        for context in $others; do
            same "$view: the same bytes from $one and $context" "$one.png" "$context.png"
        done
    done
    kill "$xvfb"
    wait "$xvfb" 2>/dev/null
    unset DISPLAY
}

check_pictures() {
    check_contexts
    shot reference || bad "a snapshot without a display: $(cat "$work/reference.log")"
    PHOTONLAB_WITHOUT=osmesa shot without || bad "without OSMesa: $(cat "$work/without.log")"
    same "without OSMesa: the same bytes" reference.png without.png
    rm -f "$work/neither.png"
    PHOTONLAB_WITHOUT=osmesa,egl shot neither
    [ $? = 1 ] && grep -q 'libosmesa6' "$work/neither.log" && [ ! -e "$work/neither.png" ] &&
        good "with neither: $(cat "$work/neither.log")" || bad "with neither: $(cat "$work/neither.log")"
    check_renders
    shot again && same "the same bytes again" reference.png again.png
    for flags in "--view nothing" "--colour nothing" "--camera 1,2,3" "--size 10x10" "--angle 95" "--every-save"; do
        shot wrong $flags
        [ $? = 2 ] && good "$flags: $(head -1 "$work/wrong.log")" || bad "$flags: exit code is not 2"
    done
    # Without a display the window's command writes a snapshot on each save.
    "$program" preview scenes/box_diffuse.yaml --photons 20000 --size 480x360 --snapshot "$work/headless.png" --code "$objects" \
        --watch "$student" --build "$preview_build" >"$work/headless.log" 2>&1 &
    headless=$!
    wait_for 10 grep -q 'is new' "$work/headless.log" && good "no display: $(head -1 "$work/headless.log")" || bad "no display: $(cat "$work/headless.log")"
    cp "$work/headless.png" "$work/first.png"
    printf '#include "photonlab.h"\nVec3 scatter_diffuse(Vec3 normal, Rng *rng)\n{\n    return rng_float(rng) < 2.0f ? normal : normal;\n}\n' |
        save 1_diffuse_photon_map/1.3_scatter_diffuse.c
    wait_for 10 eval '[ $(grep -c "is new" "$work/headless.log") -ge 2 ]' && ! cmp -s "$work/first.png" "$work/headless.png" &&
        good "a save: a new snapshot" || bad "a save: no new snapshot: $(tail -2 "$work/headless.log")"
    save 1_diffuse_photon_map/1.3_scatter_diffuse.c <solutions/1_diffuse_photon_map/1.3_scatter_diffuse.c
    # Built again before it is ended: what comes next plays these objects.
    wait_for 10 eval '[ $(grep -c "is new" "$work/headless.log") -ge 3 ]' || bad "no snapshot after the last save"
    kill "$headless"
    wait "$headless" 2>/dev/null
    headless=
}
