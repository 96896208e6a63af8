#!/usr/bin/env bash
# A live picture in tev, for which a small listener stands in. Usage: tev.sh PROGRAM
set -u
here=$(dirname "$0")
. "$here/../common.sh"
program=$1

# show FLAGS… [-- HANG_UP_AFTER]: renders into saved.pfm, while the listener draws seen.pfm
show() {
    rm -f "$work"/port "$work"/*.pfm
    python3 "$here/tev_listener.py" "$work/port" "$work/seen.pfm" $hang_up >"$work/heard" 2>&1 &
    local listener=$! tries=0
    until [ -s "$work/port" ] || [ $((tries += 1)) -gt 200 ]; do sleep 0.05; done
    "$program" render scenes/box_glass.yaml -o "$work/saved.pfm" --tev "localhost:$(cat "$work/port")" --quiet "$@" 2>"$work/said"
    code=$?
    wait $listener
}

hang_up=
show --size 53x37 --photons 5000 --samples 1
ok "tev has the picture that was saved, to the bit: $(cat "$work/heard")" cmp "$work/seen.pfm" "$work/saved.pfm"
ok "tile by tile" grep -q '12 updates, all pixels after 12' "$work/heard" # 16 pixels a side: 4 across, 3 down
show --size 53x37 --photons 2000 --passes 5
ok "pass by pass, after 1, 2, 4 and 5: $(cat "$work/heard")" cmp "$work/seen.pfm" "$work/saved.pfm"
ok "each of them" grep -q '4 updates, all pixels after 1' "$work/heard"
hang_up=2
show --size 320x240 --photons 2000 --samples 4
check "$code == 0" "a viewer that goes does not stop the work"
ok "but it is told" grep -q "the rest of the picture was not shown" "$work/said"
ok "and the picture is there" test -s "$work/saved.pfm"
expect 1 "tev at localhost:1: Connection refused" "$program" render scenes/box_glass.yaml --photons 1000000000 -o "$work/a.png" --tev localhost:1
expect 1 "expected HOST or HOST:PORT" "$program" render scenes/box_glass.yaml -o "$work/a.png" --tev "localhost:none"
ok "no picture then" not test -e "$work/a.png"
finish
