#!/usr/bin/env bash
# How quick is the preview, with software OpenGL? Usage: preview.sh PROGRAM BUILD COMMAND (see tests/preview/check.sh)
#   save to new photons on the screen, 200000 photons, 20 saves: median below 0.5 s
#   frames a second while orbiting at 1280x720 with 50000 photons or more drawn: 30 or more
#   a million photons drawn within 0.5 s of coming to rest; idle: below 2 % of a core
# Once without the judge, and once with it at work beside, as `make preview` has it: how soon its verdict comes is told, too.
set -u
program=$1
preview_build=$3
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
. "$here/../preview/common.sh"
build=$2
trap 'window_end; rm -rf "$work"' EXIT
saves=20
step=1_diffuse_photon_map/1.3_scatter_diffuse.c

# now: seconds with a fraction.
now() {
    echo "${EPOCHREALTIME/,/.}"
}

# shown_after COUNT: the window has drawn new photons (it says so after the swap).
photons_drawn() {
    lines_of '^drawn: .* photons'
}

median() {
    sort -g | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'
}

# Every save is another text, so that the compiler has to work.
saved() {
    sed "s/2.0f \* PI \* u2/(2.0f + 0.0f * $1) * PI * u2/" solutions/$step >"$work/saved"
}

save_to_screen() {
    local i before start times=$work/times
    : >"$times"
    for ((i = 0; i < saves; i++)); do
        before=$(photons_drawn)
        saved $i
        start=$(now)
        mv "$work/saved" "$student/$step"
        wait_for 10 eval '[ "$(photons_drawn)" -gt $before ]' || { bad "save $i: no new photons"; return; }
        awk "BEGIN { print $(now) - $start }" >>"$times"
        # A person looks before the next save; all photons are there by then, and drawn.
        wait_for 10 said_again 'photons stored .* after the save' "$i"
        sleep 0.7
    done
    check "$(median <"$times") < 0.5" "$1: save to photons on screen, median of $saves: $(median <"$times") s (slowest $(sort -g "$times" | tail -1))"
}

# The window counts its own frames.
orbit_rate() {
    local line
    wait_for 30 grep -q '^orbit:' "$log"
    line=$(grep '^orbit:' "$log" | tail -1)
    set -- $line
    check "$2 >= 30" "$line"
    check "$7 >= 50000" "… at least 50000 of them"
    wait_for 10 grep -q '^rest:' "$log"
    line=$(grep '^rest:' "$log" | tail -1)
    set -- $line
    check "$2 < 0.5 && $6 >= 1000000" "$line"
}

processor_time() {
    awk '{ print $14 + $15 }' "/proc/$1/stat"
}

idle() {
    local before ticks child
    sleep 1
    before=$(for child in $window $(pgrep -P $window); do processor_time $child; done | awk '{ s += $1 } END { print s }')
    sleep 10
    ticks=$(for child in $window $(pgrep -P $window); do processor_time $child; done | awk '{ s += $1 } END { print s }')
    local share
    share=$(awk "BEGIN { print 100 * ($ticks - $before) / $(getconf CLK_TCK) / 10 }")
    check "$share < 2" "idle: $share % of a core"
}

# As lib/preview/preview.mk starts it. At the beginning it has all steps to judge.
judge() {
    echo "exec nice '$build/judge' --build '$build' --work '$work/verdicts' --code '$student' --jobs 1 --lines --step \"\$1\" 2>&1"
}

all_judged() {
    [ "$(lines_of '^judged: ')" -ge "$(ls "$student"/*/*.c | wc -l)" ]
}

# How soon after a save its verdict is there, when the next save waits for it.
save_to_verdict() {
    local i before start times=$work/verdict_times
    : >"$times"
    for ((i = 0; i < 5; i++)); do
        before=$(lines_of '^judged: 1\.3 ')
        saved $i
        start=$(now)
        mv "$work/saved" "$student/$step"
        wait_for 60 said_again '^judged: 1\.3 ' "$before" || { bad "save $i: no verdict"; return; }
        awk "BEGIN { print $(now) - $start }" >>"$times"
    done
    echo "  $1: save to verdict, median of 5: $(median <"$times") s (slowest $(sort -g "$times" | tail -1))"
}

student_start && display_start || exit 1
for scene in box_diffuse box_dispersion; do
    window_start scenes/$scene.yaml --photons 200000 || bad "no window: $(cat "$log")"
    save_to_screen $scene
    kill $window; wait $window 2>/dev/null
    window_start scenes/$scene.yaml --photons 200000 --judge "$(judge)" || bad "no window: $(cat "$log")"
    wait_for 300 all_judged || bad "not all steps are judged: $(tail -3 "$log")"
    save_to_screen "$scene, judged beside"
    save_to_verdict $scene
    kill $window; wait $window 2>/dev/null
done
window_start scenes/box_diffuse.yaml --photons 702000 --orbit 3 || bad "no window: $(cat "$log")"
orbit_rate
idle
kill $window; wait $window 2>/dev/null
echo "  with the judge at work beside, which has all steps to judge:"
window_start scenes/box_diffuse.yaml --photons 702000 --orbit 3 --judge "$(judge)" || bad "no window: $(cat "$log")"
orbit_rate
ok "… and it was at work" not all_judged
finish
