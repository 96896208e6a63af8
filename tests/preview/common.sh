# A preview window on a display of its own, driven from the shell; to be sourced after tests/common.sh.
# Needs Xvfb and xdotool. Set before: program (build/photonlab), preview_build (the shell command that builds a step).

export LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe

# A student who has solved everything, and what make would have built of it.
student_start() {
    student=$work/exercises
    objects=$work/objects
    local source
    mkdir -p "$student"
    cp -r solutions/. "$student"
    for source in "$student"/*/*.c; do
        source=${source#"$student"/}
        sh -c "$preview_build" sh "$student/$source" "$objects/${source%.c}.so" || return 1
    done
}

display_start() {
    local width=${1:-1280} height=${2:-720}
    mkdir -p "$work/screen"
    rm -f "$work/display"
    Xvfb -noreset -displayfd 3 -screen 0 "${width}x${height}x24" -fbdir "$work/screen" 3>"$work/display" >"$work/xvfb.log" 2>&1 &
    xvfb=$!
    wait_for 10 test -s "$work/display" || return 1
    DISPLAY=:$(cat "$work/display")
    export DISPLAY
}

# window_start SCENE [FLAG…]: the window with the student's code; what it says goes to $log.
window_start() {
    log=$work/window.log
    local scene=$1
    shift
    : >"$log" # what another window said in it is not this one's
    "$program" preview "$scene" --code "$objects" --watch "$student" --build "$preview_build" \
        --snapshot "$work/snapshot.png" "$@" >"$log" 2>&1 &
    window=$!
    wait_for 20 grep -q 'after the start' "$log" || return 1
    xdotool mousemove 320 240 # without a window manager, keys go where the mouse is
}

window_end() {
    local process
    for process in ${headless:-} ${window:-} ${xvfb:-}; do
        kill "$process" 2>/dev/null
        wait "$process" 2>/dev/null
    done
}

# at_work PROCESS: has anything it started, or that started, a processor, or does it wait for one?
at_work() {
    local task child stat children
    for task in "/proc/$1/task/"*; do
        children=()
        { read -ra children <"$task/children"; } 2>/dev/null # ends without a line's end
        for child in "${children[@]}"; do
            for stat in "/proc/$child/task/"*/stat; do
                { read -r stat <"$stat"; } 2>/dev/null || continue
                case ${stat##*) } in R* | D*) return 0 ;; esac
            done
            at_work "$child" && return 0
        done
    done
    return 1
}

# wait_for SECONDS COMMAND…: until the command succeeds. Seconds count in which nothing here is at work: while a busy machine lets the window
# wait for its turn, or it draws, it is not late. Ten times as many, and it is.
wait_for() {
    local polls=$((20 * ($1 + 1))) until=$((SECONDS + 10 * $1 + 1))
    shift
    until "$@"; do
        at_work $$ || polls=$((polls - 1))
        [ $polls -gt 0 ] && [ $SECONDS -lt $until ] || return 1
        sleep 0.05
    done
}

# lines_of PATTERN: how often the window has said it.
lines_of() {
    grep -cE "$1" "$log"
}

# said_again PATTERN COUNT: more often than COUNT times by now?
said_again() {
    [ "$(lines_of "$1")" -gt "$2" ]
}

# told TEXT PATTERN [SECONDS [COUNT]]: the window says it in time, more often than COUNT; the last such line stands beside the text.
told() {
    if wait_for "${3:-12}" said_again "$2" "${4:-0}"; then good "$1: $(grep -E "$2" "$log" | tail -1)"; else
        bad "$1: expected /$2/, found: $(tail -2 "$log")"
    fi
}

# same TEXT ONE OTHER, other TEXT ONE OTHER: two files in $work.
same() { ok "$1" cmp -s "$work/$2" "$work/$3"; }
other() { ok "$1" not cmp -s "$work/$2" "$work/$3"; }

# save FILE: what an editor does; the file is complete when it appears.
save() {
    cat >"$work/saved"
    mv "$work/saved" "$student/$1"
}

# picture_now NAME: the window's own snapshot, by its key. It says so when the file is whole.
picture_now() {
    local told
    told=$(lines_of 'snapshot\.png$')
    key s
    wait_for 10 said_again 'snapshot\.png$' "$told" && cp "$work/snapshot.png" "$work/$1.png"
}

key() {
    xdotool key --clearmodifiers "$1"
}

# The screen as it is, byte by byte.
screen_now() {
    cp "$work/screen/Xvfb_screen0" "$work/$1.screen"
}
