#!/usr/bin/env bash
# Every attack in this folder as a submission: it must cost its step all points, and leave everything else alone.
#   run.sh ROOT BUILD JUDGE-COMMAND…        the judge with its flags, but for --code, --step, --work and --report
# As root, with PHOTONLAB_SANDBOX=uid or landlock, on a copy of ROOT and BUILD; words of the command that are or begin with ROOT
# or BUILD are turned to the copy. Landlock is for those who are not root: the judge becomes nobody for it.
# ONLY="name name" runs these alone (`beside`: with a right step beside them), EVERY=2 TURN=0 or 1 every second. An attack is a folder:
# a step's source, in which @ROOT@, @BUILD@ and @WORK@ become paths (an attacker is to know what an insider knows); or `links`, a line "PATH TARGET" each; and `expect`, "STATUS WORDS": the
# step's status (or "fail|error" for either), and words of its message.
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
[ $# -ge 3 ] || { echo "usage: run.sh ROOT BUILD JUDGE-COMMAND…"; exit 2; }
chmod 755 "$work" # a user of its own has to get to what it is shown
export TMPDIR=$work/tmp
mkdir -m 755 "$TMPDIR"
root=$1
build=$2
shift 2
judge=("$@")

# What a container for grading holds.
copy_closed() {
    local old_root=$root old_build=$build i
    root=$work/tree
    build=$work/tree/build
    mkdir -p "$build"
    cp -R "$old_root"/lib "$old_root"/scenes "$old_root"/solutions "$root/"
    (cd "$old_root" && tar -cf - --exclude=tests/reference/images tests) | tar -xf - -C "$root"
    cp -R "$old_build"/photonlab "$old_build"/probe "$old_build"/libphotonlab.so "$old_build"/judge "$old_build"/solutions "$build/"
    [ ! -x "$old_build/write_reports" ] || cp "$old_build/write_reports" "$build/"
    chmod -R go+rX "$root" # the judge has to close it
    for i in "${!judge[@]}"; do
        case ${judge[i]} in
        "$old_build" | "$old_build"/*) judge[i]=$build${judge[i]#"$old_build"} ;;
        "$old_root" | "$old_root"/*) judge[i]=$root${judge[i]#"$old_root"} ;;
        esac
    done
}
[ "$(id -u)" != 0 ] || case ${PHOTONLAB_SANDBOX:-} in
uid) copy_closed ;;
landlock)
    copy_closed
    chmod 777 "$work" "$TMPDIR"
    judge=(setpriv --reuid 65534 --regid 65534 --clear-groups "${judge[@]}")
    ;;
esac
mkdir "$work/neighbour" && cp "$root/solutions/1_diffuse_photon_map/1.1_reflect.c" "$work/neighbour/"
sed -i '1i // the neighbour'"'"'s own words' "$work/neighbour/1.1_reflect.c"
export PHOTONLAB_HIDDEN=$work/neighbour PHOTONLAB_SALT=the-salt-itself
root=$(cd "$root" && pwd)
build=$(cd "$build" && pwd)

# fill FILE: the file with its paths filled in, on standard output.
fill() {
    sed -e "s|@ROOT@|$root|g" -e "s|@BUILD@|$build|g" -e "s|@WORK@|$work|g" "$1"
}

# submit NAME: the attack as a submission in $work/code; sets `step`.
submit() {
    local source path target
    rm -rf "$work/code" "$work/run" "$work/report"
    mkdir -p "$work/code" "$work/run"
    [ "${judge[0]}" != setpriv ] || chmod 777 "$work/run"
    step=1.1
    for source in "$here/$1"/*/*.c; do
        [ -f "$source" ] || continue
        path=${source#"$here/$1/"}
        mkdir -p "$work/code/${path%/*}"
        fill "$source" >"$work/code/$path"
        cp "$here/raw_call.h" "$work/code/${path%/*}/"
        step=${path##*/}
        step=${step%%_*}
    done
    [ -f "$here/$1/links" ] || return 0
    while read -r path target; do
        mkdir -p "$(dirname "$work/code/$path")"
        ln -s "$target" "$work/code/$path"
    done < <(fill "$here/$1/links")
}

# grade STEPS…: the submission's report in $work/report; one judge's run a step. Its exit code says whether it lived.
grade() {
    "${judge[@]}" --root "$root" --code "$work/code" --work "$work/run" --report "$work/report" "$@" >"$work/out" 2>&1
}

# field NAME: of the report's first step.
field() {
    sed -n '/"steps": \[/,$ { s/^ *"'"$1"'": "\{0,1\}\(.*[^",]\)"\{0,1\},\{0,1\}$/\1/p; }' "$work/report/report.json" | head -1
}

# What an attack may have left: files where anybody can write, changed files of the checkout and the build, processes that
# live. Only what can be told from other runs on this machine: rooms are made in this one's TMPDIR.
traces() {
    find /tmp /var/tmp /dev/shm "$TMPDIR" -maxdepth 1 -name 'photonlab-attack*' 2>/dev/null
    ls -A "$TMPDIR"
    (cd "$root" && find solutions lib/photonlab.h tests/judge/points.txt -newer "$work/began" 2>/dev/null)
    (cd "$build" && find photonlab libphotonlab.so solutions -newer "$work/began" 2>/dev/null)
    ps -eo stat,pid,args | grep -F "$work/" | grep -E '/probe --|bwrap|/cc1|/as |/ld ' | grep -vE '^Z|grep'
    for stray in "$root/report.json" "$build/report.json" /tmp/report.json; do
        [ ! -e "$stray" ] || echo "$stray"
    done
}

# well_formed: the judge's own writers can read the report.
well_formed() {
    [ -s "$work/report/report.json" ] || return 1
    [ ! -x "$build/write_reports" ] || "$build/write_reports" "$work/report" >/dev/null 2>&1
}

attack() {
    local name=$1 wanted words status points message code left
    read -r wanted words <"$here/$name/expect"
    submit "$name"
    touch "$work/began"
    grade --step "$step"
    code=$?
    status=$(field status)
    points=$(field points)
    message=$(field message)
    left=$(traces)
    if [ "$code" != 1 ]; then
        bad "$name: the judge ended with $code: $(tail -3 "$work/out")"
    elif ! well_formed; then
        bad "$name: the report cannot be read"
    elif [[ "|$wanted|" != *"|$status|"* ]] || [[ $message != *"$words"* ]]; then
        bad "$name: expected $wanted … $words, found $status: $message"
    elif ! holds "${points:-1} == 0"; then
        bad "$name: $points points"
    elif grep -qE "neighbour's own words|the-salt-itself" "$work/report/report.json"; then
        bad "$name: its report shows what it must not know"
    elif [ -n "$left" ]; then
        bad "$name: left behind: $left"
    else
        good "$name: $message"
    fi
}

# beside NAME: the attack with the right step 3.2 beside it, which keeps its points.
beside() {
    local other=3_colour_dispersion/3.2_fresnel.c
    submit "$1"
    mkdir -p "$work/code/${other%/*}"
    cp "$root/solutions/$other" "$work/code/$other"
    chmod 644 "$work/code/$other"
    grade --seconds 20 # right work on a busy machine
    if awk '/"id": "3.2"/ { here = 1 } here && /"status"/ { status = $2 } here && /"points":/ { points = $2; exit }
            END { exit !(status ~ /pass/ && points + 0 > 0) }' "$work/report/report.json"; then
        good "$1 leaves the points of the step beside it"
    else
        bad "$1 takes the points of the step beside it"
    fi
}

mkdir "$work/code" "$work/run"
if ! grade --step 1.1 && grep -q 'NO SANDBOX' "$work/out"; then
    echo "○ $(cat "$work/out")"
    exit 0
fi
names=("$here"/*/)
for ((i = ${TURN:-0}; i < ${#names[@]}; i += ${EVERY:-1})); do
    name=$(basename "${names[i]}")
    case " ${ONLY:-$name} " in *" $name "*) attack "$name" ;; esac
done
case " ${ONLY:-beside} " in *" beside "*)
    for name in exit_early signal_all_quietly memory_bomb; do
        beside "$name"
    done ;;
esac
finish
