#!/usr/bin/env bash
# Grades every submission in a folder. `make class` runs it; its arguments come as PHOTONLAB_… from class.mk.
#
# Safe to kill at any time: what was finished is found again by grade_one.sh, what was not is graded anew.
set -u
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
. "$here/json.sh"
stop() {
    printable "class: $*" >&2
    exit 2
}

[ -n "${PHOTONLAB_DIR:-}" ] || stop "which submissions? make class DIR=submissions [ROSTER=roster.csv]"
[ -d "$PHOTONLAB_DIR" ] || stop "$PHOTONLAB_DIR: no such folder"
parallel --version 2>/dev/null | grep -q '^GNU parallel' ||
    stop "GNU parallel is missing (on Debian: apt-get install parallel)"
directory=$(cd "$PHOTONLAB_DIR" && pwd)
mkdir -p "$PHOTONLAB_OUT/.parts" || exit 2
out=$(cd "$PHOTONLAB_OUT" && pwd)
build=$(cd "$PHOTONLAB_BUILD" && pwd)
roster=${PHOTONLAB_ROSTER:-}
[ -z "$roster" ] || [ -r "$roster" ] || stop "$roster: cannot be read"

exec 9>"$out/.parts/.lock"
flock -n 9 || stop "another make class is writing to $out"

# Roster and folder are looked at before the long part. A name that another submission has already gets its ending back.
list=$out/.parts/.list
names=$out/.parts/.names
: >"$list" && : >"$names"
declare -A taken=([class.csv]=1 [index.html]=1 [.parts]=1)
ignored=()
count=0
. "$here/loose.sh"
shopt -s nocasematch
shopt -s nullglob
for submission in "$directory"/* "$loose"/*; do
    name=${submission##*/}
    is_sorted "$submission" && continue
    if [ -d "$submission" ]; then
        [ "$name" = __MACOSX ] && continue
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
    printf '%s\0%s\0' "$submission" "$name" >>"$list"
    printf '%s\0' "$name" >>"$names"
    count=$((count + 1))
done
shopt -u nocasematch nullglob
[ "$count" -gt 0 ] || stop "no submissions (folders or archives) in $PHOTONLAB_DIR"
[ ${#ignored[@]} = 0 ] || printable "not submissions: ${ignored[*]}"
table() {
    "$build/class_table" "$out" "$names" ${roster:+"$roster"} ${roster:+${PHOTONLAB_COLUMN:+"$PHOTONLAB_COLUMN"}}
}
table || exit 2

points=${PHOTONLAB_POINTS:-$root/tests/judge/points.txt}
# One grading of nothing, to find out whether this machine can grade at all.
mkdir -p "$out/.parts/empty" "$out/.parts/empty-test" "$out/.parts/total"
"$build/judge" --root "$root" --build "$build" --code "$out/.parts/empty" --work "$out/.parts/empty-test" \
    --points "$points" --report "$out/.parts/total" --credit >/dev/null 2>"$out/.parts/why" ||
    stop "$(cat "$out/.parts/why")"

# Parts that a killed run had completed but not moved. All else in there is unfinished.
for part in "$out"/.parts/part.*; do
    name=$(cat "$part/.name" 2>/dev/null && echo .) && name=${name%.} &&
        [ -f "$part/graded.json" ] && [ ! -e "$out/$name" ] &&
        mv -T "$part" "$out/$name"
done
rm -rf "$out"/.parts/part.* "$out"/.parts/old.* "$out"/.parts/empty*

# Whatever a verdict hangs on: another judge, points table, compiler or reference grades anew.
judge_key() {
    {
        cat "$build/judge" "$build/probe" "$build/photonlab" "$build/libphotonlab.so" "$build"/solutions/*/*.so "$points"
        find "$root/tests/steps" "$root/tests/judge" "$root/tests/mistakes" "$root/tests/reference/pictures" -type f \( -name '*.txt' -o -name \
            '*.yaml' \) \
            -print0 2>/dev/null | LC_ALL=C sort -z | xargs -0 -r cat
        "$PHOTONLAB_CC" --version
        echo "$PHOTONLAB_CC $PHOTONLAB_FLAGS $PHOTONLAB_LINK ${PHOTONLAB_SALT:-}"
    } | sha256sum | cut -c1-64
}
config=$out/.parts/.config
(umask 077 && : >"$config") # it holds the salt
{
    echo "export LC_ALL=${LC_ALL:-C}" # on other machines, too
    printf 'ROOT=%q\nBUILD=%q\nOUT=%q\nPOINTS=%q\n' "$root" "$build" "$out" "$points"
    printf 'export PHOTONLAB_CC=%q PHOTONLAB_FLAGS=%q PHOTONLAB_LINK=%q\n' "$PHOTONLAB_CC" "$PHOTONLAB_FLAGS" "$PHOTONLAB_LINK"
    printf 'export PHOTONLAB_HIDDEN=%q\n' "$directory:$out"
    printf 'export PHOTONLAB_SALT=%q\nREGRADE=%q\nJUDGE_KEY=%q\nSECONDS_EACH=%q\n' "${PHOTONLAB_SALT:-}" \
        "${PHOTONLAB_REGRADE:-}" "$(judge_key)" \
        "${PHOTONLAB_SECONDS_EACH:-900}"
} >"$config"

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
        [ "$worked" -gt 0 ] && left=$((SECONDS * (count - done) / worked)) && left="  (about $left s left)"
        [ "$done" = "$count" ] && left=""
        printf '[%d/%d] %s%s\n' "$done" "$count" "$line" "$left"
    done
}

SECONDS=0
# shellcheck disable=SC2086  # the flags are meant to fall apart into words
parallel --will-cite --retries 2 -0 -N2 ${PHOTONLAB_PARALLEL_FLAGS:-} -a "$list" \
    bash "$here/grade_one.sh" "$config" {1} {2} 9>&- </dev/null | show_progress 9>&-
table || exit 2
lost=0
while IFS= read -r -d '' name; do
    grep -qs '"status": "\(graded\|unreadable\)"' "$out/$name/graded.json" || lost=$((lost + 1))
done <"$names"
rm -rf "$out"/.parts/part.* "$out"/.parts/old.*
echo "$count submissions, $((count - lost)) with a result, $lost not graded, in $SECONDS s"
echo "$PHOTONLAB_OUT/class.csv, $PHOTONLAB_OUT/index.html"
[ "$lost" = 0 ]
