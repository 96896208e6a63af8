#!/usr/bin/env bash
# Submitting, updating, a small class, the handout, the autograder. `make check-class` runs it from the checkout's root.
set -u
here=$(cd "$(dirname "$0")/.." && pwd)
root=$(cd "$here/../.." && pwd)
. "$here/../common.sh"
unset MAKEFLAGS MFLAGS MAKEOVERRIDES BUILD # a BUILD= for this checkout is none for a handout
cd "$root" || exit 1
build=$(cd "$PHOTONLAB_BUILD" && pwd)
solved=$root/solutions
turn=2_glossy_lobe/2.2_turn_to.c
export PHOTONLAB_BUILD=$build

says() { # says PATTERN FILE TEXT
    if grep -q -- "$1" "$2"; then good "$3"; else bad "$3; it said: $(head -c 600 "$2")"; fi
}

. "$here/test/handout.sh"
. "$here/test/courses.sh"
. "$here/test/gradescope.sh"

# Weights of its own: those in tests/judge/points.txt are for teachers to change.
export PHOTONLAB_POINTS=$work/points.txt
awk 'BEGIN { print "total 100\npicture 20" }
    $1 == "step" { print $1, $2, $2 == "1.1" ? 4 : $2 == "2.2" ? 5 : $2 == "3.4" ? 91 : 0 }' \
    "$root/tests/judge/points.txt" >"$PHOTONLAB_POINTS"

# ---- a class

put_step() { # put_step FOLDER: one right step, as a student lays it out
    mkdir -p "$1/2_glossy_lobe" && cp "$solved/$turn" "$1/2_glossy_lobe/"
}

# 300 MB of zeroes, packed a megabyte at a time, so that it is made at once.
make_bomb() {
    truncate -s 300M "$work/x/zeroes" && tar -cf - -C "$work/x" zeroes 2>/dev/null | head -c 512 | xz
    head -c 1M /dev/zero | xz >"$work/megabyte.xz"
    for _ in $(seq 300); do cat "$work/megabyte.xz"; done
    tar -cf - -C "$work/x" carol | xz
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
    make_bomb >"$class/bomb.tar.xz"
    echo "not one" >"$class/read me.txt"
    printf 'name,group,id\r\nalice,"1,5",s1\r\n"Bøb, ""the"" =O'"'"'Neil",2,s2\r\nzoë,3,s3\r\nDave,4,s4\r\n' \
        >"$work/roster.csv"
}

# What would be lost without a word: each of these is graded, or named.
make_odd() {
    local odd=$work/odd reflect=1_diffuse_photon_map/1.1_reflect.c
    mkdir -p "$odd/beside" "$odd/two/old" "$odd/capital" "$odd/linked" "$odd/late"
    mkdir "$odd/beside/exercises" && cp -R "$root/exercises/.stubs/1_diffuse_photon_map" "$odd/beside/exercises/"
    cp "$solved/$reflect" "$odd/beside/"
    put_step "$odd/two/exercises" && { echo "int x;" && cat "$solved/$turn"; } >"$odd/two/old/2.2_turn_to.c"
    cp "$solved/$reflect" "$odd/capital/1.1_reflect.C" && echo "int x;" >"$odd/capital/helper.c"
    mkdir -p "$odd/helped/exercises/1_diffuse_photon_map" "$odd/helped/exercises/util"
    echo 'static inline float twice(float x) { return 2.0f * x; }' >"$odd/helped/exercises/util/twice.inl"
    sed 's|#include "photonlab.h"|&\n#include "../util/twice.inl"|; s/-2.0f \* along/-twice(along)/' "$solved/$reflect" \
        >"$odd/helped/exercises/$reflect"
    put_step "$odd/linked" && echo "int emit_photon(" >"$odd/linked/1.2_emit_photon.c" && ln -s "$root/solutions/$reflect" "$odd/linked/1.1_reflect.c"
    put_step "$odd/late" && cp "$odd"/capital/1.1* "$odd/late/1.1_reflect.c"
    local loop # while these wait for ever the time is up
    for loop in 2_glossy_lobe/2.3_scatter_glossy_source_text 2_glossy_lobe/2.4_scatter_glossy_phong 3_colour_dispersion/3.1_refract; do
        sed '1i #include <poll.h>
            s/todo(.*/for (;;) poll(NULL, 0, -1);/' "$root/exercises/.stubs/$loop.c" >"$odd/late/${loop#*/}.c"
    done
    make_timeout
    put_step "$odd/new"$'\n'"line"
    echo "int x;" >"$odd/judy.c" && printf 'id;"group, or team"\ndoe;"a;b"\nnobody;1\n' >"$odd/roster.csv"
    cp "$solved/$reflect" "$odd/doe_12345_1.1_reflect.c" && cp "$solved/$turn" "$odd/doe_12346_2.2_turn_to-1.c"
}

# In timeout's place: when the time is up for "late" is not the clock's to say, which on a busy machine leaves less to be graded, but the
# two steps' that have their verdict by then.
make_timeout() {
    mkdir "$work/bin" && cat >"$work/bin/timeout" <<END && chmod +x "$work/bin/timeout"
#!/usr/bin/env bash
all="\$* "
[[ \$all == *" --report "* ]] && [ -n "\$(find . -name '3.1_refract.c')" ] || exec "$(command -v timeout)" "\$@"
report=\${all##* --report } && report=\${report%% *}
"\${@:4}" &
until grep -qs '^ "passed": 2,' "\$report/report.json"; do
    kill -0 \$! || break
    sleep 0.1
done
kill \$!
wait \$!
exit 124
END
}

check_odd() {
    make_odd
    grade_odd() {
        PATH=$work/bin:$PATH PHOTONLAB_DIR=$work/odd PHOTONLAB_OUT=$work/odd-out PHOTONLAB_SECONDS_EACH=12 \
            PHOTONLAB_SALT=pepper PHOTONLAB_ROSTER=$work/odd/roster.csv PHOTONLAB_PARALLEL_FLAGS="-j 3" \
            bash "$here/class.sh" >"$work/odd-out-said" 2>&1
    }
    grade_odd && bad "odd: exit code 0 with work that was not graded"
    holds_row beside ',graded,no,4,100,.*the empty step; yours was taken' "a started file wins over the empty one"
    holds_row two 'not graded,no,0,100,.*2.2 is started both in `exercises.*` and in `old/2.2_turn_to.c`' "which of two"
    holds_row capital ',graded,no,4,.*helper.c is not called like a step' "1.1_reflect.C; helper.c is named"
    holds_row helped ',graded,no,4,100,' "a file to include, in a folder of its own"
    holds_row linked ',graded,no,5,.*1.1_reflect.c is a link' "a link is named"
    holds_row judy 'unreadable,no,0,100,.*a file alone' "a loose file has a row"
    in_table odd-out '^doe,' '^doe,"a;b",doe,graded,yes,9,100,' "odd: files flat in the folder become a submission"
    holds_row late 'partly graded,no,9,100,.*12 s for grading ran out before [1-9]' "what was graded in time counts"
    says '1 partly graded, as 12 s ran out' "$work/odd-out-said" "odd: and is named"
    grep -q 'SALT=pepper' "$work/odd-out/.parts/.config" && grep -qa '^,,new line,graded' "$work/odd-out/class.csv" &&
        good "odd: a name of two lines" || bad "odd: $(cat "$work/odd-out-said")"
    says 'half below' "$work/odd-out/index.html" "odd: the page tells how points are spread"
    check "$(grep -o 'href="[^"]*/index.html"' "$work/odd-out/index.html" | sort -u | wc -l) == \
        $(ls "$work/odd-out/"*/index.html | grep -c '^/')" \
        "odd: it leads to every report"
    ok "odd: the report of what was graded in time" test -f "$work/odd-out/late/index.html"
    says '<td>1.2<td>it does not compile<td><a href="linked/index.html">linked</a>' "$work/odd-out/index.html" \
        "odd: how a step broke off, and whose"
    says '<b>1</b> it does not compile' "$work/odd-out/lecture.html" "odd: and in the lecture, without a name"
    grade_odd
    check_last_moment
    says '\] kept .* late' "$work/odd-out-said" "odd: what ran out of time is not paid for again"
}

# The time runs out when every step has its verdict.
check_last_moment() {
    mkdir "$work/slow" && ln -s "$build"/* "$work/slow/" && rm "$work/slow/judge"
    printf '#!/bin/sh\n"%s/judge" "$@" --build "%s"\nexit 124\n' "$build" "$build" >"$work/slow/judge" && chmod +x "$work/slow/judge"
    { cat "$work/odd-out/.parts/.config" && echo "BUILD=$work/slow REGRADE=1"; } >"$work/slow/config"
    bash "$here/grade_one.sh" "$work/slow/config" "$work/odd/capital" capital >"$work/slow/said" 2>&1
    says '^graded  4.0 points .*ran out after the last step; helper.c' "$work/slow/said" "odd: all verdicts there when the time ran out"
}

holds_row() { in_table odd-out "^,,$1," "$2" "odd: $3"; }

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
    until [ "$(finished)" -ge 2 ] || ! kill -0 "$killed" 2>/dev/null; do sleep 0.05; done
    kill -9 -- "-$killed" 2>/dev/null
    wait "$killed" 2>/dev/null
    done_before=$(finished)
    check "$done_before >= 2 && $done_before < 4" "class: killed when $done_before of 4 were graded"
    for row in "$work"/out/*/graded.json; do
        ok "class: killed, $(basename "$(dirname "$row")") is whole" grep -q '"seconds": [0-9.]*}$' "$row"
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

# in_table FOLDER ROW PATTERN TEXT: what the class's table, or that of the odd ones, says in a row.
in_table() {
    if grep -a -- "$2" "$work/$1/class.csv" | grep -q -- "$3"; then good "$4"; else
        bad "$4: $(grep -a -- "$2" "$work/$1/class.csv") $(tail -3 "$work/$1-said" 2>/dev/null)"
    fi
}

row() { in_table out "$1" "$2" "class: $3"; }

check_table() {
    check "$(grep -c . "$work/out/class.csv") == 11" "class: a header, four lines of the roster, six of others"
    [ "$(cut -d, -f1 "$work/out/class.csv" | head -5 | tr '\n' ' ')" = 'name alice "Bøb zoë Dave ' ] &&
        good "class: the roster's order" ||
        bad "class: the roster's order: $(cut -d, -f1 "$work/out/class.csv")"
    row alice '^alice,"1,5",s1,alice,graded,yes,5,100,0,5,0,' "points, by stage"
    row O.Neil '"Bøb, ""the"" =O'"'"'Neil",2,s2,"Bøb, ""the"" =O'"'"'Neil",graded,yes,5,' \
        "loose files; a name with commas and quotes"
    row zo '^zoë,3,s3,,no submission,yes,0,' "no submission, 0 points"
    row Dave '^Dave,4,s4,dave_4711_assignsubmission,graded,yes,5,' "a course system's names; a zip"
    row carol '^,,,carol,graded,no,5,' "not in the roster; the exercises in a whole photonlab"
    row '^,,,cut' ',unreadable,no,0,' "a damaged archive"
    row empty 'unreadable.*the folder is empty' "an empty folder"
    row ',link,' 'unreadable' "links and pipes are not read"
    row climber 'unreadable' "no paths that lead out"
    row bomb 'unpacks to more than 256 MB' "an archive that is a bomb"
    says 'href="alice/index.html"' "$work/out/index.html" "class: the page leads to the reports"
    says 'href="B%C3%B8b%2C%20%22the%22%20%3DO%27Neil/index.html"' "$work/out/index.html" "class: whatever the name"
    ok "class: no work left behind" not ls "$work/out/.parts/"part.* "${TMPDIR:-/tmp}/photonlab-class.$UID."*
}

# A decimal comma, and an i whose capital is another letter: neither makes a difference.
check_language() {
    local language
    mkdir -p "$work/language" && (cd "$solved/2_glossy_lobe" && zip -q "$work/language/WILLI.ZIP" 2.2*)
    for language in de_DE tr_TR; do
        localedef -i $language -f UTF-8 "$work/$language.UTF-8" 2>/dev/null ||
            { echo "○ $language is not tried: no such locale (on Debian: apt-get install locales)"; continue; }
        LOCPATH=$work LC_ALL=$language.UTF-8 make --no-print-directory -C "$root" LC_ALL=$language.UTF-8 BUILD="$build" DIR="$work/language" \
            OUT="$work/$language" class >"$work/$language-said" 2>&1
        in_table $language WILLI '^WILLI,graded,5,100,' "in $language: a class gets its points"
    done
}

case ${1:-all} in
all)
    check_odd >"$work/odd-lines" 2>&1 & # it waits most of the time
    check_handout; check_submit; check_update
    wait $!
    cat "$work/odd-lines"
    passed=$((passed + $(grep -c '^✓' "$work/odd-lines")))
    failed=$((failed + $(grep -c '^✗' "$work/odd-lines")))
    check "$(grep -c '^[✓✗]' "$work/odd-lines") == 17" "odd: all of it was tried"
    check_fewer; check_class; check_roster; check_canvas; check_moodle; check_language; check_gradescope
    ;;
odd | fewer | class | roster | canvas | moodle | language) "check_$1" ;;
gradescope) check_handout; check_submit; make_odd; check_gradescope ;;
*) check_handout; "check_$1" ;;
esac
finish
