#!/usr/bin/env bash
# Every attack under bubblewrap and, as root, under a user of its own, side by side. Arguments: as run.sh.
set -u
here=$(dirname "$0")
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT
if [ "$(id -u)" = 0 ]; then
    PHOTONLAB_SANDBOX=uid bash "$here/run.sh" "$@" >"$logs/uid" 2>&1 &
else
    echo "○ the sandbox of a user of its own needs root"
fi
if bwrap --unshare-all --ro-bind / / true 2>/dev/null; then
    PHOTONLAB_SANDBOX=bubblewrap bash "$here/run.sh" "$@" >"$logs/bubblewrap" 2>&1
else
    echo "○ bubblewrap does not run here (are namespaces for users switched off?)"
fi
wait
cat "$logs"/* 2>/dev/null | grep -vE '^[0-9]+ passed, [0-9]+ failed$'
passed=$(cat "$logs"/* 2>/dev/null | grep -c '^✓')
failed=$(cat "$logs"/* 2>/dev/null | grep -c '^✗')
echo "$passed passed, $failed failed"
[ "$passed" != 0 ] && [ "$failed" = 0 ]
