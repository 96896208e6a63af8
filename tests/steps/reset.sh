#!/bin/sh
# Puts a step's stub back; what was there is kept beside it. Usage: reset.sh STEP (in the folder that holds exercises/)
#
# The stubs come from exercises/.stubs/, which a handout without solutions has as well.
set -eu
here=$(dirname "$0")
step=${1:-}
sh "$here/known_step.sh" reset "$step"

for stub in exercises/.stubs/*/"$step"_*.c; do
    file=exercises/${stub#exercises/.stubs/}
    if cmp -s "$stub" "$file"; then
        echo "$file is the stub already; nothing to do"
        exit 0
    fi
    if [ -e "$file" ]; then
        n=1
        while [ -e "$file.saved-$n" ]; do n=$((n + 1)); done
        cp -p "$file" "$file.saved-$n"
        echo "your $file is kept as $(basename "$file").saved-$n"
    fi
    mkdir -p "$(dirname "$file")"
    cp "$stub" "$file.new"
    mv "$file.new" "$file"
    echo "$file is the stub again"
done
