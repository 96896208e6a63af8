#!/usr/bin/env bash
# Figures, by the commands that are printed under them. `make figures` runs it, from the checkout's root, with BUILD in the environment;
# CHAPTER=2 and FIGURE=name choose some, FORCE=1 makes them anew whatever has changed.
#
#   make_figures.sh          those whose file is missing, or whose command or sources are not those that made it
#   make_figures.sh check    all, into an empty folder, and compares with what is kept
#
# A command runs on copies, so that one that fails leaves the old figure.
set -u
kept=course_notes/figures
: "${BUILD:=build}"
stamps=$BUILD/figures/.made
mkdir -p "$stamps" || exit 2
scratch=$(mktemp -d "$BUILD/figures/.making.XXXXXX") || exit 2
trap 'rm -rf "$scratch"' EXIT
export BUILD LC_ALL=C.UTF-8 TZ=UTC

# blocks: "file<TAB>command" of every figure, in the order of the chapters.
blocks() {
    local page
    for page in course_notes/*.md; do
        pandoc -f markdown -t plain -o /dev/null --lua-filter course_notes/facts.lua "$page" || return 1
    done | awk -F '\t' -v OFS='\t' '$1 == "figure" { print $3, $7 }'
}

# A word of the command or of a script that is the name of a file is a source; so is what those name, and the C file of a helper
# program. What the preview draws is how it looks: its own sources count, too. (What photons do changes rarely, and
# `make check-figures` finds it.)
sources() {
    local file=$1 text=$2 seen=" " word path todo
    if printf '%s\n' "$text" | grep -q 'photonlab"* preview'; then seen=" $(echo lib/preview/*.c lib/preview/*/*.c) "; fi
    todo=$text
    while [ -n "$todo" ]; do
        local next=""
        for word in $(printf '%s\n' "$todo" | sed "s|\${*FIGURES}*|$kept|g; s|\${*BUILD}*|@|g" | tr -cs 'A-Za-z0-9_./@-' '\n' | sort -u); do
            for path in "$word" "$kept/src/$word" "$kept/$word" "$kept/src/${word#@/figures/}.c"; do
                [ -f "$path" ] && [ "$path" != "$kept/$file" ] || continue
                case $seen in *" $path "*) continue ;; esac
                case $path in course_notes/figures/* | scenes/* | tests/mistakes/* | tests/judge/points.txt | lib/steps/steps.def) ;; *) continue ;; esac
                seen="$seen$path "
                case $path in *.sh | *.gp | *.awk | *.c | *.h) next="$next
$(cat "$path")" ;; esac
            done
        done
        todo=$next
    done
    printf '%s\n' $seen | LC_ALL=C sort
}

# key FILE COMMAND: changes when command or sources change, or the figure itself.
key() {
    { printf '%s\n' "$2"; sources "$1" "$2" | tr '\n' '\0' | xargs -0 cksum; cksum <"$kept/$1"; } 2>/dev/null | sha256sum
}

wanted() {
    [ -z "${CHAPTER:-}" ] || [[ $1 == "$CHAPTER"* ]] || return 1
    [ -z "${FIGURE:-}" ] || [ "$1" = "$FIGURE" ] || return 1
}

up_to_date() {
    [ -z "${FORCE:-}" ] && [ -s "$kept/$1" ] && [ "$(cat "$stamps/$1" 2>/dev/null)" = "$(key "$1" "$2")" ]
}

# run FILE COMMAND FOLDER: the command must write FOLDER/FILE.
run() {
    local start=$SECONDS
    rm -f "$3/$1"
    if ! FIGURES=$3 sh -e -c "$2" >"$scratch/said" 2>&1 </dev/null; then
        echo "✗ $1: the command failed:"
    elif [ ! -s "$3/$1" ]; then
        echo "✗ $1: the command did not write \$FIGURES/$1:"
    else
        echo "  $1  $((SECONDS - start)) s"
        return 0
    fi
    sed 's/^/    /' "$scratch/said" | tail -20
    return 1
}

# What the command wrote, into its place by renaming.
keep() {
    local new name
    for new in "$1"/*; do
        name=${new##*/}
        cmp -s "$new" "$kept/$name" && continue
        cp "$new" "$kept/.$name.new" && mv "$kept/.$name.new" "$kept/$name" || return 1
    done
}

make_changed() {
    local file command made=0 left=0 wrong=0
    while IFS=$'\t' read -r file command; do
        command=$(printf '%b' "$command")
        wanted "$file" || continue
        if up_to_date "$file" "$command"; then
            left=$((left + 1))
            continue
        fi
        rm -rf "$scratch/figures" && mkdir "$scratch/figures"
        cp "$kept/${file%%_*}"_*.* "$scratch/figures/" 2>/dev/null
        if run "$file" "$command" "$scratch/figures" && keep "$scratch/figures"; then
            made=$((made + 1))
            key "$file" "$command" >"$stamps/$file"
        else
            wrong=$((wrong + 1))
        fi
    done <"$scratch/blocks"
    echo "$made figures made, $left as they were${wrong:+, $wrong failed}"
    [ "$wrong" = 0 ]
}

check_all() {
    local file command passed=0 failed=0 new name
    mkdir "$scratch/figures"
    while IFS=$'\t' read -r file command; do
        wanted "$file" || continue
        run "$file" "$(printf '%b' "$command")" "$scratch/figures" || failed=$((failed + 1))
    done <"$scratch/blocks"
    for new in "$scratch"/figures/*; do
        [ -e "$new" ] || continue
        name=${new##*/}
        if cmp -s "$new" "$kept/$name"; then
            passed=$((passed + 1))
        else
            failed=$((failed + 1))
            echo "✗ $name: other bytes than are kept"
            mkdir -p "$BUILD/figures/differs" && cp "$new" "$BUILD/figures/differs/$name"
        fi
    done
    echo "$passed passed, $failed failed"
    [ "$failed" = 0 ]
}

mkdir -p "$kept" && blocks >"$scratch/blocks" || exit 1
if [ "${1:-}" = check ]; then check_all; else make_changed; fi
