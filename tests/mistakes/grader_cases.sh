# The cases that the grader itself is measured with; to be sourced, from the checkout. Each is graded alone, at its own step.

step_of() {
    local name=${1##*/}
    echo "${name%%_*}"
}

# What each known mistake looks like: NAME, a tab, its text.
mistake_texts() {
    local file
    for file in tests/mistakes/[0-9]*/text; do
        file=${file%/text}
        printf '%s\t%s\n' "${file##*/}" "$(head -1 "$file/text")"
    done | awk -F '[\t|]' '
        { text[$1] = $2; print $1 "\t" $2 }
        END {
            while ((getline <"tests/mistakes/more.txt") > 0)
                if (!/^#/) print $1 "\t" (sub("^=", "", $2) ? text[$2] : $2)
        }'
}

# Lines "CASE STEP SOURCE PATCH" of the rows of more.txt; its name stands for a patch.
more_cases() {
    local name rest
    while IFS='|' read -r name rest; do
        echo "${1:-}$name ${name%%_*} $(echo solutions/*/"${name%%_*}"_*.c) tests/mistakes/more.txt"
    done < <(grep -v '^#' tests/mistakes/more.txt)
}

# Lines "CASE STEP SOURCE [PATCH]". The kind is what stands before the slash: a and b (the two patches of a known mistake),
# more (a row of more.txt),
# unknown (a mistake that is not in the table), right (alternatives), solution, stub. Stubs are made in directory $1.
grader_cases() {
    local file name step solution
    for solution in solutions/*/*.c; do
        name=$(basename "$solution" .c)
        step=$(step_of "$name")
        echo "solution/$name $step $solution"
        awk -v id="$step" -v symbol="${name#*_}" -f tests/steps/stub.awk "$solution" >"$1/$name.c"
        echo "stub/$name $step $1/$name.c"
    done
    for file in tests/alternatives/*/*/*.c; do
        name=$(basename "${file%/*}")
        echo "right/$(step_of "$name")_$(basename "$file" .c) $(step_of "$name") $file"
    done
    for file in tests/mistakes/[0-9]*/[ab].patch tests/mistakes/unknown/*.patch; do
        name=${file#tests/mistakes/}
        step=${name#unknown/}
        step=${step%%_*}
        case $name in
        unknown/*) name=${name%.patch} ;;
        *) name=$(basename "$name" .patch)/${name%/*} ;;
        esac
        echo "$name $step $(echo solutions/*/"$step"_*.c) $file"
    done
    more_cases more/
}

# Grades the lines that come in, JOBS at a time, and prints "CASE STEP STATUS POINTS MISTAKE" for each.
grade_cases() {
    nice xargs -P "${JOBS:-$(nproc)}" -L 1 bash tests/mistakes/grade_case.sh
}

# The upper bound of a rate after $1 hits in $2 trials at confidence $3 (Clopper & Pearson 1934): the rate at which so few hits
# have probability 1 − $3.
clopper_pearson() {
    awk -v hits="$1" -v trials="$2" -v confidence="$3" '
        function so_few(p,    i, term, sum) { # sum of binomial terms 0 … hits
            term = exp(trials * log(1 - p))
            for (i = 0; i <= hits; i++) {
                sum += term
                term *= (trials - i) / (i + 1) * p / (1 - p)
            }
            return sum
        }
        BEGIN {
            low = hits / trials
            high = 0.999999
            for (n = 0; n < 60; n++) {
                middle = (low + high) / 2
                if (so_few(middle) > 1 - confidence) low = middle; else high = middle
            }
            printf "%.3g", 100 * high
        }'
}

# For awk, on lines "CASE STEP STATUS POINTS MISTAKE": was a known mistake named rightly? Mistakes of one text are one.
named_rightly='
    BEGIN {
        texts = "bash -c \". tests/mistakes/grader_cases.sh; mistake_texts\""
        while ((texts | getline line) > 0) {
            split(line, known, "\t")
            text[known[1]] = known[2]
        }
    }
    function named_rightly(    part) {
        split($1, part, "/")
        return part[1] != "unknown" && $5 != "-" && text[part[2]] == text[$2 "_" $5]
    }'
