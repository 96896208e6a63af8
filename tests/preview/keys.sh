# Every key, the mouse, resizing and closing; each must change the picture, and changes back where it can.

# differs NAME ACTION…: the picture before and after is not the same.
differs() {
    local name=$1
    shift
    picture_now before && "$@" && sleep 0.3 && picture_now after || { bad "$name: no pictures"; return; }
    other "$name" before.png after.png
}

# looks_other: the picture is no longer the one before; to be waited for, where a change takes its time.
looks_other() {
    picture_now after && ! cmp -s "$work/before.png" "$work/after.png"
}

drag() {
    xdotool mousemove 320 240 mousedown "$1" mousemove_relative -- "$2" "$3" mousemove_relative -- 5 5 mouseup "$1"
}

# Waits for photons that were asked for by a key.
key_and_photons() {
    local count
    count=$(lines_of 'photons stored')
    key "$1"
    wait_for 10 said_again 'photons stored' "$count"
}

check_keys() {
    differs "h: the list of keys" key h
    differs "h again: no list" key h
    key h
    differs "escape: no list, and no end" key Escape
    differs "drag: turns" drag 1 60 20
    differs "right drag: moves" drag 3 30 10
    differs "wheel: nearer" xdotool click 4
    differs "wheel: farther" xdotool click --repeat 2 5
    differs "f: frames the scene" key f
    differs "0: the scene's camera" key 0
    differs "c: colours" key c
    differs "w: no wireframe" key w
    differs "t: the picture alone" key t
    key t
    differs "r: other photons" key_and_photons r
    differs "+: more photons" key_and_photons plus
    differs "-: fewer photons" key_and_photons minus
    differs "b: the reference beside" eval 'key b; sleep 0.7'
    key b
    differs "2: paths" key 2
    differs "right: a photon" key Right
    differs "up: its bounces" key Up
    differs "3: the lobe" eval 'key 3; sleep 0.5'
    differs "up: another exponent" eval 'key Up; sleep 0.5'
    differs "right: another angle" eval 'key Right; sleep 0.5'
    differs "d: diffuse" eval 'key d; sleep 0.5'
    differs "4: a screen" key 4
    differs "right: another surface" key Right
    differs "drag: moves the screen" drag 1 60 20
    differs "wheel: the screen nearer" xdotool click 4
    grep -qE 'view screen .*--framing 1\.1[0-9]*,-?0\.[0-9]+,-?0\.' "$log" && good "s: tells the command, with its framing" || bad "s: $(grep -- '--view screen' "$log" | tail -1)"
    differs "f: frames the screen" key f
    differs "5: the tree" key 5
    differs "up: another depth" key Up
    differs "6: the disks of passes" eval 'key 6; sleep 1'
    differs "up: a pass later" key Up
    differs "7: the spectrum" key 7
    differs "8: estimates of irradiance" eval 'key 8; sleep 0.1; wait_for 15 looks_other; sleep 1'
    differs "v: their places alone" key v
    differs "1: points" key 1
    differs "space: slow light" key space
    key space
    differs "p: renders" eval 'key p; wait_for 15 looks_other'
    differs "drag: the picture turns with it" eval 'drag 1 60 20; wait_for 15 looks_other'
    differs ". : brighter" key period
    differs ", : darker" key comma
    differs "i: gathers" eval 'key i; wait_for 15 looks_other'
    wait_for 15 eval 'picture_now after && grep -q -- "--render [0-9]* --integrator gather" "$log"' && good "s: tells how it was rendered" || bad "s: does not tell how it was rendered"
    differs "i: by passes" eval 'key i; wait_for 15 looks_other'
    differs "b: the reference's picture beside" eval 'key b; wait_for 15 looks_other'
    key b
    key p
    key o
    told "o: the report, or how to get one" 'no report yet|the report: ' 5
    screen_now before
    local id
    id=$(xdotool search --onlyvisible --name photonlab | head -1)
    xdotool windowsize --sync "$id" 800 500
    sleep 0.3
    screen_now after
    other "resizes" before.screen after.screen
    picture_now resized
    ok "its snapshot has the new size" [ "$(png_size "$work/resized.png")" = 800x500 ]
}

# Width and height stand in bytes 16 to 23 of every PNG.
png_size() {
    od -An -t u1 -j 16 -N 8 "$1" | awk '{ print $3 * 256 + $4 "x" $7 * 256 + $8 }'
}

check_close() {
    key q
    if wait_for 5 eval '! kill -0 $window 2>/dev/null'; then
        wait "$window" && good "q: closes, exit code 0" || bad "q: exit code $?"
    else
        bad "q does not close the window"
    fi
}
