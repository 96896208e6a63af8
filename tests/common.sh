# Counting checks in shell; to be sourced. Each check prints a line, `finish` the sum.
passed=0
failed=0
work=$(mktemp -d)
# A job that is ended before it has become its program runs this, too, in a process of its own.
trap '[ "$(exec sh -c "echo \$PPID")" = $$ ] && rm -rf "$work"' EXIT

good() {
    passed=$((passed + 1))
    echo "✓ $*"
}

bad() {
    failed=$((failed + 1))
    echo "✗ $*"
}

finish() {
    echo "$passed passed, $failed failed"
    [ "$failed" = 0 ]
}

# number JSON NAME [INDEX]: a number, or an array's element, out of a line of JSON.
number() {
    local rest=${1#*\"$2\":}
    rest=${rest#[}
    local i=${3:-0}
    while [ "$i" -gt 0 ]; do
        rest=${rest#*,}
        i=$((i - 1))
    done
    echo "${rest%%[],\}]*}"
}

# holds EXPRESSION: does awk find it true?
holds() {
    awk "BEGIN { exit !($1) }"
}

# check EXPRESSION TEXT: a line for a comparison of numbers.
check() {
    if holds "$1"; then good "$2"; else bad "$2 — expected $1"; fi
}

# same_means NAME JSON: are both pictures of `photonlab diff --json` as bright on average, within 0.5 %?
same_means() {
    local c
    for c in 0 1 2; do
        check "$(number "$2" mean_ratio $c) > 0.995 && $(number "$2" mean_ratio $c) < 1.005" \
            "$1: mean ratio of channel $c is $(number "$2" mean_ratio $c)"
    done
}

# ok TEXT COMMAND…: a line for a command that must succeed, with what it said when it does not.
ok() {
    local text=$1 said
    shift
    if said=$("$@" 2>&1); then good "$text"; else bad "$text${said:+: ${said:0:600}}"; fi
}

not() { ! "$@"; }

# said TEXT: somewhere in what the last command of `expect` said, where white space counts as one blank.
said() {
    [ -z "$1" ] || cat "$work/out" "$work/err" | tr -s ' \n' ' ' | grep -qF -- "$1"
}

# expect CODE TEXT COMMAND…: the exit code, and what is said, to standard output or error.
expect() {
    local code=$1 text=$2 got line
    shift 2
    "$@" >"$work/out" 2>"$work/err"
    got=$?
    line="$(basename "$1") ${*:2}"
    if [ $got = "$code" ] && said "$text"; then good "${line//$work\//}${text:+: $text}"; else
        bad "$line: exit code $got, expected $code and '$text': $(cat "$work/out" "$work/err" | tail -20)"
    fi
}
