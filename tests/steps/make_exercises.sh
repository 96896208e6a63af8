#!/usr/bin/env bash
# Stubs from solutions. Usage: make_exercises.sh write|check
#
#   write   brings exercises/ and the pristine copies in exercises/.stubs/ up to what solutions/ gives. A file that somebody has
#           worked on, that is one which differs from its pristine copy, is never touched.
#   check   says in which way exercises/ is not what solutions/ gives, and builds every stub. `make check-exercises`
#           says what with.
#
# solutions/ and exercises/ are those of the folder it runs in.
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
pristine=exercises/.stubs

# generate DIRECTORY: all stubs, there.
generate() {
    local solution file name
    for solution in solutions/*/*.c; do
        file=${solution#solutions/}
        name=$(basename "$file" .c)
        mkdir -p "$1/${file%/*}"
        awk -v id="${name%%_*}" -v symbol="${name#*_}" -f "$here/stub.awk" "$solution" >"$1/$file" || return 1
    done
}

# replace NEW FILE: in one piece, so that a build beside never reads half a file.
replace() {
    mkdir -p "$(dirname "$2")" && cp "$1" "$2.new" && mv "$2.new" "$2"
}

write() {
    generate "$work/stubs" || exit 1
    local written=0 kept=0 stub file
    for stub in "$work"/stubs/*/*.c; do
        file=${stub#"$work/stubs/"}
        if cmp -s "$stub" "exercises/$file"; then
            :
        elif [ ! -e "exercises/$file" ] || cmp -s "exercises/$file" "$pristine/$file"; then
            replace "$stub" "exercises/$file" || exit 1
            written=$((written + 1))
            echo "wrote exercises/$file"
        else
            kept=$((kept + 1))
            name=$(basename "$file")
            echo "left alone: exercises/$file has been worked on; \`make reset STEP=${name%%_*}\` keeps it beside the new stub"
        fi
        cmp -s "$stub" "$pristine/$file" || replace "$stub" "$pristine/$file" || exit 1
    done
    echo "$written stubs written, $kept left alone"
}

same_file() {
    cmp -s "$1" "$2" || { echo "$2 differs; \`make exercises\` brings it up to date unless it has been worked on" && false; }
}

calls_todo_once() {
    [ "$(grep -c "^    todo(\"$2\").*; // take this line away" "$1")" = 1 ] || { echo "$1 has no line todo(\"$2\")" && false; }
}

# No line of code of what the stub leaves out, apart from words like `return true;`.
no_solution_code() {
    awk 'NR == FNR { inside = /BEGIN SOLUTION/ || (inside && !/END SOLUTION/)
                     if (inside && $0 !~ /^ *\/\//) { sub(/^ */, ""); if (length($0) >= 16) code[$0] = 1 } next }
         { line = $0; sub(/^ */, "", line); if (line in code) { print FILENAME " gives away: " line; found = 1 } }
         END { exit found }' "$1" "$2"
}

# in_row FILE PATTERN: what is said about the step beside the step table.
in_row() {
    grep -q "$2" "$1" || { echo "$1 has no row for it" && false; }
}

has_hints() {
    "$PROGRAM" steps --hint "$1" --level 3 && [ "$(grep -c '^----$' "lib/steps/hints/${2##*/}.txt")" = 2 ]
}

# build COMPILER FILE OBJECT; flags fall apart into words.
build() {
    # shellcheck disable=SC2086
    "$1" $PHOTONLAB_FLAGS -Ilib $PHOTONLAB_LINK -Werror "$2" -o "$3"
}

# What students have at once: the stub without the line that marks it. A warning about parameters is meant to come then.
builds_when_started() {
    grep -v '// take this line away when you start' "$2" >"$work/started.c"
    # shellcheck disable=SC2086
    "$1" $PHOTONLAB_FLAGS -Ilib -Werror -Wno-error=unused-parameter -Wno-error=unused-function -fsyntax-only "$work/started.c" 2>&1 |
        { ! grep -A3 'error:'; }
}

# The stub as it stands in exercises/, so that what is handed out is what is checked.
check_step() {
    local file=$1 name id cc
    name=$(basename "$file" .c)
    id=${name%%_*}
    ok "$id solution: does not call todo" not grep -nw todo "solutions/$file"
    ok "$id stub: as its solution gives it" same_file "$work/stubs/$file" "exercises/$file"
    ok "$id stub: pristine copy" same_file "$work/stubs/$file" "$pristine/$file"
    ok "$id stub: is marked as not started" calls_todo_once "exercises/$file" "$id"
    ok "$id stub: holds no line of the solution" no_solution_code "solutions/$file" "exercises/$file"
    ok "$id README: is in its stage's table" in_row "exercises/${file%/*}/README.md" "^| ${id/./\\.} |.*${file##*/}"
    ok "$id README: is in the course's table" in_row README.md "^| ${id%.*} .*[| ]${id/./\\.} "
    ok "$id README: its stage is in the exercises' table" in_row exercises/README.md "^| \[${id%.*} .*(${file%/*}/README.md)"
    ok "$id points: what it is worth" in_row tests/judge/points.txt "^step ${id/./\\.} "
    ok "$id contract: stands in its stage's header" in_row "lib/steps/${file%/*}.h" "^// ${id/./\\.}  "
    ok "$id hints: three parts" has_hints "$id" "${file%.c}"
    for cc in gcc clang; do
        mkdir -p "$work/$cc/${file%/*}"
        ok "$id stub: $cc builds it without a warning" build $cc "exercises/$file" "$work/$cc/${file%.c}.so"
    done
    ok "$id stub: builds when it is started" builds_when_started gcc "exercises/$file"
}

# All of them are found not started by the program, whoever compiled them.
check_not_started() {
    local cc id ids
    ids=$("$PROGRAM" steps | cut -f1)
    for cc in gcc clang; do
        "$PROGRAM" render scenes/box_diffuse.yaml --size 8x8 --photons 100 --samples 1 -o "$work/a.png" --code "$work/$cc" \
            >"$work/said" 2>&1 || bad "the program does not run with the stubs by $cc: $(head -1 "$work/said")"
        for id in $ids; do
            ok "$id stub: counts as not started, built by $cc" grep -q "^not started.*: .*\b$id\b" "$work/said"
        done
    done
}

check() {
    local file
    generate "$work/stubs" >"$work/said" 2>&1 || { bad "no stubs: $(cat "$work/said")"; finish; exit 1; }
    ok "as many solutions as the program has steps" \
        [ "$(ls solutions/*/*.c | wc -l)" -eq "$("$PROGRAM" steps | wc -l)" ]
    for file in exercises/*/*.c "$pristine"/*/*.c; do
        file=${file#"$pristine/"}
        file=${file#exercises/}
        [ -e "$work/stubs/$file" ] || bad "exercises/$file: no solution gives it"
    done
    for file in lib/steps/hints/*.txt; do
        [ -e "$(echo solutions/*/"$(basename "$file" .txt)".c)" ] || bad "$file: hints for no step"
    done
    for file in "$work"/stubs/*/*.c; do
        check_step "${file#"$work/stubs/"}"
    done
    check_not_started
    finish
}

case ${1:-} in
write) write ;;
check) check ;;
*) echo "usage: make_exercises.sh write|check" >&2; exit 2 ;;
esac
