#!/usr/bin/env bash
# A day of work: thousands of saves in one window, whose helper must live on, and neither may grow; then the helper is killed and
# stopped, files' times jump, and there is no room for the compiler. Usage: saves.sh PROGRAM BUILD COMMAND, as check.sh; SAVES=10000.
set -u
program=$1
preview_build=$3
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
. "$here/common.sh"
saves=${SAVES:-10000}
step=1_diffuse_photon_map/1.3_scatter_diffuse.c
wait_before=60 # s: no measure of speed

# small_room_end: the room without room goes, if there is one.
small_room_end() { ! mountpoint -q "$work/room" 2>/dev/null || umount "$work/room"; }
trap 'window_end; small_room_end; rm -rf "$work"' EXIT

# Saves are many, so their objects are there: what is saved says which.
real_build=$preview_build
student_start || bad "the reference does not build as a student's code"
cp solutions/$step "$work/good.c"
printf '#include "photonlab.h"\nVec3 scatter_diffuse(Vec3 n, Rng *rng)\n{\n    rng_float(rng);\n    return n; // straight\n}\n' >"$work/other.c"
sh -c "$real_build" sh "$work/good.c" "$work/good.so" && sh -c "$real_build" sh "$work/other.c" "$work/other.so" || bad "no objects"
preview_build="if [ -e '$work/really' ]; then $real_build; else if grep -q straight \"\$1\"; then cp '$work/other.so' \"\$2.new\"; else cp '$work/good.so' \"\$2.new\"; fi && mv \"\$2.new\" \"\$2\"; fi"

helper_of() { pgrep -P "$window" | head -1; }
files_of() { find "/proc/$1/fd" -mindepth 1 2>/dev/null | wc -l; }
kilobytes_of() { awk '/^VmRSS/ { print $2 }' "/proc/$1/status"; }

# one_save FILE: and wait for its photons.
one_save() {
    local told
    told=$(lines_of 'stored of .* after the save')
    save $step <"$1"
    wait_for ${2:-$wait_before} said_again 'stored of .* after the save' "$told"
}

many_saves() {
    local i helper files files_helper kilobytes lost=0
    for ((i = 1; i <= saves; i++)); do
        if [ $((i % 2)) = 1 ]; then one_save "$work/other.c"; else one_save "$work/good.c"; fi || lost=$((lost + 1))
        if [ $i = 100 ]; then # the caches have filled
            helper=$(helper_of) files=$(files_of "$window") files_helper=$(files_of "$helper") kilobytes=$(kilobytes_of "$window")
        fi
    done
    check "$lost == 0" "$saves saves, $lost without an answer within $wait_before s"
    [ "$saves" -ge 100 ] || return
    [ "$(helper_of)" = "$helper" ] && good "the same helper after $saves saves" || bad "helper $helper became $(helper_of)"
    check "$(files_of "$window") == $files && $(files_of "$helper") == $files_helper" \
        "open files: $files and $files_helper after 100 saves, $(files_of "$window") and $(files_of "$helper") at the end"
    check "$(kilobytes_of "$window") < $kilobytes + 16384" "memory: $kilobytes kB after 100 saves, $(kilobytes_of "$window") kB at the end"
}

# replaced SIGNAL: a helper that gets this is replaced, told, and the next save is answered.
replaced() {
    local told helper
    told=$(lines_of 'another has taken its place')
    helper=$(helper_of)
    kill "-$1" "$helper"
    [ "$1" = KILL ] || save $step <"$work/other.c"
    wait_for 30 said_again 'another has taken its place' "$told" && ! grep -q 'endless loop' "$log" &&
        one_save "$work/good.c" && [ "$(helper_of)" != "$helper" ] && good "SIG$1 for the helper: $(grep 'taken its place' "$log" | tail -1)" ||
        bad "SIG$1 for the helper: $(tail -3 "$log")"
}

# A save from another clock: its file is older than what was built from the last, or from the future.
clock_jumps() {
    local day told
    for day in 1999-01-01 2099-01-01; do
        told=$(lines_of 'stored of .* after the save')
        cp "$work/other.c" "$work/saved" && touch -d $day "$work/saved" && mv "$work/saved" "$student/$step"
        wait_for $wait_before said_again 'stored of .* after the save' "$told" && good "a save of $day" || bad "a save of $day: $(tail -2 "$log")"
    done
    one_save "$work/good.c" && good "and one of today" || bad "none of today: $(tail -2 "$log")"
}

no_room() {
    touch "$work/really"
    if ! [ -e "$work/room/full" ]; then
        echo "○ a full folder for the compiler needs the right to mount one"
        return
    fi
    save $step <"$work/other.c"
    told "no room for the compiler" 'No space left|[Nn]o usable temporary|cannot|error'
    rm "$work/room/full"
    one_save "$work/good.c" && good "room again: $(grep 'stored of .* after the save' "$log" | tail -1)" || bad "room again: $(tail -3 "$log")"
}

mkdir "$work/room" && mount -t tmpfs -o size=64k none "$work/room" 2>/dev/null &&
    { head -c 1M /dev/zero >"$work/room/full" 2>/dev/null || :; }
cp scenes/box_diffuse.yaml "$work/"
if ! { display_start && TMPDIR=$work/room window_start "$work/box_diffuse.yaml" --photons 2000 --size 320x240; }; then
    bad "the window does not open: $(cat "$work"/*.log)"
    finish
    exit 1
fi
many_saves
replaced KILL
replaced STOP
clock_jumps
no_room
finish
