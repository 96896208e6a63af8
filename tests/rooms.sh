#!/bin/sh
# Rooms, and arrows one way: rooms.awk tells what is checked. Usage: rooms.sh [ROOT]
cd "${1:-.}" || exit 2
find lib tests \( -name alternatives -o -name attacks -o -name mistakes -o -path 'tests/extend/*' \) -prune -o \
    \( -name '*.[ch]' -o -name '*.def' -o -name '*.inc' -o -name '*.sh' -o -name '*.awk' \) -print | LC_ALL=C sort |
    xargs awk -f "${ROOMS:-tests/rooms.awk}" lib/README.md tests/README.md
