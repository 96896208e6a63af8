# The grader's measurements as text; sourced by check_grader.sh. Reads what its runs left in $found.

# Mistakes and what the diagnosis said, over the b patches and the unknown ones of every run of the matrix (or quick's).
write_confusion() {
    {
        echo "# What the diagnosis said of each mistake: made → named, how often. Written by make grader-table."
        echo "# b: another's hand than the one that the table was made from. unknown: not in the table."
        grep -E '^(b|unknown)/' "$1" | awk "$named_rightly"'{
            split($1, part, "/")
            name = part[2]
            sub(/_.*/, "", name)
            made = substr(part[2], length(name) + 2)
            said = $5 == "-" ? "(nothing)" : named_rightly() ? "itself" : $5
            count[part[1] " " name " " made " → " said]++
        } END { for (line in count) print line, count[line] }' | sort
    } >tests/mistakes/confusion.txt
}

# One row a step.
table_rows() {
    local solution name step
    for solution in solutions/*/*.c; do
        name=$(basename "$solution" .c)
        step=$(step_of "$name")
        awk -v step="$step" -v title="${name#*_}" "$named_rightly"'
            $2 != step { next }
            { split($1, part, "/"); kind = part[1]; made = part[2]; sub(/^[0-9.]*_/, "", made) }
            kind == "a" || kind == "b" { mistakes++; caught += $3 == "fail" }
            kind == "b" { b++; right_name = named_rightly(); named += right_name; wrong += !right_name && $5 != "-" }
            kind == "unknown" { unknown++; unknown_caught += $3 == "fail"; silent += $5 == "-" || $5 == "factor" }
            kind == "right" { right++; right_passed += $3 == "pass" }
            kind == "solution" { points = sprintf("%.1f %s", $4, $3) }
            kind == "stub" { stub = $3 }
            END {
                printf "| %s %s | %d | %d of %d | %d of %d | %d | %d of %d | %d of %d | %s | %s |\n", step, title, b, caught,
                    mistakes, named, b, wrong, silent, unknown, right_passed, right, points, stub
            }' "$1"
    done
}

write_table() {
    local quick=$found/quick.txt matrix=$found/matrix.txt wrong right silent
    [ -e "$quick" ] || { bad "run check_grader.sh quick first"; return; }
    write_confusion "$([ -e "$matrix" ] && echo "$matrix" || echo "$quick")"
    {
        echo "| step | known mistakes | caught (two patches each) | named rightly in another's hand | wrongly | silent about unknown | right alternatives passed | solution: points | stub |"
        echo "|---|---|---|---|---|---|---|---|---|"
        table_rows "$quick"
        read -r right wrong silent < <(named b "$quick")
        echo
        echo "Diagnosis of the patches in another's hand: $right named rightly, $wrong wrongly, $silent not at all (each mistake by name: mistakes/confusion.txt)."
        echo "More known mistakes, single edits (mistakes/more.txt): $(count '^more/[^ ]* [^ ]* fail' "$quick") of $(count '^more/' "$quick") caught."
        if [ -e "$matrix" ]; then
            echo "gcc and clang, -O0 and -O2, two salts: $(wc -l <"$matrix") gradings; $(cut -d ' ' -f 1-4 "$matrix" | sort -u | wc -l) different verdicts for $(cut -d ' ' -f 1 "$matrix" | sort -u | wc -l) cases."
        fi
        if [ -e "$found/attacks.txt" ]; then
            echo "Attacks (each under bubblewrap, under Landlock alone and under a user of its own; 0 points for the step, nothing left behind): $(count '^✓' "$found/attacks.txt") held, $(count '^✗' "$found/attacks.txt") did not."
        fi
        if [ -e "$found/false_verdicts.txt" ]; then
            local trials first confirmed
            trials=$(count " first-round " "$found/false_verdicts.txt")
            first=$(count " first-round fail" "$found/false_verdicts.txt")
            confirmed=$(count " confirmed fail" "$found/false_verdicts.txt")
            echo "Right solutions, graded $trials times, one step each, without confirmation: $first failed (at most $(clopper_pearson "$first" "$trials" 0.95) % at 95 % confidence, Clopper–Pearson)."
            echo "A failure by chance is confirmed on fresh random numbers, which are independent of the first: $confirmed of those failed again. If a step's rate in one round is at most $(clopper_pearson "$first" "$trials" 0.95) %, and rounds are independent, a wrong verdict has at most its square."
        fi
    } >"$work/table"
    if awk -v table="$work/table" '
        /<!-- grader: / { print; while ((getline line < table) > 0) print line; skip = 1; found = 1 }
        /<!-- end of grader -->/ { skip = 0 }
        !skip { if (!/<!-- grader: /) print }
        END { exit !found }' tests/README.md >"$work/readme"; then
        cp "$work/readme" tests/README.md
        good "tests/README.md and tests/mistakes/confusion.txt are written"
    else
        bad "tests/README.md has no place for the table: a line <!-- grader: … --> and one <!-- end of grader -->"
    fi
}
