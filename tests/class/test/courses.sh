# What course systems hand out and take in; lateness; parts of a class. To be sourced by class.sh.

reflect=1_diffuse_photon_map/1.1_reflect.c

# grade FOLDER NAME=VALUE…: a class of $work/FOLDER, its output beside.
grade() {
    local class=$1
    shift
    env PHOTONLAB_DIR="$work/$class" PHOTONLAB_OUT="$work/$class-out" PHOTONLAB_PARALLEL_FLAGS="-j 2" "$@" \
        bash "$here/class.sh" >"$work/$class-out-said" 2>&1
}

same_file() { # same_file GOT TEXT, what is expected comes in
    if diff - "$1" >"$work/differs"; then good "$2"; else bad "$2: $(cat "$work/differs")"; fi
}

# Files flat in a folder: the gradebook's ID stands in their names, "LATE" where it was; two are called the same.
check_canvas() {
    local in=$work/canvas
    mkdir -p "$in" "$work/x/roe" && put_step "$work/x/roe/exercises"
    cp "$solved/$reflect" "$in/doejane_4711_98_1.1_reflect-1.c"
    cp "$solved/$turn" "$in/doejane_4714_99_2.2_turn_to.c"
    cp "$solved/$turn" "$in/ohararae_LATE_4712_100_2.2_turn_to.c"
    (cd "$work/x/roe/exercises" && mkdir 1_diffuse_photon_map && cp "$solved/$reflect" "$reflect" &&
        patch -s -p2 <"$root/tests/mistakes/1.1_straight_back/a.patch")
    tar -czf "$in/roezoë_4713_101_zoe-2026-11-30.tar-1.gz" -C "$work/x/roe" exercises
    cat >"$work/gradebook.csv" <<'END'
Student,ID,SIS User ID,SIS Login ID,Section,Essay (5),photonlab (77),Final Score
,,,,,Manual Posting,,
    Points Possible,,,,,10.00,20.00,(read only)
"Doe, Jane",4714,s4,jane2,A,3,,15
"Doe, Jane",4711,s1,jane,A,3,,15
"O'Hara, Rae",4712,s2,rae,A,,7,
"Roe, Zoë",4713,s3,zoe,B,,,
"Nobody, Nora",4799,s9,nora,B,,,
"Ill, Ivo",4798,s8,ivo,B,,EX,
"Else, Eva",4797,s7,eva,B,,N/A,
"Student, Test",4900,,7c2f,A,,,
END
    grade canvas PHOTONLAB_ROSTER="$work/gradebook.csv" PHOTONLAB_FORMAT=canvas &&
        bad "canvas: takes any of two assignments"
    says "2 assignments; say which: GRADE='Essay (5)' or GRADE='photonlab (77)'" "$work/canvas-out-said" "canvas: which assignment?"
    grade canvas PHOTONLAB_ROSTER="$work/gradebook.csv" PHOTONLAB_FORMAT=canvas PHOTONLAB_GRADE=photon && bad "canvas: half a name"
    says "no assignment photon; say which: GRADE='Essay" "$work/canvas-out-said" "canvas: which there are"
    printf '%s\n' 'late 10' | cat "$PHOTONLAB_POINTS" - >"$work/late.txt"
    grade canvas PHOTONLAB_ROSTER="$work/gradebook.csv" PHOTONLAB_FORMAT=canvas PHOTONLAB_GRADE=photonlab \
        PHOTONLAB_POINTS="$work/late.txt" ||
        bad "canvas: $(cat "$work/canvas-out-said")"
    same_file "$work/canvas-out/canvas.csv" "canvas: its gradebook comes back with that column alone" <<'END'
Student,ID,SIS User ID,SIS Login ID,Section,photonlab (77)
"    Points Possible",,,,,20.00
"Doe, Jane",4714,s4,jane2,A,1.00
"Doe, Jane",4711,s1,jane,A,0.80
"O'Hara, Rae",4712,s2,rae,A,1.00
"Roe, Zoë",4713,s3,zoe,B,1.00
"Nobody, Nora",4799,s9,nora,B,0.00
"Ill, Ivo",4798,s8,ivo,B,EX
"Else, Eva",4797,s7,eva,B,N/A
END
    says "to be uploaded: $work/canvas-out/canvas.csv" "$work/canvas-out-said" "canvas: the file for it is named"
    says '^Student,.*,stage_1,stage_2,stage_3,1.1,.*,3.5,passed,' "$work/canvas-out/class.csv" \
        "canvas: no columns for stages that are worth nothing"
    ok "canvas: nor in the page" not grep -qE 'stage 4|>4\.1<' "$work/canvas-out/index.html"
    in_table canvas-out ',4714,' ',1,0,0,14,0,' "canvas: nor are they called not started"
    in_table canvas-out 4712 'Canvas says that it is late' "canvas: who is late, and that nobody knows by how much"
    check "$(grep -c . "$work/canvas-out/class.csv") == 8" "canvas: rows that are no student's are none of the table"
    "$build/class_table" --points "$PHOTONLAB_POINTS" --notes "../my notes" --pictures course_notes/figures "$work/canvas-out" \
        "$work/canvas-out/.parts/.names"
    says 'href="../my%20notes/gallery.html#m-1-1-straight-back">picture</a><td><a href="roezo' "$work/canvas-out/index.html" \
        "canvas: a mistake leads to its picture, and to whose it is"
    says '<details><summary>1 ✗ or !</summary>1.1: the photon is sent straight back' "$work/canvas-out/index.html" \
        "canvas: what went wrong stands in the row, folded"
    says '<b>1</b> the photon is sent straight back.*<img' "$work/canvas-out/lecture.html" "canvas: a picture for the lecture"
    # Handed in again, two days late and wrong now: what the stage had before counts.
    mkdir "$work/canvas-again" && cp "$in/roezo"* "$work/canvas-again/"
    sed 's/return .*/return direction;/' "$solved/$reflect" >"$work/canvas-again/doejane_LATE_4711_102_1.1_reflect.c"
    sed '1s/$/,submitted/; /,4711,/s/$/,2026-11-30 14:14/' "$work/gradebook.csv" >"$work/dated.csv"
    printf '%s\n' 'stage 1 due 2026-11-28' | cat - "$work/late.txt" >"$work/due.txt"
    PHOTONLAB_EARLIER=$work/canvas-out grade canvas-again PHOTONLAB_ROSTER="$work/dated.csv" PHOTONLAB_FORMAT=canvas \
        PHOTONLAB_GRADE=photonlab PHOTONLAB_POINTS="$work/due.txt" || bad "canvas: $(cat "$work/canvas-again-out-said")"
    in_table canvas-again-out ',4711,' 'stage 1 has the points that it had before' "canvas: late again, what was handed in before stays"
    says '^"Doe, Jane",4711,s1,jane,A,0.80$' "$work/canvas-again-out/canvas.csv" "canvas: and so does the grade"
    mkdir "$work/nameless" "$work/nameless/ann" && printf 'ann\0' >"$work/nameless/names"
    echo '{"status": "graded"}' >"$work/nameless/ann/graded.json"
    echo '{"steps": [{"id": "1.1", "status": "fail", "message": "expected 3; later on it did not end within 18 s"},
        {"id": "2.2", "status": "fail", "checks": [{"title": "Lobes turn", "status": "fail"}]}]}' >"$work/nameless/ann/report.json"
    "$build/class_table" --points "$PHOTONLAB_POINTS" "$work/nameless" "$work/nameless/names"
    in_table nameless ann '1.1: it did not end within 18 s; 2.2: wrong by the check “Lobes turn”' \
        "class: what is wrong without a name is told in words"
    says '<td>2.2<td>wrong by the check' "$work/nameless/index.html" "class: on its page, too"
}

# One zip of folders that begin with a name and the worksheet's number; the worksheet says when each was handed in.
check_moodle() {
    local in=$work/x/moodle name
    for name in "Jane Doe_815" "lab_1-Jane Doe_816" "Ann B_817"; do
        mkdir -p "$in/${name}_assignsubmission_file" "$in/${name}_assignsubmission_onlinetext"
        cp "$solved/$reflect" "$in/${name}_assignsubmission_file/"
        echo hello >"$in/${name}_assignsubmission_onlinetext/onlinetext.html"
    done
    sed 's/return .*/return axis;/' "$solved/$turn" >"$in/lab_1-Jane Doe_816_assignsubmission_file/${turn#*/}"
    (cd "$in" && zip -qr "$work/moodle" .) && mv "$work/moodle.zip" "$work/moodle"
    sheet() { # sheet GRADE GRADE GRADE GRADE [DAY FEEDBACK], on which the first one came and what it was told before
        printf '\357\273\277%s,%s\n' 'Identifier,"Full name","Email address",Status,Grade,"Maximum Grade"' \
            '"Grade can be changed","Last modified (submission)","Last modified (grade)","Feedback comments"'
        printf '"Participant %s","%s",%s,"%s",%s,%s,%s,"%s",-,%s\n' \
            816 "Jane Doe" j@x.org "Submitted for grading" "$1" 50.00 Yes "${5:-Monday, 30} November 2026, 2:14 PM" "${6:-}" \
            815 "Jane Doe" jd@x.org "Submitted for grading" "$2" 50.00 Yes "Saturday, 28 November 2026, 11:59 PM" "seen at the board" \
            817 "Ann B" a@x.org "Submitted for grading" "$3" 50.00 No "Sunday, 27 December 2026, 12:00 AM" "" \
            818 "No One" n@x.org "No submission" "$4" 50.00 Yes - ""
    }
    sheet "" "" 11 "" >"$work/worksheet.csv"
    printf '%s\n' 'stage 1 due 2026-11-28' 'late 10 most 50' | cat "$PHOTONLAB_POINTS" - >"$work/late.txt"
    grade moodle PHOTONLAB_ROSTER="$work/worksheet.csv" PHOTONLAB_FORMAT=moodle PHOTONLAB_POINTS="$work/late.txt" ||
        bad "moodle: $(cat "$work/moodle-out-said")"
    # 4 points of 100; two days late, in the last minute, far too late and not to be changed, nothing.
    sheet 1.60 2.00 11 0.00 | sed '1!s/"\(Identifier\|[^",]*\)"/\1/g' >"$work/expected"
    sed -E '1!s/"([^",]*)"/\1/g; 1s/"//g; s/,"photonlab: .*/,/' "$work/moodle-out/moodle.csv" >"$work/got"
    sed -i '1s/"//g' "$work/expected"
    same_file "$work/got" "moodle: its worksheet comes back, late days taken off; what is locked stays" <"$work/expected"
    in_table moodle-out 816 ',2026-11-30 14:14,2,0.8,' "moodle: when, days late, points lost"
    in_table moodle-out 817 '^Participant 817,.*,graded,yes,2,100,.*,28,2,' "moodle: never more than most"
    says 'Participant 816.*,"photonlab: stage 1: 3.2 of 4, stage 2: 0 of 5, stage 3: 0 of 91; 2 days late: −0.80. Step 2.2' \
        "$work/moodle-out/moodle.csv" "moodle: a line for the student: stages, late days, what went wrong most"
    says 'Participant 815.*,seen at the board$' "$work/moodle-out/moodle.csv" "moodle: what a teacher has written to one stays"
    says 'Participant 818.*,-,$' "$work/moodle-out/moodle.csv" "moodle: and who handed in nothing is told nothing"
    # Handed in again, too late, with the rest: what the stage had before counts.
    sheet "" "" 11 "" "Sunday, 29" '"<p dir=""ltr"">photonlab: as Moodle saves it</p>"' | sed 's/29 November/6 December/' >"$work/again.csv"
    mv "$work/moodle" "$work/again"
    PHOTONLAB_EARLIER=$work/moodle-out grade again PHOTONLAB_ROSTER="$work/again.csv" PHOTONLAB_FORMAT=moodle PHOTONLAB_POINTS="$work/late.txt"
    in_table again-out 816 '^Participant 816,.*,yes,3.2,100,3.2,0,0,.*,0,0,.*stage 1 has the points that it had before' \
        "late: a stage that is late now keeps what was handed in before"
    says 'Participant 816.*,"photonlab: stage 1: 3.2 of 4' "$work/again-out/moodle.csv" "moodle: a line of ours is written anew, however Moodle saved it"
}

check_roster() {
    mkdir -p "$work/roster" && put_step "$work/roster/doe-2026-11-30" && put_step "$work/roster/roe" && put_step "$work/roster/poe"
    printf 'id,login\n1,dough\n2,row\n' >"$work/others.csv"
    printf 'id,group,mail\n1,1,doe@x.org\n2,1,row@x.org\n' >"$work/few.csv"
    grade roster PHOTONLAB_ROSTER="$work/others.csv"
    check "$? == 2" "roster: one that knows nobody is an error"
    says 'no column has the name of a submission in it, `doe-2026-11-30` say' "$work/roster-out-said" "roster: which says so"
    PHOTONLAB_DIR=$work/roster PHOTONLAB_OUT=$work/roster-out PHOTONLAB_ROSTER=$work/few.csv \
        bash "$here/class.sh" plan >"$work/roster-out-said" 2>&1
    says 'few.csv knows only 1 of 3 submissions, by its column `mail`. Not in it: `poe`, `roe`' "$work/roster-out-said" \
        "roster: the column that matches most; a warning when few do"
    # The same in two parts, as a cluster does it, the second twice.
    for part in 1/2 2/2 2/2; do bash "$here/class.sh" grade "$work/roster-out" $part; done >"$work/parts" 2>&1
    check "$(grep -c '\] graded' "$work/parts") == 3 && $(grep -c '\] kept' "$work/parts") == 1" \
        "parts: a part again keeps what it has"
    bash "$here/class.sh" close "$work/roster-out" >"$work/roster-out-said" 2>&1
    says '3 submissions, 3 with a result' "$work/roster-out-said" "parts: one table of all"
    printf 'stage 1 due 2026-02-30\n' | cat "$PHOTONLAB_POINTS" - >"$work/typo.txt"
    local what
    for what in handout gradescope; do
        PHOTONLAB_POINTS=$work/typo.txt PHOTONLAB_OUT=$work/typo bash "$here/$what.sh" >"$work/said" 2>&1 &&
            bad "$what: made with a date that there is not"
        says 'typo.txt:[0-9]*: expected stage NUMBER' "$work/said" "$what: a mistake in points.txt stops it"
    done
}
