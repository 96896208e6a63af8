# A stub from a solution: what stands between BEGIN SOLUTION and END SOLUTION is dropped, but for the numbered comments, which
# are the skeleton, and the lines behind STUB:, which keep it a function that can be called. Needs -v id=1.3 -v symbol=…
#
# The line that marks the step as not started also names the parameters that the stub does not use, and helpers that it does
# not call: with it goes what kept the compiler quiet about them, and from then on a warning says what is still unused.

function fail(why) {
    print FILENAME ":" FNR ": " why | "cat >&2"
    failed = 1
    exit 1
}

# Is the name in the text as a word of its own, not as a member (hit->normal)?
function uses(text, name) {
    return text ~ ("(^|[^A-Za-z0-9_>.])" name "([^A-Za-z0-9_]|$)")
}

# The names of a signature's parameters, into parameter[1 … parameters].
function read_signature(line,    list, parts, i) {
    list = line
    sub(/^[^(]*\(/, "", list)
    sub(/\).*$/, "", list)
    parameters = split(list, parts, ",")
    for (i = 1; i <= parameters; i++) {
        sub(/\[.*$/, "", parts[i])
        match(parts[i], /[A-Za-z0-9_]+ *$/)
        parameter[i] = substr(parts[i], RSTART, RLENGTH)
    }
    is_step = uses(line, symbol)
    if (line ~ /^static /) {
        match(line, /[A-Za-z0-9_]+\(/)
        helper[++helpers] = substr(line, RSTART, RLENGTH - 1)
    }
}

function print_first_line(    line, i) {
    line = is_step ? "todo(\"" id "\")" : ""
    for (i = 1; is_step && i <= helpers; i++)
        line = line ", (void)" helper[i]
    for (i = 1; i <= parameters; i++)
        if (!uses(code, parameter[i]))
            line = line (line == "" ? "" : ", ") "(void)" parameter[i]
    if (line != "")
        print "    " line "; // take this line away when you start"
    marked += is_step
}

# A signature may take several lines.
/^[A-Za-z].*\(.*,$/ {
    begun = $0
}
begun != "" && /^ .*[,)]$/ {
    begun = begun $0
}
/^[A-Za-z].*\)$/ {
    begun = $0
}
begun ~ /\)$/ {
    read_signature(begun)
    begun = ""
}
/^ *\/\/ BEGIN SOLUTION$/ {
    if (inside)
        fail("BEGIN SOLUTION within a solution")
    inside = 1
    code = skeleton = stub = ""
    in_comment = 0
    next
}
/^ *\/\/ END SOLUTION$/ {
    if (!inside)
        fail("END SOLUTION without BEGIN SOLUTION")
    inside = 0
    print_first_line()
    printf "%s", skeleton
    if (stub != "")
        printf "\n%s", stub
    next
}
/^ *\/\/ STUB: / {
    if (!inside)
        fail("STUB: outside BEGIN SOLUTION and END SOLUTION")
    sub(/^ *\/\/ STUB: /, "")
    code = code " " $0
    stub = stub "    " $0 "\n"
    next
}
inside {
    is_comment = $0 ~ /^ *\/\/ /
    is_numbered = $0 ~ /^ *\/\/ [0-9]+\. /
    in_comment = is_numbered || (in_comment && is_comment)
    sub(/^ */, "    ")
    if (in_comment)
        skeleton = skeleton (is_numbered ? "\n" : "") $0 "\n"
    next
}
{
    print
}
END {
    if (!failed && inside)
        fail("BEGIN SOLUTION without END SOLUTION")
    if (!failed && marked != 1)
        fail("no BEGIN SOLUTION in the function `" symbol "`")
}
