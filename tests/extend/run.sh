#!/usr/bin/env bash
# What a new thing costs: how many existing files it touches, that it works, and that each place that is left out is an error
# which names it. Usage: run.sh [stage|material|view|key …]   (all four), in a scratch copy of the checkout.
#
# A trial is a folder with the files that it adds in new/, and trial.sh, which says
#     most=3                          existing files that it may touch
#     place FILE MARK TEXT SAID       puts TEXT behind the first line that holds MARK; without it, SAID is said
#     written FILE TARGET SAID        FILE as `make TARGET` writes it
#     added FILE SAID                 a file of new/, and what is said without it
#     try()                           builds and uses it; false, with the reason, when something is amiss
set -u
cd "$(dirname "$0")/../.." || exit 2
. tests/common.sh
unset MAKEFLAGS MFLAGS MAKEOVERRIDES MAKELEVEL # or its makes would wait for a job of the one that started it
trials=$PWD/tests/extend
tree=$work/tree
mkdir "$tree"
git ls-files -co --exclude-standard -z | xargs -0 cp --parents -t "$tree" 2>/dev/null
cd "$tree" || exit 2
git init -q && git add -A && git -c user.name=trial -c user.email=trial commit -qm "as it was" || exit 2

ccache=$(command -v ccache)
build() {
    make -s OPTIMISE=-O0 CC="${ccache:+ccache }gcc" say=@: "$@" 2>&1
}

# In apply's hands, each call is a place of its own; number $without is left out, and what should be said kept.
leave_out() { # FILE SAID: is it this place's turn?
    places=$((places + 1))
    [ "$places" = "$without" ] && left_out=$1 said=$2
}

place() {
    if leave_out "$1: ${3%%$'\n'*}" "$4"; then return; fi
    text=$3 awk -v mark="$2" '{ print } !done && index($0, mark) { print ENVIRON["text"]; done = 1 } END { exit !done }' "$1" >place.new ||
        echo "no line of $1 holds $2" >>apply.errors
    cat place.new >"$1"
    rm place.new
}

added() {
    if leave_out "$1" "$2"; then rm "$1"; fi
}

written() {
    leave_out "$1" "$3" || build "$2" >/dev/null
}

# apply TRIAL WITHOUT: the trial's places, but for one
apply() {
    git checkout -q . && git clean -fdq
    places=0 without=$2 said="" left_out=""
    [ ! -d "$trials/$1/new" ] || cp -r "$trials/$1/new/." .
    . "$trials/$1/trial.sh"
    [ ! -s apply.errors ] || { cat apply.errors; return 1; }
}

trial() {
    local touched what i all
    apply "$1" 0 || { bad "$1: does not apply"; return; }
    touched=$(git diff --name-only | wc -l)
    all=$places
    if [ "$touched" -le "$most" ]; then good "a toy $1 touches $touched existing files (at most $most)"
    else bad "a toy $1 touches $touched existing files, at most $most: $(git diff --name-only | tr '\n' ' ')"; fi
    if what=$(try); then good "the toy $1 works"; else bad "the toy $1: $(grep -v '^✓' <<<"$what" | tail -5)"; fi
    for ((i = 1; i <= all; i++)); do
        apply "$1" $i
        if what=$(try); then
            bad "a toy $1 without $left_out: goes unnoticed"
        elif what=$(grep -v '^✓' <<<"$what") && grep -qF -- "$said" <<<"$what"; then
            good "a toy $1 without $left_out: $(grep -F -m 1 -- "$said" <<<"$what" | cut -c1-150)"
        else
            bad "a toy $1 without $left_out: said is $(tail -3 <<<"$what"), expected $said"
        fi
    done
}

for name in ${*:-key view material stage}; do trial "$name"; done
finish
