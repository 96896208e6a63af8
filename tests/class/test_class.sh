#!/usr/bin/env bash
# Submitting, updating, a small class, the handout, the autograder. `make check-class` runs it from the checkout's root.
set -u
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
. "$here/../common.sh"
cd "$root" || exit 1
build=$(cd "$PHOTONLAB_BUILD" && pwd)
solved=$root/solutions
turn=2_glossy_lobe/2.2_turn_to.c
export PHOTONLAB_BUILD=$build

says() { # says PATTERN FILE TEXT
    if grep -q -- "$1" "$2"; then good "$3"; else bad "$3; it said: $(head -c 600 "$2")"; fi
}
holds_command() { # holds_command TEXT COMMAND…
    local text=$1
    shift
    if "$@" >/dev/null 2>&1; then good "$text"; else bad "$text"; fi
}
fails_command() {
    local text=$1
    shift
    if "$@" >/dev/null 2>&1; then bad "$text"; else good "$text"; fi
}

# ---- handout

check_handout() {
    local tree code
    PHOTONLAB_OUT=$work/handout PHOTONLAB_VERSION=1 bash "$here/handout.sh" >"$work/said" 2>&1 ||
        bad "handout: $(tail -3 "$work/said")"
    mkdir "$work/a student"
    tar -xzf "$work/handout/photonlab-1.tar.gz" -C "$work/a student" || bad "handout: its archive"
    tree="$work/a student/photonlab-1"
    (cd "$tree" && find . -type f) >"$work/files"
    fails_command "handout: no solutions, mistakes, alternatives, attacks or unit tests" \
        grep -E '^\./(solutions|tests/(alternatives|attacks|unit))/|^\./tests/mistakes/.*/|\.patch$' "$work/files"
    # Lines of code that only the solutions have; what the library says in the same words gives nothing away.
    awk '/BEGIN SOLUTION/ { inside = 1; next } /END SOLUTION/ { inside = 0 }
         inside && !/^ *\/\// { sub(/^ */, ""); sub(/ *\/\/.*/, ""); if (length($0) >= 30) print }' solutions/*/*.c |
        sort -u >"$work/lines"
    cat lib/*.[ch] lib/*/*.[ch] scenes/*.c tests/judge/*.c tests/steps/*.c >"$work/library"
    while IFS= read -r code; do grep -qF -- "$code" "$work/library" ||
        printf '%s\n' "$code"; done <"$work/lines" >"$work/own"
    check "$(wc -l <"$work/own") >= 40" "handout: $(wc -l <"$work/own") lines that only solutions have are looked for"
    fails_command "handout: holds none of them" grep -rqIF -f "$work/own" "$tree"
    fails_command "handout: no symbols or lines of source in the reference's objects" \
        grep -qE '\.(debug_|symtab)|solutions/' "$tree"/prebuilt/*/solutions/2_glossy_lobe/2.2_turn_to.so
    holds_command "handout: every stub is pristine" diff -r -x '*.md' -x '*.png' -x .stubs "$tree/exercises/.stubs" \
        "$tree/exercises"
    # Built by what is here already, newer than its sources, so that only the handout's own part is tried.
    mkdir "$tree/build" &&
        cp -R "$build/obj" "$build"/*.so "$build/photonlab" "$build/judge" "$build/write_reports" "$tree/build/" &&
        find "$tree/build" -type f -exec touch {} +
    (cd "$tree" && make all hint STEP=2.2) >"$work/said" 2>&1
    says "Hint 1 of 3" "$work/said" "handout: make all hint, in a folder with a blank in its name"
    holds_command "handout: the reference's objects are in place" test -f \
        "$tree/build/solutions/2_glossy_lobe/2.2_turn_to.so"
    cp "$tree/Makefile" "$work/Makefile"
    mv "$tree"/prebuilt/*-* "$tree/prebuilt/sparc-Multics"
    (cd "$tree" && make all) >"$work/said" 2>&1 && bad "handout: builds on another machine"
    says "built for: sparc Multics" "$work/said" "handout: on another machine it says what the reference was built for"
}

# ---- submit, in the handout

check_submit() {
    local tree="$work/a student/photonlab-1" archive
    export PHOTONLAB_NAME="Zoë/O'Neil"
    (cd "$tree" && PHOTONLAB_BUILD=build bash tests/class/submit.sh) >"$work/said" 2>&1
    says "started:     none" "$work/said" "submit: nothing is started in a handout"
    cp "$solved/$turn" "$tree/exercises/$turn"
    echo "int reflect(" >"$tree/exercises/1_diffuse_photon_map/1.1_reflect.c"
    sed 's/todo(/ todo(/' "$tree/exercises/3_colour_dispersion/3.2_fresnel.c" >"$work/touched"
    cp "$work/touched" "$tree/exercises/3_colour_dispersion/3.2_fresnel.c"
    echo junk >"$tree/exercises/2_glossy_lobe/notes.o"
    ln -s /etc/passwd "$tree/exercises/2_glossy_lobe/link.h"
    rm -rf "$tree/build/submit"
    (cd "$tree" && PHOTONLAB_BUILD=build bash tests/class/submit.sh) >"$work/said" 2>&1 &&
        bad "submit: takes what does not compile"
    says "1.1_reflect.c:1:" "$work/said" "submit: shows the compiler's lines"
    says "3.2 still calls todo" "$work/said" "submit: says that a step still counts as not started"
    fails_command "submit: no archive of what does not compile" ls "$tree/build/submit/"*
    (cd "$tree" && PHOTONLAB_BUILD=build PHOTONLAB_FORCE=1 bash tests/class/submit.sh) >"$work/said" 2>&1
    archive=$(ls "$tree"/build/submit/*.tar.gz)
    says "15 files, 2 steps started" "$work/said" "submit: FORCE=1 takes it, and counts"
    check "$(tar -tzf "$archive" | grep -cvE '^exercises/[123]_[a-z_]*/[123]\.[1-6]_[a-z_]*\.c$') == 0" \
        "submit: nothing but C files in it"
    cp "$archive" "$work/first" && sleep 1 && touch "$tree"/exercises/*/*.c
    (cd "$tree" && PHOTONLAB_BUILD=build PHOTONLAB_FORCE=1 bash tests/class/submit.sh) >/dev/null 2>&1
    holds_command "submit: the same files, the same bytes" cmp "$archive" "$work/first"
    unset PHOTONLAB_NAME
}

# ---- update, of the same handout

manifest() {
    (cd "$1" && find . -type f ! -name .photonlab-files | sed 's|^\./||' | LC_ALL=C sort | tr '\n' '\0' |
        xargs -0 sha256sum >.photonlab-files)
}

check_update() {
    local tree="$work/a student/photonlab-1" new=$work/new/photonlab-2 file
    rm -rf "$tree" && tar -xzf "$work/handout/photonlab-1.tar.gz" -C "$work/a student"
    mkdir "$work/new" && tar -xzf "$work/handout/photonlab-1.tar.gz" -C "$work/new" && mv "$work/new/photonlab-1" "$new"
    for file in .stubs/$turn $turn .stubs/1_diffuse_photon_map/1.1_reflect.c 1_diffuse_photon_map/1.1_reflect.c; do
        echo "// new words" >>"$new/exercises/$file"
    done
    echo "# new" >>"$new/Makefile"
    echo "new" >"$new/scenes/new.yaml"
    rm "$new/scenes/diamond.yaml"
    manifest "$new"
    cp "$solved/$turn" "$tree/exercises/$turn"
    cp "$solved/2_glossy_lobe/2.1_sample_lobe.c" "$tree/exercises/2_glossy_lobe/"
    echo mine >"$tree/my notes.txt"
    echo "# mine" >>"$tree/scenes/prism.yaml"
    (cd "$work" && tar -czf "$work/new.tar.gz" -C new photonlab-2)
    cp -R "$tree" "$work/before"

    mkdir "$work/other" && echo hello >"$work/other/Makefile" && echo hello >"$work/other.tar.gz"
    for file in "$work/other" "$work/other.tar.gz" "$work/nothing" ""; do
        fails_command "update: refuses FROM=${file##*/}" env PHOTONLAB_FROM="$file" bash "$tree/tests/class/update.sh"
    done
    holds_command "update: a refusal changes nothing" diff -r "$work/before" "$tree"

    PHOTONLAB_FROM=$work/new.tar.gz bash "$tree/tests/class/update.sh" >"$work/said" 2>&1 ||
        bad "update: $(cat "$work/said")"
    holds_command "update: a started file stays" cmp "$solved/$turn" "$tree/exercises/$turn"
    holds_command "update: its changed stub is put beside" cmp "$new/exercises/$turn" "$tree/exercises/$turn.new-stub"
    fails_command "update: an unchanged one is not" ls "$tree/exercises/2_glossy_lobe/2.1_sample_lobe.c.new-stub"
    holds_command "update: a stub that was not started is replaced" grep -q "new words" \
        "$tree/exercises/1_diffuse_photon_map/1.1_reflect.c"
    holds_command "update: the framework is replaced" cmp "$new/Makefile" "$tree/Makefile"
    holds_command "update: what came new is there" cmp "$new/scenes/new.yaml" "$tree/scenes/new.yaml"
    fails_command "update: what is no more is gone" ls "$tree/scenes/diamond.yaml"
    holds_command "update: the student's own files stay" grep -q mine "$tree/my notes.txt"
    holds_command "update: a file of the framework that the student changed is kept" grep -q mine \
        "$tree/before-update-1/scenes/prism.yaml"
    says "yours, left alone: exercises/$turn" "$work/said" "update: tells what it left alone"

    # Cut off in the middle of the switch: the list is there, half of it is done.
    rm -rf "$tree" && cp -R "$work/before" "$tree"
    sed 's/^mv "$room\/plan" "$room\/switch"$/&; rm -rf "$room\/ready.all"; cp -R "$room\/ready" "$room\/ready.all"; mv "$room\/ready\/Makefile" Makefile; exit 9/' \
        "$tree/tests/class/update.sh" >"$work/cut.sh" && cp "$work/cut.sh" "$tree/tests/class/cut.sh"
    PHOTONLAB_FROM=$work/new.tar.gz bash "$tree/tests/class/cut.sh" >/dev/null 2>&1
    check "$? == 9" "update: can be cut off in its switch"
    bash "$tree/tests/class/update.sh" >"$work/said" 2>&1
    rm "$tree/tests/class/cut.sh"
    holds_command "update: the next one finishes the one that was cut off" cmp "$new/scenes/new.yaml" \
        "$tree/scenes/new.yaml"
    fails_command "update: and leaves no trace" ls -d "$tree/.update"
}

# ---- a class

put_step() { # put_step FOLDER: one right step, as a student lays it out
    mkdir -p "$1/2_glossy_lobe" && cp "$solved/$turn" "$1/2_glossy_lobe/"
}

make_class() {
    local class=$work/class
    mkdir -p "$class" "$work/x"
    put_step "$class/alice/exercises"
    mkdir -p "$class/Bøb, \"the\" =O'Neil" && cp "$solved/$turn" "$class/Bøb, \"the\" =O'Neil/"
    put_step "$work/x/carol/photonlab/exercises" && put_step "$work/x/carol/photonlab/tests/alternatives/x" &&
        mkdir "$work/x/carol/__MACOSX" && cp "$solved/$turn" "$work/x/carol/__MACOSX/._2.2_turn_to.c"
    tar -czf "$class/carol.tar.gz" -C "$work/x" carol
    put_step "$work/x/dave" && (cd "$work/x/dave" && zip -qr "$class/dave_4711_assignsubmission.zip" .)
    head -c 200 "$class/carol.tar.gz" >"$class/cut.tgz"
    mkdir "$class/empty" "$class/link" && ln -s /etc/passwd "$class/link/2.2_turn_to.c" &&
        mkfifo "$class/link/1.1_reflect.c"
    mkdir -p "$work/x/up/a/b" && cp "$solved/$turn" "$work/x/up/2.2_turn_to.c"
    (cd "$work/x/up/a/b" && tar -cPf "$class/climber.tar" ../../2.2_turn_to.c)
    mkdir "$work/x/bomb" && truncate -s 300M "$work/x/bomb/zeroes" && put_step "$work/x/bomb/exercises" &&
        tar -cJf "$class/bomb.tar.xz" -C "$work/x" bomb
    echo "not one" >"$class/read me.txt"
    printf 'name,group,id\r\nalice,"1,5",s1\r\n"Bøb, ""the"" =O'"'"'Neil",2,s2\r\nzoë,3,s3\r\nDave,4,s4\r\n' \
        >"$work/roster.csv"
}

start_class() {
    PHOTONLAB_DIR=$work/class PHOTONLAB_ROSTER=$work/roster.csv PHOTONLAB_OUT=$work/out \
        PHOTONLAB_PARALLEL_FLAGS="-j 2" exec "$@" bash "$here/class.sh"
}

finished() { cat "$work"/out/*/graded.json 2>/dev/null | grep -c '"status": "graded"'; }

check_class() {
    local killed done_before row
    make_class
    (start_class setsid) >/dev/null 2>&1 &
    killed=$!
    for _ in $(seq 200); do [ "$(finished)" -ge 2 ] && break; sleep 0.05; done
    kill -9 -- "-$killed" 2>/dev/null
    wait "$killed" 2>/dev/null
    done_before=$(finished)
    check "$done_before >= 2 && $done_before < 4" "class: killed when $done_before of 4 were graded"
    for row in "$work"/out/*/graded.json; do
        holds_command "class: killed, $(basename "$(dirname "$row")") is whole" grep -q '"seconds": [0-9.]*}$' "$row"
    done
    (start_class env) >"$work/said" 2>&1 || bad "class: $(tail -5 "$work/said")"
    # GNU parallel gives its jobs groups of their own: one may have come to its end after the kill.
    check "$(grep -c '\] kept' "$work/said") >= $done_before" "class: started again, it keeps those"
    says "9 submissions, 9 with a result, 0 not graded" "$work/said" "class: all get a result"
    says "not submissions: read me.txt" "$work/said" "class: what is no submission is named"
    (start_class env) >"$work/said" 2>&1
    check "$(grep -c '\] kept' "$work/said") == 4" "class: a third time there is nothing to do"
    echo "// changed" >>"$work/class/alice/exercises/$turn"
    (start_class env) >"$work/said" 2>&1
    says "\] graded .* alice" "$work/said" "class: a changed submission is graded again"
    check "$(grep -c '\] kept' "$work/said") == 3" "class: and no other"
    check_table
}

row_of() { grep -a -- "$1" "$work/out/class.csv"; }

check_table() {
    check "$(grep -c . "$work/out/class.csv") == 11" "class: a header, four lines of the roster, six of others"
    [ "$(cut -d, -f1 "$work/out/class.csv" | head -5 | tr '\n' ' ')" = 'name alice "Bøb zoë Dave ' ] &&
        good "class: the roster's order" ||
        bad "class: the roster's order: $(cut -d, -f1 "$work/out/class.csv")"
    row_of alice | grep -q '^alice,"1,5",s1,alice,graded,yes,5,100,0,5,0,' && good "class: points, by stage" ||
        bad "class: $(row_of alice)"
    row_of O.Neil | grep -qF '"Bøb, ""the"" =O'"'"'Neil",2,s2,"Bøb, ""the"" =O'"'"'Neil",graded,yes,5,' &&
        good "class: loose files; a name with commas and quotes" ||
        bad "class: $(row_of O.Neil)"
    row_of zo | grep -q '^zoë,3,s3,,no submission,yes,0,' && good "class: no submission, 0 points" ||
        bad "class: $(row_of zo)"
    row_of Dave | grep -q '^Dave,4,s4,dave_4711_assignsubmission,graded,yes,5,' &&
        good "class: a course system's names; a zip" || bad "class: $(row_of Dave)"
    row_of carol | grep -q '^,,,carol,graded,no,5,' &&
        good "class: not in the roster; the exercises in a whole photonlab" || bad "class: $(row_of carol)"
    row_of '^,,,cut' | grep -q ',unreadable,no,0,' && good "class: a damaged archive" || bad "class: $(row_of cut)"
    row_of empty | grep -q 'unreadable.*the folder is empty' && good "class: an empty folder" ||
        bad "class: $(row_of empty)"
    row_of ',link,' | grep -q 'unreadable' && good "class: links and pipes are not read" ||
        bad "class: $(row_of ',link,')"
    row_of climber | grep -q 'unreadable' && good "class: no paths that lead out" || bad "class: $(row_of climber)"
    row_of bomb | grep -q 'unpacks to more than 256 MB' && good "class: an archive that is a bomb" ||
        bad "class: $(row_of bomb)"
    says 'href="alice/index.html"' "$work/out/index.html" "class: the page leads to the reports"
    says 'href="B%C3%B8b%2C%20%22the%22%20%3DO%27Neil/index.html"' "$work/out/index.html" "class: whatever the name"
    fails_command "class: no work left behind" ls "$work/out/.parts/"part.* "${TMPDIR:-/tmp}/photonlab-class.$UID."*
}

# ---- Gradescope

check_gradescope() {
    local place=$work/autograder
    PHOTONLAB_OUT=$work/gradescope bash "$here/gradescope.sh" >"$work/said" 2>&1 ||
        bad "gradescope: $(cat "$work/said")"
    mkdir -p "$place/source" "$place/submission"
    (cd "$place/source" && unzip -q "$work/gradescope/autograder.zip")
    holds_command "gradescope: both scripts at the root, executable" test -x "$place/source/setup.sh" -a -x \
        "$place/source/run_autograder"
    mkdir "$place/source/photonlab/build" &&
        cp -R "$build/obj" "$build"/*.so "$build/photonlab" "$build/judge" "$build"/class_* \
        "$build/write_reports" "$build/solutions" "$place/source/photonlab/build/" &&
            find "$place/source/photonlab/build" -type f -exec touch {} +
    cp "$root"/scenes/meshes/*.obj "$place/source/photonlab/scenes/meshes/" &&
        touch "$place/source/photonlab/scenes/meshes/"*
    AUTOGRADER_ROOT=$place NO_PACKAGES=1 "$place/source/setup.sh" >"$work/said" 2>&1 ||
        bad "gradescope: setup.sh: $(tail -5 "$work/said")"
    check "$(find "$place/source/photonlab/solutions" -perm /077 | wc -l) == 0" \
        "gradescope: solutions are for root alone"
    autograde() { AUTOGRADER_ROOT=$place "$@" "$place/source/run_autograder" >"$work/said" 2>&1; }
    points() { sed -n 's/.*"score": *\([0-9.]*\).*/\1/p' "$place/results/results.json" |
        awk '{ sum += $1 } END { print sum + 0 }'; }

    autograde env
    says '"score": 0, "output": "Your submission cannot be graded: the folder is empty"' \
        "$place/results/results.json" "gradescope: nothing handed in"
    cp "$solved/$turn" "$place/submission/"
    autograde env
    check "$(points) == 5" "gradescope: a loose file gets its points"
    rm "$place/submission/"* && cp "$work/first" "$place/submission/mine.tar.gz"
    autograde env
    check "$(points) == 5" "gradescope: an archive by make submit, too"
    says '2.2 Turn' "$place/results/results.json" "gradescope: its results name the steps"
    rm -f "$place/results/results.json"
    (autograde exec setsid) 2>/dev/null &
    for _ in $(seq 100); do [ -s "$place/results/results.json" ] && break; sleep 0.02; done
    kill -9 -- "-$!" 2>/dev/null
    wait $! 2>/dev/null
    says '"score": 0, "output": "Grading did not come to its end' "$place/results/results.json" \
        "gradescope: killed, it leaves no points, and a valid file"
}

case ${1:-all} in
all) check_handout; check_submit; check_update; check_class; check_gradescope ;;
*) check_handout; "check_$1" ;;
esac
finish
