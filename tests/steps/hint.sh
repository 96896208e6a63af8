#!/bin/sh
# One hint a call, each telling more than the one before. Usage: hint.sh PROGRAM STEP BUILD
#
# BUILD/hints/STEP holds how many have been given.
set -eu
here=$(dirname "$0")
program=$1
step=$2
count_file=$3/hints/$2
sh "$here/known_step.sh" hint "$step"

# say LEVEL: the hint, indented and broken at blanks.
say() {
    "$program" steps --hint "$step" --level "$1" | fold -s -w 100 | sed 's/^ */    /; s/ *$//'
}

row=$("$program" steps | grep "^$step	")
title=$(echo "$row" | cut -f5)
chapter=$(echo "$row" | cut -f6)
given=0
[ -f "$count_file" ] && given=$(cat "$count_file")
case $given in [0-3]) ;; *) given=0 ;; esac

if [ "$given" -lt 3 ]; then
    given=$((given + 1))
    echo "Step $step: $title. Hint $given of 3"
    echo
    say "$given"
    mkdir -p "$(dirname "$count_file")"
    echo "$given" >"$count_file"
    echo
    [ "$given" = 3 ] || echo "More: make hint STEP=$step"
else
    echo "Step $step: $title. All three hints"
    for level in 1 2 3; do
        echo
        say "$level"
    done
    echo
    echo "There are no more. From the first again: rm $count_file"
fi
echo "In the course notes: ${chapter%.html*}, section ${chapter##*#}"
