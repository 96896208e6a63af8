# The panel: each save is judged beside, and its verdict told; keys lead to the next step and give hints. On a fine monitor.

# begin FILE: a right solution of a student who has just begun.
begin() {
    mkdir -p "$student/1_diffuse_photon_map"
    save "1_diffuse_photon_map/$1" <"solutions/1_diffuse_photon_map/$1"
}

check_verdicts() {
    local reflect=1_diffuse_photon_map/1.1_reflect.c
    student=$work/beginner
    objects=$work/beginner_objects
    mkdir -p "$objects"
    begin 1.1_reflect.c
    begin 1.3_scatter_diffuse.c
    xprop -root -format RESOURCE_MANAGER 8s -set RESOURCE_MANAGER 'Xft.dpi: 192'
    window_start "$work/box_diffuse.yaml" --photons 2000 --size 600x400 \
        --judge "$1/judge --build '$1' --work '$work/verdicts' --code '$student' --jobs 1 --lines --step \"\$1\" 2>&1" --stage 1
    told "what was there at the start is judged" 'judged: 1\.3 ✓' 60
    sed 's/-2.0f \* /-/; s/2.0f \* //' solutions/$reflect | save $reflect
    told "a save is judged" 'judged: 1\.1 ✗ .*expected' 30
    picture_now fails
    key n
    told "n: on to a step that is not right" 'the present step: .*/1\.2_emit_photon\.c' 5
    xdotool mousemove 951 35 click 1
    told "a click on a step goes to it" 'the present step: .*/1\.3_scatter_diffuse\.c' 5
    save $reflect <solutions/$reflect
    told "and again, when it is right" 'judged: 1\.1 ✓' 30 "$(lines_of 'judged: 1\.1 ✓')"
    picture_now passes
    other "the panel shows it" fails.png passes.png
    ok "on a fine monitor the window has twice as many pixels" [ "$(png_size "$work/passes.png")" = 1200x800 ]
    differs "?: a hint" key question
    echo 'int nothing' | save $reflect
    told "what does not compile is not judged" '1\.1_reflect\.c:[0-9]*:.*error' 12
    differs "n: another step" key n
    PHOTONLAB_WITHOUT=font shot wordless && ok "without the font: says so" grep -q 'fonts-dejavu-core' "$work/wordless.log"
}
