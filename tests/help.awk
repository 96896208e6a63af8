# What `make help` prints: the lines of the makefiles that are marked for one group, which is -v group=teacher, maintainer, checks
# or, for students, nothing. The Makefile says how lines are marked.
function wrap(name, words,    count, word, i, line) {
    line = sprintf("  %-" column "s", name)
    count = split(words, word, " ")
    for (i = 1; i <= count; i++) {
        if (length(line) + length(word[i]) >= width) {
            print line
            line = sprintf("  %" column "s", "")
        }
        line = line " " word[i]
    }
    print line
}

BEGIN {
    width = 100
    column = group == "" ? 15 : 20
    said["teacher"] = "what teachers do"
    said["maintainer"] = "tests, benchmarks, tools"
    said["checks"] = "what make check runs, part by part"
    print "make TARGET [NAME=value …]" (group ? "     " said[group] : "")
}

/^##(teacher|maintainer|check .*)? [^ ]/ {
    of = $1 == "##" ? "" : substr($1, 3)
    sub(/^##[a-z]* +/, "")
    if (of == "check") {
        of = $1 == "long" ? "maintainer" : "checks"
        sub(/^[a-z]+ +/, "")
    }
    there[of] = 1
    split($0, part, /  +/)
    if (of == group)
        wrap(part[1], substr($0, length(part[1]) + 1))
}

END {
    if (group == "" && ("teacher" in there))
        print "For teachers: make help-teacher. Tests and tools: make help-maintainer."
}
