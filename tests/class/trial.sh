#!/usr/bin/env bash
# A class of 200: known mistakes, differently written right answers, attacks and broken archives. It is killed half-way
# and started again. `make class-trial` runs it from the checkout's root. Prints how fast it was and whether anything
# was lost.
#
# COUNT=200: how many. KEEP=folder: leave submissions and reports there.
set -u
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
. "$here/../common.sh"
cd "$root" || exit 1
PHOTONLAB_BUILD=$(cd "$PHOTONLAB_BUILD" && pwd)
export PHOTONLAB_BUILD
count=${COUNT:-200}
[ -z "${KEEP:-}" ] || { mkdir -p "$KEEP" && work=$(cd "$KEEP" && pwd) && trap - EXIT; }
class=$work/submissions
rm -rf "$class" "$work/out" "$work/x" && mkdir -p "$class" "$work/x" || exit 1

# Every source of steps there is: "mistake FOLDER", "alternative FILE", "attack FILE".
{
    for patch in tests/mistakes/*/a.patch; do [ -f "$patch" ] && echo "mistake ${patch%/*}"; done
    for file in tests/alternatives/*/*/*.c; do [ -f "$file" ] && echo "alternative $file"; done
    for file in tests/attacks/*/*/*.c; do [ -f "$file" ] && echo "attack $file"; done
} | sort | awk '{ of[$1] = of[$1] SUBSEP $2; n[$1]++ }
    END { # in turn, so that any 200 of them are mixed
        for (kind in of) split(substr(of[kind], 2), list, SUBSEP)
        for (i = 1; i <= 400; i++)
            for (k = 1; k <= 3; k++) { kind = substr("mistake    alternativeattack     ", 11 * k - 10, 11); sub(/ +$/, "", kind)
                if (n[kind]) { m = split(substr(of[kind], 2), list, SUBSEP); print kind, list[(i - 1) % m + 1] } }
    }' >"$work/sources"

place_of() { # of a step's source, by its id
    local solution
    solution=$(echo solutions/*/"$1"_*.c)
    echo "${solution#solutions/}"
}

# put KIND SOURCE FOLDER: one step of a submission.
put() {
    local name id place
    case $1 in
    mistake) name=$(basename "$2") && id=${name%%_*} ;;
    alternative) name=$(basename "$(dirname "$2")") && id=${name%%_*} ;;
    attack) # is laid out like exercises/
        mkdir -p "$3" && cp -R "${2%/*/*}"/[0-9]*_* "$3/"
        return
        ;;
    esac
    place=$(place_of "$id")
    mkdir -p "$3/${place%/*}"
    if [ "$1" = mistake ]; then
        cp "solutions/$place" "$3/$place" && patch -s -d "$3" -p2 <"$2/a.patch" >/dev/null 2>&1 ||
            cp "solutions/$place" "$3/$place"
    else
        cp "$2" "$3/$place"
    fi
}

# Two steps a submission; a folder, a .tar.gz and a .zip in turn; every 25th is broken.
make_submissions() {
    local i name kind source
    exec 8<"$work/sources"
    for i in $(seq -w "$count"); do
        name=student$i
        for _ in 1 2; do
            read -r kind source <&8 || { exec 8<"$work/sources"; read -r kind source <&8; }
            put "$kind" "$source" "$work/x/$name/exercises"
        done
        case $((10#$i % 3)) in
        0) cp -R "$work/x/$name" "$class/$name" ;;
        1) tar -czf "$class/$name.tar.gz" -C "$work/x" "$name" ;;
        2) (cd "$work/x" && zip -qr "$class/$name.zip" "$name") ;;
        esac
        [ $((10#$i % 25)) != 0 ] || { rm -rf "$class/$name"* && head -c 500 /dev/urandom >"$class/$name.tar.gz"; }
    done
    exec 8<&-
}

grade() {
    PHOTONLAB_DIR=$class PHOTONLAB_OUT=$work/out exec "$@" bash "$here/class.sh"
}

finished() { find "$work/out" -mindepth 2 -maxdepth 2 -name graded.json -exec grep -l '"status": "graded"' {} + \
    2>/dev/null | wc -l; }

make_submissions
check "$(find "$class" -mindepth 1 -maxdepth 1 | wc -l) == $count" "$count submissions are made"
start=$SECONDS
(grade setsid) >"$work/log1" 2>&1 &
killed=$!
while kill -0 "$killed" 2>/dev/null && [ "$(finished)" -lt $((count / 2)) ]; do sleep 0.5; done
kill -9 -- "-$killed" 2>/dev/null
wait "$killed" 2>/dev/null
first_part=$((SECONDS - start))
while pgrep -f "grade_one.sh $work/out" >/dev/null; do sleep 0.5; done # what parallel had started comes to its end by itself
half=$(finished)
check "$half >= $count / 2 && $half < $count" "killed after $first_part s, when $half were graded"
(cd "$work/out" && sha256sum student*/report.json student*/graded.json) >"$work/sums" 2>/dev/null
start=$SECONDS
(grade env) >"$work/log2" 2>&1
code=$?
second_part=$((SECONDS - start))
check "$code == 0" "started again: $(grep "with a result" "$work/log2")"
check "$(grep -c '\] kept' "$work/log2") == $half" "what was graded is kept, all else is graded"
# Those that nothing could be read of are looked at anew: they cost nothing.
(cd "$work/out" && grep -v graded.json "$work/sums" | sha256sum --quiet -c) >"$work/said" 2>&1 &&
    good "not one finished report has changed" ||
    bad "finished reports have changed: $(head -3 "$work/said")"
check "$(grep -c . "$work/out/class.csv") == $count + 1" "class.csv has a line for each"
check "$(grep -c ',unreadable,' "$work/out/class.csv") == $count / 25 - ($count / 25) % 1" \
    "the broken archives are said to be so"
check "$(ls -d "${TMPDIR:-/tmp}/photonlab-class.$UID".* 2>/dev/null | wc -l) == 0" "nothing is left behind"
cores=$(getconf _NPROCESSORS_ONLN)
awk -F, -v s=$((first_part + second_part)) -v n="$count" -v c="$cores" 'NR > 1 { wall += $NF }
    END { printf "%d submissions in %d s on %d cores: %.2f a second and core; %.1f s each\n", n, s, c, n / s / c, wall / n }' "$work/out/class.csv"
finish
