#!/bin/sh
# Lines of the library's C, and of the tests' C and shell, room by room. Usage: size.sh [COMMIT]   (none: as it stands)
cd "$(dirname "$0")/.." || exit 2
if [ -n "${1:-}" ]; then
    work=$(mktemp -d)
    trap 'rm -rf "$work"' EXIT
    git archive "$1" lib tests | tar -x -C "$work" && cd "$work" || exit 1
fi
find lib tests -name '*.[ch]' -o -name '*.def' -o -name '*.sh' | LC_ALL=C sort | xargs wc -l | awk '
    $2 == "total" { next }
    {
        room = $2
        sub(/\/[^\/]*$/, "", room)
        if (match(room, /^tests\/(alternatives|attacks|extend|mistakes|steps|unit)/)) room = substr(room, 1, RLENGTH)
        if (!files[room]++) order[++rooms] = room
        lines[room] += $1
        all[substr(room, 1, index(room "/", "/") - 1)] += $1
        # Whole files of the later stages; their lines in others count for all.
        later = $2 ~ /^lib\/(steps\/[456]_|.*(gather|irradiance|progressive|passes|point_collect|merge|spectrum))/
        if ($2 ~ /^lib\/.*\.[ch]$/) c[later] += $1
    }
    END {
        for (i = 1; i <= rooms; i++) printf "%7d lines %3d files  %s\n", lines[order[i]], files[order[i]], order[i]
        printf "%7d lib: %d of .c and .h, and %d more in files that stages 4 to 6 alone have\n", all["lib"], c[0], c[1]
        printf "%7d tests\n", all["tests"]
    }'
