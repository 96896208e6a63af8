# Counting checks in shell; to be sourced. Each check prints a line, `finish` the sum.
passed=0
failed=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

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
