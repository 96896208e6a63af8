#!/usr/bin/env bash
# Grades every submission in a folder. `make class` runs it; its arguments come as PHOTONLAB_… from teacher.mk.
# Usage: class.sh                all of it
#        class.sh plan           finds the submissions and whatever grading needs, OUT/.parts/.config
#        class.sh grade OUT I/N  grades every Nth of them, by that file alone; anywhere that sees the same folders
#        class.sh close OUT      makes the table of what is there
#
# Safe to kill at any time: what was finished is found again by grade_one.sh, what was not is graded anew.
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/json.sh"
stop() {
    printable "class: $*" >&2
    exit 2
}

lock() { # lock FLAG OUT: -x alone, -s beside other parts
    exec 9>"$2/.parts/.lock"
    flock -n "$1" 9 || stop "another make class is writing to $2"
}

table() { "$BUILD/class_table" "${TABLE[@]}" "$OUT" "$OUT/.parts/.names"; }

# list_submissions: .list with path and name of each, .names. A name that another has already gets its ending back.
list_submissions() {
    local submission name short
    local -A taken=([class.csv]=1 [index.html]=1 [lecture.html]=1 [alike.html]=1 [moodle.csv]=1 [canvas.csv]=1 [.parts]=1)
    local ignored=()
    . "$here/loose.sh"
    shopt -s nocasematch nullglob
    for submission in "$directory"/* "$loose"/*; do
        name=${submission##*/}
        is_sorted "$submission" && continue
        if [ -d "$submission" ]; then
            [[ $name = __MACOSX || $name = *_assignsubmission_onlinetext* ]] && continue
        elif [[ $name =~ ^(.+)\.(tar\.gz|tgz|tar\.xz|txz|tar\.bz2|tar|zip|rar|7z)$ ]]; then
            short=${BASH_REMATCH[1]}
            [ -n "${taken[$short]:-}" ] || [ -d "$directory/$short" ] || name=$short
        elif [[ $name =~ ^(.+)\.(c|h|cc|cpp|cxx|c\.txt)$ ]]; then
            short=${BASH_REMATCH[1]} # to be a row of the table that says why nothing is graded
            [ -n "${taken[$short]:-}" ] || [ -d "$directory/$short" ] || name=$short
        else
            [ -e "$submission" ] && ignored+=("$name")
            continue
        fi
        while [ -n "${taken[$name]:-}" ]; do name=${name}_; done
        taken[$name]=1
        printf '%s\0%s\0' "$submission" "$name" >&3
        printf '%s\0' "$name" >&4
    done 3>"$out/.parts/.list" 4>"$out/.parts/.names"
    shopt -u nocasematch nullglob
    [ -s "$out/.parts/.list" ] || stop "no submissions (folders or archives) in $PHOTONLAB_DIR"
    [ ${#ignored[@]} = 0 ] || printable "not submissions: ${ignored[*]}"
}

# Whatever a verdict hangs on: another judge, points table, compiler or reference grades anew. Lateness is the table's.
judge_key() {
    {
        cat "$build/judge" "$build/probe" "$build/photonlab" "$build/libphotonlab.so" "$build"/solutions/*/*.so
        sed 's/[ \t]*#.*//; /^[ \t]*late/d; /^$/d' "$points"
        find "$root/tests/steps" "$root/tests/judge" "$root/tests/mistakes" "$root/tests/reference/pictures" -type f \
            ! -name points.txt \( -name '*.txt' -o -name '*.yaml' \) -print0 2>/dev/null | LC_ALL=C sort -z | xargs -0 -r cat
        "$PHOTONLAB_CC" --version
        echo "$PHOTONLAB_CC $PHOTONLAB_FLAGS $PHOTONLAB_LINK ${PHOTONLAB_SALT:-}"
    } | sha256sum | cut -c1-64
}

write_config() {
    local table=(--points "$points" --pictures "$root/course_notes/figures")
    [ -z "$roster" ] || table+=(--roster "$(realpath "$roster")")
    [ -z "${PHOTONLAB_COLUMN:-}" ] || table+=(--column "$PHOTONLAB_COLUMN")
    [ -z "${PHOTONLAB_FORMAT:-}" ] || table+=(--format "$PHOTONLAB_FORMAT")
    [ -z "${PHOTONLAB_GRADE:-}" ] || table+=(--grade "$PHOTONLAB_GRADE")
    [ -z "${PHOTONLAB_EARLIER:-}" ] || table+=(--earlier "$(realpath "$PHOTONLAB_EARLIER/class.csv")")
    [ ! -d "$build/notes" ] || table+=(--notes "$(realpath --relative-to "$out" "$build/notes")")
    (umask 077 && : >"$out/.parts/.config") # it holds the salt
    {
        echo "export LC_ALL=${LC_ALL:-C}" # on other machines, too
        printf 'ROOT=%q\nBUILD=%q\nOUT=%q\nPOINTS=%q\n' "$root" "$build" "$out" "$points"
        printf 'export PHOTONLAB_CC=%q PHOTONLAB_FLAGS=%q PHOTONLAB_LINK=%q\n' "$PHOTONLAB_CC" "$PHOTONLAB_FLAGS" \
            "$PHOTONLAB_LINK"
        printf 'export PHOTONLAB_HIDDEN=%q\n' "$directory:$out"
        printf 'export PHOTONLAB_SALT=%q\nREGRADE=%q\nJUDGE_KEY=%q\nSECONDS_EACH=%q\n' "${PHOTONLAB_SALT:-}" \
            "${PHOTONLAB_REGRADE:-}" "$(judge_key)" "${PHOTONLAB_SECONDS_EACH:-900}"
        printf 'TABLE=(%s)\n' "$(printf '%q ' "${table[@]}")"
    } >"$out/.parts/.config"
}

# Parts that a killed run had completed but not moved. All else in there is unfinished.
clear_parts() {
    local part name
    for part in "$1"/.parts/part.*; do
        name=$(cat "$part/.name" 2>/dev/null && echo .) && name=${name%.} &&
            [ -f "$part/graded.json" ] && [ ! -e "$1/$name" ] &&
            mv -T "$part" "$1/$name"
    done
    rm -rf "$1"/.parts/part.* "$1"/.parts/old.*
}

# Roster and folder are looked at before the long part; then one grading of nothing, whether this machine can grade at all.
plan() {
    local root roster points directory build
    root=$(cd "$here/../.." && pwd)
    roster=${PHOTONLAB_ROSTER:-}
    points=${PHOTONLAB_POINTS:-$root/tests/judge/points.txt}
    [ -n "${PHOTONLAB_DIR:-}" ] || stop "which submissions? make class DIR=submissions [ROSTER=roster.csv]"
    [ -e "$PHOTONLAB_DIR" ] || stop "$PHOTONLAB_DIR: no such folder"
    [ -z "$roster" ] || [ -r "$roster" ] || stop "$roster: cannot be read"
    [ -z "${PHOTONLAB_EARLIER:-}" ] || [ -r "$PHOTONLAB_EARLIER/class.csv" ] ||
        stop "EARLIER=$PHOTONLAB_EARLIER: no class was graded there, there is no class.csv"
    [ -z "${PHOTONLAB_FORMAT:-}" ] || [ -n "$roster" ] ||
        stop "FORMAT=$PHOTONLAB_FORMAT needs a roster: ROSTER=…, as $PHOTONLAB_FORMAT gave it out"
    mkdir -p "$PHOTONLAB_OUT/.parts" || exit 2
    out=$(cd "$PHOTONLAB_OUT" && pwd)
    build=$(cd "$PHOTONLAB_BUILD" && pwd)
    lock -x "$out"
    directory=$PHOTONLAB_DIR
    if [ -f "$directory" ]; then # the one zip that Canvas and Moodle give out
        directory=$out/.parts/unzipped
        rm -rf "$directory" && { unzip -qqo "$PHOTONLAB_DIR" -d "$directory" >/dev/null; [ $? -le 1 ]; } ||
            stop "$PHOTONLAB_DIR: neither a folder nor a zip"
    fi
    directory=$(cd "$directory" && pwd)
    list_submissions
    write_config
    . "$out/.parts/.config"
    table || exit 2
    mkdir -p "$out/.parts/empty" "$out/.parts/empty-test"
    "$build/judge" --root "$root" --build "$build" --code "$out/.parts/empty" --work "$out/.parts/empty-test" \
        --points "$points" --credit >/dev/null 2>"$out/.parts/why" ||
        stop "$(cat "$out/.parts/why")"
    clear_parts "$out"
    rm -rf "$out"/.parts/empty*
}

# A line a submission, with the time that the rest will take at this rate. What was kept took no time.
show_progress() {
    local line done=0 worked=0 left
    while IFS= read -r line; do
        left=""
        case $line in
        kept*) ;;
        graded* | unreadable* | "partly graded"* | "not graded"*) worked=$((worked + 1)) ;;
        *) echo "$line" && continue ;; # of parallel itself, or of a machine that cannot be reached
        esac
        done=$((done + 1))
        [ "$worked" -gt 0 ] && left=$((SECONDS * ($1 - done) / worked)) && left="  (about $left s left)"
        [ "$done" = "$1" ] && left=""
        printf '[%d/%d] %s%s\n' "$done" "$1" "$line" "$left"
    done
}

# grade I N: every Nth submission from the Ith on.
grade() {
    local list i=0 submission name
    list=$(mktemp "$OUT/.parts/list.XXXXXX") || exit 2
    while IFS= read -r -d '' submission && IFS= read -r -d '' name; do
        [ $((i++ % $2)) != $(($1 - 1)) ] || printf '%s\0%s\0' "$submission" "$name"
    done <"$OUT/.parts/.list" >"$list"
    SECONDS=0
    # shellcheck disable=SC2086  # the flags are meant to fall apart into words
    parallel --will-cite --retries 2 -0 -N2 ${PHOTONLAB_PARALLEL_FLAGS:-} -a "$list" \
        bash "$here/grade_one.sh" "$OUT/.parts/.config" {1} {2} 9>&- </dev/null |
        show_progress $(((i + $2 - $1) / $2)) 9>&-
    rm -f "$list"
}

close() {
    local name count=0 lost=0 partly=0
    clear_parts "$OUT"
    table 2>/dev/null || table || exit 2 # the plan has said what the roster does not know
    while IFS= read -r -d '' name; do
        count=$((count + 1))
        case $(head -c 2000 "$OUT/$name/graded.json" 2>/dev/null) in
        *'"status": "graded"'* | *'"status": "unreadable"'*) ;;
        *'"status": "partly graded"'*) partly=$((partly + 1)) ;;
        *) lost=$((lost + 1)) ;;
        esac
    done <"$OUT/.parts/.names"
    echo "$count submissions, $((count - lost)) with a result, $lost not graded, in $SECONDS s"
    [ "$partly" = 0 ] || echo "$partly partly graded, as $SECONDS_EACH s ran out. More for each:" \
        "PHOTONLAB_SECONDS_EACH=$((2 * SECONDS_EACH)) make class …"
    local to=${PHOTONLAB_OUT:-$OUT} grades
    echo "$to/class.csv, $to/index.html; for the lecture $to/lecture.html"
    for grades in moodle canvas; do
        [[ " ${TABLE[*]} " != *" --format $grades "* ]] || echo "to be uploaded: $to/$grades.csv"
    done
    [ "$lost" = 0 ]
}

[ "${1:-}" = close ] || parallel --version 2>/dev/null | grep -q '^GNU parallel' ||
    stop "GNU parallel is missing (on Debian: apt-get install parallel)"
case ${1:-} in
"") plan && grade 1 1 && close ;;
plan) plan ;;
grade) lock -s "$2" && . "$2/.parts/.config" && grade "${3%/*}" "${3#*/}" ;;
close) lock -x "$2" && . "$2/.parts/.config" && close ;;
*) stop "expected plan, grade OUT I/N or close OUT" ;;
esac
