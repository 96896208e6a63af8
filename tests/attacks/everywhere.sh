#!/usr/bin/env bash
# Every attack under each sandbox that there is, side by side: bubblewrap, Landlock alone and, as root, a user of its own. SANDBOXES
# names others; EVERY=2: each attack under one of two, in turn. Arguments: as run.sh.
set -u
here=$(dirname "$0")
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT
turn=0
for sandbox in ${SANDBOXES:-uid landlock bubblewrap}; do
    PHOTONLAB_SANDBOX=$sandbox TURN=$((turn++ % ${EVERY:-1})) bash "$here/run.sh" "$@" >"$logs/$sandbox" 2>&1 &
done
wait
grep -hE '^(✓|✗|○)' "$logs"/* || cat "$logs"/*
passed=$(cat "$logs"/* | grep -c '^✓')
failed=$(cat "$logs"/* | grep -c '^✗')
echo "$passed passed, $failed failed"
[ "$passed" != 0 ] && [ "$failed" = 0 ]
