# Handout, submit, update. To be sourced by class.sh, which has the rest.

# ---- handout

# Every `make TARGET` and every path in backquotes that its pages tell of, whatever they are relative to.
names_only_what_is_there() {
    (cd "$1" && make help && find . -name '*.md' -exec cat {} +) | grep -oE '(`|^    |^  )make [a-z][a-z-]*' | sed 's/.*make //' |
        sort -u >"$work/named"
    { echo setup:; cd "$1" && make -pRrq : 2>/dev/null; } | sed -n 's/^\([a-z][a-z-]*\):.*/\1/p' | sort -u |
        comm -13 - "$work/named" >"$work/said"
    (cd "$1" && find . -name '*.md' | while IFS= read -r file; do
        grep -v '^    ' "$file" | grep -oE '`[A-Za-z0-9_.*-]+/[A-Za-z0-9_./*-]+`' | tr -d '`' | grep -v '^build/' | sort -u |
            while IFS= read -r path; do
                # shellcheck disable=SC2086  # a path may have a *
                ls -d $path "${file%/*}"/$path lib/$path tests/$path 2>/dev/null | grep -q . || echo "$file: $path"
            done
    done) >>"$work/said"
    [ ! -s "$work/said" ] && good "handout: its pages name $(wc -l <"$work/named") targets and paths, all of which are there" ||
        bad "handout: its pages name what is not there: $(cat "$work/said")"
}

has_no_dead_links() {
    (cd "$1" && find . -name '*.md' | while IFS= read -r file; do
        grep -o '](\([^)#:]*\))' "$file" | sed 's/^](//; s/)$//' | while IFS= read -r link; do
            page=${file%/*}/$link # a chapter links to another's page, which its Markdown becomes
            [ -e "$page" ] || [ -e "${page%.html}.md" ] || echo "$file: $link"; done; done
        sed -n 's/^## .*{\(#[^} ]*\).*/\1/p; s/^::::* {[^#]*\(#[^} ]*\).*/\1/p' course_notes/gallery.md | sort -u >"$work/tiles"
        cat course_notes/*.md | tr '\n' ' ' | grep -oE '\]\((gallery.html)?#(m|step)-[^)]*' | sed 's/.*#/#/' | sort -u | comm -13 "$work/tiles" -) >"$work/said"
    [ ! -s "$work/said" ] && good "handout: no dead links" || bad "handout: dead links: $(cat "$work/said")"
}

check_handout() {
    local tree
    PHOTONLAB_OUT=$work/handout PHOTONLAB_VERSION=1 bash "$here/handout.sh" >"$work/said" 2>&1 ||
        bad "handout: $(tail -3 "$work/said")"
    mkdir "$work/a student's"
    tar -xzf "$work/handout/photonlab-1.tar.gz" -C "$work/a student's" || bad "handout: its archive"
    tree="$work/a student's/photonlab-1"
    (cd "$tree" && find . -type f) >"$work/files"
    ok "handout: no solutions, mistakes, alternatives, attacks or unit tests" \
        not grep -E '^\./(solutions|tests/(alternatives|attacks|unit))/|^\./tests/mistakes/.*/|\.patch$' "$work/files"
    check "$(grep -cE '^\./(\.vscode/tasks\.json|\.devcontainer/Dockerfile)$' "$work/files") == 2" "handout: tasks for an editor, and a container"
    # Lines of code that only the solutions have; what the library says in the same words gives nothing away.
    awk '/BEGIN SOLUTION/ { inside = 1; next } /END SOLUTION/ { inside = 0 }
         inside && !/^ *\/\// { sub(/^ */, ""); sub(/ *\/\/.*/, ""); if (length($0) >= 30) print }' solutions/*/*.c |
        sort -u >"$work/lines"
    find lib scenes tests/judge tests/steps \( -name '*.[ch]' -o -path 'lib/steps/hints/*' \) -exec cat {} + >"$work/library"
    awk 'BEGIN { RS = "\001" } NR == 1 { library = $0; RS = "\n"; next } !index(library, $0)' "$work/library" "$work/lines" >"$work/own"
    check "$(wc -l <"$work/own") >= 40" "handout: $(wc -l <"$work/own") lines that only solutions have are looked for"
    ok "handout: holds none of them" not grep -rqIF -f "$work/own" "$tree"
    ok "handout: no symbols or lines of source in the reference's objects" \
        not grep -qE '\.(debug_|symtab)|solutions/' "$tree"/prebuilt/*/solutions/2_glossy_lobe/2.2_turn_to.so
    ok "handout: every stub is pristine" diff -r -x '*.md' -x '*.png' -x .stubs "$tree/exercises/.stubs" \
        "$tree/exercises"
    ok "handout: its README names no solutions, and no tests that are not there" \
        not grep -qE 'solutions/|CODE=solutions|setup check' "$tree/README.md"
    ok "handout: nothing for teachers alone in its README" not grep -qi "teacher\|make class" "$tree/README.md"
    has_no_dead_links "$tree"
    names_only_what_is_there "$tree"
    (cd "$tree" && make help) >"$work/help" 2>&1
    says "  test  .*grade your work" "$work/help" "handout: make help lists what students do"
    ok "handout: and nothing else" \
        not grep -E '^  +(check|class|bench|exercises|calibrate|handout|gradescope|fuzz|mistakes)' "$work/help"
    # Built by what is here already, newer than its sources, so that only the handout's own part is tried.
    mkdir "$tree/build" &&
        cp -R "$build/obj" "$build"/*.so "$build/photonlab" "$build/probe" "$build/judge" "$build/write_reports" "$tree/build/" &&
        find "$tree/build" -type f -exec touch {} +
    (cd "$tree" && make all hint STEP=2.2) >"$work/said" 2>&1
    says "Hint 1 of 3" "$work/said" "handout: make all hint, in a folder with a blank in its name"
    mkdir -p "$work/it's mine/2_glossy_lobe" && cp "$solved/$turn" "$work/it's mine/2_glossy_lobe/"
    (cd "$tree" && make code-built CODE="$work/it's mine") >"$work/said" 2>&1
    ok "handout: CODE= with an apostrophe, in a folder with one" ls "$tree"/build/code/*/"${turn%.c}.so"
    ok "handout: the reference's objects are in place" test -f \
        "$tree/build/solutions/2_glossy_lobe/2.2_turn_to.so"
    if bwrap --ro-bind / / true 2>/dev/null; then
        (cd "$tree" && bwrap --ro-bind / / --dev /dev --bind "$tree/build" "$tree/build" make render FLAGS="--size 8x8 --photons 99 --samples 1") >"$work/said" 2>&1
        says "8×8, 99 photons" "$work/said" "handout: renders where nothing but BUILD can be written"
    fi
    printf '#!/bin/sh\necho half >"$2"\nexit 1\n' >"$tree/build/make_meshes" && chmod +x "$tree/build/make_meshes"
    (cd "$tree" && make meshes) >"$work/said" 2>&1
    ok "handout: a mesh that is half made is none" not ls "$tree"/scenes/meshes/diamond.obj*
    rm "$tree/build/make_meshes"
    cp "$tree/Makefile" "$work/Makefile"
    mv "$tree"/prebuilt/*-* "$tree/prebuilt/sparc-Multics"
    (cd "$tree" && make all) >"$work/said" 2>&1 && bad "handout: builds on another machine"
    says "built for: sparc Multics" "$work/said" "handout: on another machine it says what the reference was built for"
}

# A course of three stages, by one line in points.txt: for its students there are no others.
check_fewer() {
    local tree=$work/photonlab-three judge
    { cat "$root/tests/judge/points.txt"; echo "stages 3"; } >"$work/three.txt"
    PHOTONLAB_POINTS=$work/three.txt PHOTONLAB_OUT=$work/three PHOTONLAB_VERSION=three bash "$here/handout.sh" >"$work/said" 2>&1
    says "stages 1 to 3, " "$work/said" "fewer: which stages there are"
    tar -xzf "$work/three/photonlab-three.tar.gz" -C "$work" || bad "fewer: its archive"
    ok "fewer: no step, hint or wrong picture of the others" not ls -d "$tree"/exercises/[4-9]* "$tree"/exercises/.stubs/[4-9]* \
        "$tree"/lib/steps/hints/[4-9]* "$tree"/course_notes/figures/gallery_[4-9]_*
    ok "fewer: no row of theirs in its lists, no tile in the gallery" not grep -rnE '^\| \[?[4-9][ .]|#(m|step)-[4-9]' \
        "$tree/README.md" "$tree/exercises" "$tree/course_notes" --include='*.md' --exclude=notation.md
    check "$(grep -l 'Your course ends with stage 3' "$tree"/course_notes/*.md | wc -l) == 3" "fewer: their chapters say that they are to be read"
    has_no_dead_links "$tree"
    (cd "$tree" && make -pRrq : 2>/dev/null) | grep -E '^STAGES :?= ' >"$work/said"
    says '= 3$' "$work/said" "fewer: the preview's panel has three stages"
    judge=("$build/judge" --build "$build" --work "$work/test" --root "$tree" --points "$tree/tests/judge/points.txt")
    (cd "$tree" && "${judge[@]}"; "${judge[@]}" --step 4.1; sh tests/steps/hint.sh - 4.1 build; PHOTONLAB_BUILD=build bash tests/class/submit.sh) >"$work/said" 2>&1
    says '^0 of 100 points' "$work/said" "fewer: three stages are all points"
    says '^15 not started' "$work/said" "fewer: and all steps that the judge lists"
    says 'the course has no step .* 3.5, and stages 1 to 3' "$work/said" "fewer: it says so to whoever asks for another"
    says 'there is no step `4.1`' "$work/said" "fewer: so does a hint"
    says '^not started: .* 3.5$' "$work/said" "fewer: submit lists no others"
    { echo '#include "photonlab.h"'; sed -n '/^Vec3 reflect/,/^}/p' course_notes/0_start_here.md; } >"$tree/exercises/1_diffuse_photon_map/1.1_reflect.c"
    (cd "$tree" && "${judge[@]}" --step 1.1) 2>&1 | sed '/^── The code could read/,/^$/d' | sed '1{/^$/d;}; s/ *$//' >"$work/said"
    grep -v '^make: ' "$tree/course_notes/figures/0_first.txt" | diff - "$work/said" >"$work/differs" &&
        good "fewer: chapter 0 shows what the terminal says there" || bad "fewer: chapter 0 shows something else: $(cat "$work/differs")"
    mkdir -p "$work/fewer/ada" && cp "$solved/$turn" "$solved"/*/6.1_* "$work/fewer/ada/"
    grade fewer PHOTONLAB_POINTS="$work/three.txt"
    says "stage_3,1.1,.*,3.5,passed," "$work/fewer-out/class.csv" "fewer: the class has no others"
    in_table fewer-out ada '^ada,graded,5,100,.*,1,0,0,14,' "fewer: what is handed in of others counts for nothing"
}

# ---- submit, in the handout

check_submit() {
    local tree="$work/a student's/photonlab-1" archive
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
    ok "submit: no archive of what does not compile" not ls "$tree/build/submit/"*
    (cd "$tree" && PHOTONLAB_BUILD=build PHOTONLAB_FORCE=1 bash tests/class/submit.sh) >"$work/said" 2>&1
    says '^[0-9.]* of [0-9.]* points' "$work/said" "submit: and says what it gets"
    archive=$(ls "$tree"/build/submit/*.tar.gz)
    says "$(find "$root/exercises/.stubs" -name '*.c' | wc -l) files, 2 steps started" "$work/said" "submit: FORCE=1 takes it, and counts"
    check "$(tar -tzf "$archive" | grep -cvE '^exercises/[1-9]_[a-z_]*/[1-9]\.[1-9][0-9]*_[a-z_]*\.c$') == 0" \
        "submit: nothing but C files in it"
    cp "$archive" "$work/first" && sleep 1 && touch "$tree"/exercises/*/*.c
    (cd "$tree" && PHOTONLAB_BUILD=build PHOTONLAB_FORCE=1 bash tests/class/submit.sh) >/dev/null 2>&1
    ok "submit: the same files, the same bytes" cmp "$archive" "$work/first"
    unset PHOTONLAB_NAME
    # The finale by a judge to whom all is right, and a program that says what it is asked to draw.
    printf '#!/bin/sh\necho "$@" >&2\n' >"$tree/build/photonlab"
    (cd "$tree" && PHOTONLAB_BUILD=build PHOTONLAB_PLAYED=x PHOTONLAB_SIDE=8 bash tests/judge/finale.sh echo '5 of 5 points') >"$work/said" 2>&1
    says "^frame [^ ]*/colours.png -o .* --title Zoë_O'Neil " "$work/said" "submit: the finale's frame has the name from it, and one picture where the course has no wavelengths"
}

# ---- update, of the same handout

manifest() {
    (cd "$1" && find . -type f ! -name .photonlab-files | sed 's|^\./||' | LC_ALL=C sort | tr '\n' '\0' |
        xargs -0 sha256sum >.photonlab-files)
}

check_update() {
    local tree="$work/a student's/photonlab-1" new=$work/new/photonlab-2 file
    rm -rf "$tree" && tar -xzf "$work/handout/photonlab-1.tar.gz" -C "$work/a student's"
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
        ok "update: refuses FROM=${file##*/}" not env PHOTONLAB_FROM="$file" bash "$tree/tests/class/update.sh"
    done
    ok "update: a refusal changes nothing" diff -r "$work/before" "$tree"

    PHOTONLAB_FROM=$work/new.tar.gz bash "$tree/tests/class/update.sh" >"$work/said" 2>&1 ||
        bad "update: $(cat "$work/said")"
    ok "update: a started file stays" cmp "$solved/$turn" "$tree/exercises/$turn"
    ok "update: its changed stub is put beside" cmp "$new/exercises/$turn" "$tree/exercises/$turn.new-stub"
    ok "update: an unchanged one is not" not ls "$tree/exercises/2_glossy_lobe/2.1_sample_lobe.c.new-stub"
    ok "update: a stub that was not started is replaced" grep -q "new words" \
        "$tree/exercises/1_diffuse_photon_map/1.1_reflect.c"
    ok "update: the framework is replaced" cmp "$new/Makefile" "$tree/Makefile"
    ok "update: what came new is there" cmp "$new/scenes/new.yaml" "$tree/scenes/new.yaml"
    ok "update: what is no more is gone" not ls "$tree/scenes/diamond.yaml"
    ok "update: the student's own files stay" grep -q mine "$tree/my notes.txt"
    ok "update: a file of the framework that the student changed is kept" grep -q mine \
        "$tree/before-update-1/scenes/prism.yaml"
    says "yours, left alone: exercises/$turn" "$work/said" "update: tells what it left alone"

    # Cut off when one file has been moved.
    rm -rf "$tree" && cp -R "$work/before" "$tree"
    sed 's/^ *replaced=.*+ 1))$/exit 9/' "$tree/tests/class/update.sh" >"$work/cut.sh" && cp "$work/cut.sh" "$tree/tests/class/cut.sh"
    PHOTONLAB_FROM=$work/new.tar.gz bash "$tree/tests/class/cut.sh" >/dev/null 2>&1
    check "$? == 9" "update: can be cut off"
    bash "$tree/tests/class/update.sh" >"$work/said" 2>&1
    rm "$tree/tests/class/cut.sh"
    ok "update: the next one finishes the one that was cut off" cmp "$new/scenes/new.yaml" \
        "$tree/scenes/new.yaml"
    ok "update: and leaves no trace" not ls -d "$tree/.update"
}
