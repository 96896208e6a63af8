#!/usr/bin/env bash
# Grades one submission of a class. Usage: grade_one.sh CONFIG SUBMISSION NAME. Prints one line about it.
#
# Runs on whatever machine GNU parallel picks, so all it needs is in CONFIG (written by class.sh) and on shared disks.
# The result is put together in OUT/.parts/ and moved to OUT/NAME when it is complete; graded.json tells that it is, and
# from what.
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/json.sh"
. "$1"
submission=$2
name=$3
started=$EPOCHREALTIME

# What earlier runs on this machine left when they were killed.
temporary=${TMPDIR:-/tmp}
for old in "$temporary"/photonlab-class."$UID".*; do
    [ -d "$old" ] && [ -O "$old" ] && ! kill -0 "${old##*.}" 2>/dev/null && rm -rf "$old"
done
work=$temporary/photonlab-class.$UID.$$
mkdir -m 700 "$work" || exit 1
trap 'rm -rf "$work"' EXIT
code=$work/in/$name
mkdir -p "$code" "$work/test"

# What was handed in, as the judge will see it.
unpack() {
    timeout -k 5 60 "$BUILD/class_unpack" "$submission" "$code" >"$work/note" 2>"$work/why" && return
    code_of_unpack=$?
    [ -s "$work/why" ] && return $((code_of_unpack == 3 ? 3 : 1))
    case $code_of_unpack in
    124 | 137 | 152) echo "unpacking took too long" ;;
    *) echo "unpacking broke down" ;;
    esac >"$work/why"
    return 1
}

hash_of_content() {
    (cd "$code" && find . -type f -print0 | LC_ALL=C sort -z | xargs -0 -r sha256sum && cat "$work/note") |
        sha256sum | cut -c1-64
}

# What ran out of time is not paid for again, unless there is more time.
is_done() {
    [ -z "$REGRADE" ] && grep -qsF -e "\"key\": \"$key\"" -e "\"key\": \"$key in $SECONDS_EACH s\"" "$OUT/$name/graded.json" &&
        [ "$(tail -c 2 "$OUT/$name/report.json" 2>/dev/null)" = "}" ]
}

# Seconds since 1970: when its newest file was. Canvas does not say: there it is in time, or unknown.
handed_in() {
    case $submission in
    */.parts/loose/*) [[ $name =~ ^[^_]+(_LATE)?_[0-9]+$ || $name =~ anon_ ]] && echo 0 && return ;;
    esac
    find "$submission" ! -type d -printf '%T@\n' 2>/dev/null | sort -n | tail -1 | grep -o '^[0-9]*' || echo 0
}

points() {
    awk -F '[:,]' '/^ "points":/ { printf "%.1f", $2; exit }' "$1/report.json" 2>/dev/null
}

# finish STATUS MESSAGE KEY: graded.json comes last, then all is moved into place. What stood there before goes.
finish() {
    local seconds old
    seconds=$(awk -v a="$started" -v b="$EPOCHREALTIME" \
        'BEGIN { gsub(",", ".", a); gsub(",", ".", b); printf "%.2f", b - a }')
    printf '{"name": "%s", "status": "%s", "message": "%s", "key": "%s", "submitted": %s, "seconds": %s}\n' \
        "$(printf %s "$name" | json_text)" \
        "$1" "$(printf %s "$2" | json_text)" "$3" "$(handed_in)" "$seconds" >"$part/graded.json.new"
    mv "$part/graded.json.new" "$part/graded.json"
    chmod 755 "$part"
    old=$(mktemp -d "$OUT/.parts/old.XXXXXX")
    [ -e "$OUT/$name" ] && mv -T "$OUT/$name" "$old/was"
    mv -T "$part" "$OUT/$name" || exit 1
    rm -rf "$old"
    printable "$1  $(points "$OUT/$name" | grep . || echo 0) points  $seconds s  $name${2:+: ${2//$'\n'/ }}"
}

part=$(mktemp -d "$OUT/.parts/part.XXXXXX") || exit 1
printf '%s' "$name" >"$part/.name"
unpack
case $? in
0) ;;
3) finish "not graded" "$(head -c 6000 "$work/why")" "" && exit 0 ;;
*) finish "unreadable" "$(head -c 6000 "$work/why")" "" && exit 0 ;;
esac
key=$(printf '%s %s' "$JUDGE_KEY" "$(hash_of_content)" | sha256sum | cut -c1-64)
if is_done; then
    rm -rf "$part"
    printable "kept  $(points "$OUT/$name") points  $name"
    exit 0
fi

# What the judge has come to: its report has zero points before it begins, and grows with every step.
write_reports() {
    [ -x "$BUILD/write_reports" ] && timeout -k 5 120 "$BUILD/write_reports" --teacher "$part" >/dev/null 2>"$work/report" ||
        cat "$work/report" >&2
    rm -rf "$part/pictures" # they are in the page
}

cd "$work/in" || exit 1
timeout -k 10 "$SECONDS_EACH" "$BUILD/judge" --root "$ROOT" --build "$BUILD" --points "$POINTS" \
    --code "./$name" --work "$work/test" --report "$part" \
    --jobs 1 --credit >"$part/terminal.txt" 2>"$work/why" </dev/null
case $? in
0 | 1)
    write_reports
    finish "graded" "$(cat "$work/note")" "$key"
    ;;
124 | 137)
    write_reports
    left=$(grep -o '"message": "grading did not get this far"' "$part/report.json" | wc -l)
    if [ "$left" = 0 ]; then # what was still to do, a stage's steps together, has no points
        finish "graded" "the time ran out after the last step$(sed 's/^/; /' "$work/note")" "$key"
    else
        finish "partly graded" "the $SECONDS_EACH s for grading ran out before $left steps$(sed 's/^/; /' "$work/note")" "$key in $SECONDS_EACH s"
    fi
    ;;
*) finish "not graded" "$(tail -1 "$work/why" | grep . || echo "the judge broke down")" "" ;;
esac
