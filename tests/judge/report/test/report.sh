#!/usr/bin/env bash
# Reports: every status, hidden steps, nasty texts, malformed reports; each format by its own checker.
# Usage: report.sh build/report build/tests/print_sample
# Needs jq, python3, xmllint (Debian: libxml2-utils) and perl's TAP::Parser (Debian: perl).
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../../../common.sh"
report=$(realpath "$1")
print_sample=$(realpath "$2")
for tool in jq xmllint perl base64 python3; do
    command -v "$tool" >/dev/null || { echo "report.sh needs $tool"; exit 1; }
done

# A grey PFM of 4×4 pixels, in little-endian floats: 0.5, or 1.
picture() {
    printf 'PF\n4 4\n-1.0\n' >"$1"
    local i
    for ((i = 0; i < 48; i++)); do printf "$2" >>"$1"; done
}
half='\000\000\000\077' one='\000\000\200\077'

# One grey pixel as PNG.
png() {
    printf %s iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR42mNoAAAAggCBd81ytgAAAABJRU5ErkJggg== | base64 -d
}

# prepare NAME FILTER: a directory with pictures and the example report, changed by jq; its path in $dir.
prepare() {
    dir="$work/$1 with blanks"
    mkdir -p "$dir/pictures"
    picture "$dir/pictures/2.1_yours.pfm" "$one"
    picture "$dir/pictures/2.1_reference.pfm" "$half"
    png >"$dir/pictures/scatter_1.png"
    jq "$2" "$here/report.json" >"$dir/report.json"
}

# says FILE PATTERN; says_not: fixed strings.
says() { grep -qF -e "$2" "$1"; }
true_of() { jq -e -s "if length == 1 then .[0] else error(\"one value\") end | $1" "$2"; }

no_leftovers() { [ -z "$(find "$1" -name '*.tmp-*' -o -name '.picture-*')" ]; }

# Nothing is fetched from elsewhere, nothing runs: all sources are data, all links lead into the page or to the notes.
page_is_closed() {
    local page=$1/index.html
    local own='src="data:image/png;base64,[A-Za-z0-9+/]+=*"|href="#(step|scatter)-[0-9A-Za-z._-]+"'
    own="$own|href=\"notes/[0-9a-z_]+\\.html#[a-z-]+\""
    ! grep -oE '(src|href|action|data|srcset|poster)="[^"]*"' "$page" | grep -vE "^($own)\$" &&
        ! grep -qiE '<(script|iframe|object|embed|link|base|form)|@import|url\(|javascript:|<[^>]* on[a-z]+=' "$page"
}
tap() { perl "$here/tap.pl" <"$1/report.tap" >"$1/tap.out"; }
xpath() { xmllint --xpath "$1" "$2"; }

# written NAME [FLAG…]: a report of $dir is written, and every file of it right.
written() {
    ok "$1: written" "$report" "${@:2}" "$dir"
    check_forms "$1" "$dir"
}

# Every file of a report, by its format's checker.
check_forms() {
    local name=$1 dir=$2
    ok "$name: index.html is well-formed" xmllint --noout "$dir/index.html"
    ok "$name: index.html needs nothing from elsewhere" page_is_closed "$dir"
    ok "$name: junit.xml fits its schema" xmllint --noout --schema "$here/junit.xsd" "$dir/junit.xml"
    ok "$name: report.tap parses" tap "$dir"
    ok "$name: gradescope" true_of "$(cat "$here/gradescope.jq")" "$dir/gradescope/results.json"
    ok "$name: prairielearn" true_of "$(cat "$here/prairielearn.jq")" "$dir/prairielearn/results.json"
    ok "$name: prairielearn is small enough" [ "$(stat -c %s "$dir/prairielearn/results.json")" -lt 1000000 ]
    (cd "$dir" && CLASSROOM=c ASSIGNMENT=a SUBMISSION_TAG=s COMMIT_URL=u RELEASE_URL=r python3 "$here/../../../class/ci/classroom50.py" report.json)
    ok "$name: classroom 50" true_of "$(cat "$here/classroom50.jq")" "$dir/result.json"
    ok "$name: nothing left behind" no_leftovers "$dir"
}

# Numbers of PNG files inside the page that begin as PNG does.
png_count() {
    grep -oE 'base64,[A-Za-z0-9+/=]+' "$1/index.html" | while IFS= read -r line; do
        printf %s "${line#base64,}" | base64 -d | head -c 8 | od -An -tx1 | tr -d ' \n'
        echo
    done | grep -c 89504e470d0a1a0a
}

echo "── what each format says"
prepare all .
written student --notes notes
check "$(png_count "$dir") == 4" "html: yours, reference and difference are PNG, and the scatter"
ok "html: 11.5 of the 34 points of visible steps" says "$dir/index.html" "<b>11.5</b> of 34 points"
ok "html: the likely mistake" says "$dir/index.html" "the exponent n in place of n+1"
ok "html: the scale of the difference" says "$dir/index.html" "difference of 0.5, which is 80 %" # white is 0.625
ok "html: p in words" says "$dir/index.html" "Right code is this far off in 30 % of runs"
ok "html: hidden steps are counted" says "$dir/index.html" "2 hidden steps are graded, too; worth 16 more points"
ok "html: the scatter's words" says "$dir/index.html" "the copper ball gets 31 % fewer photons than right (z = 14)"
ok "html: a scatter without its picture says why" says "$dir/index.html" "The picture is left out: no OSMesa; install libosmesa6"
ok "junit: 6 steps and 2 scatters, 2 failures, 1 error, 2 skipped" xpath \
    "/testsuites[@tests=8 and @failures=2 and @errors=1 and @skipped=2]" "$dir/junit.xml"
ok "junit: the sums are those of the elements" xpath "/testsuites[count(//testcase)=@tests
    and count(//failure)=@failures
    and count(//error)=@errors and count(//skipped)=@skipped and sum(testsuite/@tests)=@tests]" "$dir/junit.xml"
ok "junit: the failure names its mistake" xpath \
    "//testcase[starts-with(@name,'2.1 ')]/failure[@type='lobe_exponent_n']" "$dir/junit.xml"
ok "junit: the scatter that fails" xpath "//testcase[@name='scatter of stage 2']/failure[@type='scatter']" "$dir/junit.xml"
printf '%s\n' ok not-ok ok not-ok todo skip ok not-ok >"$work/statuses"
ok "tap: statuses and directives" cmp <(grep -E '^[a-z-]+ [0-9]+ ' "$dir/tap.out" | cut -d' ' -f1) "$work/statuses"
ok "tap: plan" says "$dir/tap.out" "planned 8"
ok "tap: yaml" says "$dir/tap.out" "severity=fail points=1.5 checks=2"
ok "tap: version 14" [ "$(head -1 "$dir/report.tap")" = "TAP version 14" ]
ok "gradescope: visibility" true_of '[.tests[] | select(.number | startswith("2.")) | .visibility]
    == ["visible", "visible", "after_due_date", "hidden"]' "$dir/gradescope/results.json"
ok "gradescope: points of all, hidden too" true_of '([.tests[].score] | add) == 19.5 and (.tests | length) == 10' \
    "$dir/gradescope/results.json"
ok "prairielearn: score and points" true_of '.gradable and .score == 0.39 and ([.tests[].points] | add) == 19.5' \
    "$dir/prairielearn/results.json"
ok "classroom 50: points, hidden ones together" true_of \
    '.score == 1950 and ."max-score" == 5000 and (.tests[-1] | ."test-name" == "hidden steps" and (.passed | not))' "$dir/result.json"

echo "── hidden steps"
seen=$(grep -rlE 'secret|scatter_glossy|source text|modified Phong' "$dir" --include=index.html --include=junit.xml \
    --include=report.tap --include=result.json --include=prairielearn)
[ -z "$seen" ] && good "no student's file tells of hidden steps" || bad "told in $seen"
ok "prairielearn neither" not says "$dir/prairielearn/results.json" secret
written teacher --teacher
ok "teacher: html tells" says "$dir/index.html" "secret words of 2.3"
ok "teacher: 8 steps and 2 scatters" xpath "/testsuites[@tests=10 and @failures=3]" "$dir/junit.xml"
ok "teacher: tap, too" says "$dir/tap.out" "planned 10"

echo "── nasty texts"
nasty='"<script>alert(1)</script> ]]> &amp; \"q\" \u0027s\u0027 \\ \\n \u001b[31mred\u0000 \u202eturned'
nasty="$nasty"' \ufffe \r\n x\ry\u0085\u2028 # TODO\n  ...\nok 99 - forged\n  ---\nnot ok 98'
nasty="$nasty"' </pre></style><img src=x onerror=alert(1)>"'
prepare nasty "$nasty as \$n | .submission = \$n | .sandbox = \$n | .steps |= map(
    .title = \$n + .id | .symbol = \$n | .message = \$n | .where = \$n | .looks_like = \$n | .output = \$n
    | .mistake = \$n | .due = \$n | .chapter = \"javascript:alert(1)\"
    | .checks |= map(.title = \$n | .message = \$n | .name = \$n | .kind = \$n | if .histogram then .histogram.title = \$n else . end))
    | .scatters |= map(.message = \$n | .steps = \$n | .picture_message = \$n)"
ok "nasty: written" "$report" --notes notes "$dir"
sed -i 's/javascript:alert(1)//g' "$dir/index.html" # as words it may stand there; as a link it must not:
ok "nasty: no link to a script" not says "$dir/index.html" 'href="notes/"'
check_forms nasty "$dir"
ok "nasty: the words are there, escaped" says "$dir/index.html" "&lt;script&gt;alert(1)&lt;/script&gt; ]]&gt; &amp;amp;"
ok "nasty: control characters are shown as pictures" says "$dir/index.html" "␛[31mred␀"
ok "nasty: no control character in any file" not env LC_ALL=C grep -rqP \
    '[\x00-\x08\x0b-\x1f\x7f]|\xe2\x80[\xa8\xae]|\xc2\x85' "$dir" --include='*.html' --include='*.xml' \
    --include='*.tap' --include='result*.json'
ok "nasty: no test is forged" not grep -qE '9[89]$|^ok 99' "$dir/tap.out"
ok "nasty: the statuses are the same" cmp "$work/statuses" \
    <(grep -E '^[a-z-]+ [0-9]+ ' "$dir/tap.out" | cut -d' ' -f1)
ok "nasty: tap plans 8" says "$dir/tap.out" "planned 8"

echo "── much output, odd numbers, missing pictures"
prepare huge '("\u001b\"é&<" * 60000) as $much | .steps |= map(.output = $much)'
written huge --notes notes
ok "huge: says what is left out" says "$dir/index.html" "bytes left out"
prepare many '.steps[1] as $step | .steps = [range(100) as $i | $step | .id = "2.\($i)" | .title += .id
    | .output = "a line of output\n" * 2000] | .passed = 0 | .failed = 100 | .errors = 0 | .not_started = 0
    | .points = 150 | .points_max = 600'
written "many steps" --notes notes
ok "many steps: prairielearn's output is cut short, not away" says "$dir/prairielearn/results.json" "a line of output"
prepare null '.scatters[1].p = null | .steps[1].checks[0] |= (.p = null | .threshold = null | .histogram.low = null
    | .histogram.observed = [null, 1e308, -5]) | .steps[1].checks[1].picture |= (.T = null | .V = null)'
written null --notes notes
ok "null numbers: none in the page" not grep -qE '[">: ]-?(nan|inf)\b' "$dir/index.html"
prepare missing .
rm "$dir/pictures/2.1_yours.pfm"
written "missing picture" --notes notes
ok "missing picture: a note" says "$dir/index.html" "The pictures are left out: "
printf 'PF\n2 2\n-1.0\n' >"$dir/pictures/2.1_yours.pfm"
for i in 1 2 3 4 5 6 7 8 9 10 11 12; do printf '\000\000\300\177' >>"$dir/pictures/2.1_yours.pfm"; done
"$report" "$dir"
ok "a picture of NaN: a note" says "$dir/index.html" "The pictures are left out: "
prepare no_png .
echo "<svg/>" >"$dir/pictures/scatter_1.png"
ok "a scatter that is no PNG: written" "$report" "$dir"
ok "a scatter that is no PNG: a note" says "$dir/index.html" "The picture is left out: it is no PNG file"
prepare together '.steps |= map(.status = "pass" | .looks_like = "") | .passed = 8 | .failed = 0 | .errors = 0 | .not_started = 0'
ok "steps right, the scatter wrong: written" "$report" "$dir"
ok "the scatter is next" says "$dir/index.html" 'href="#scatter-2"'
ok "and not all is done" not says "$dir/index.html" "All done"
prepare black .
picture "$dir/pictures/2.1_reference.pfm" '\000\000\000\000'
"$report" "$dir"
check "$(png_count "$dir") == 4" "a black reference is shown"
prepare empty '.steps = [] | .scatters = [] | .points = 0 | .passed = 0 | .failed = 0 | .errors = 0 | .not_started = 0'
ok "no steps: written" "$report" "$dir"
ok "no steps: junit.xml" xmllint --noout --schema "$here/junit.xsd" "$dir/junit.xml"
ok "no steps: gradescope" true_of "$(cat "$here/gradescope.jq")" "$dir/gradescope/results.json"
ok "no steps: index.html" xmllint --noout "$dir/index.html"
ok "no steps: tap" tap "$dir"
prepare uncredited '.credit = false | .sandbox = "none"'
written "no credit" --notes notes
ok "no credit: no points for gradescope" true_of '([.tests[].score] | add) == 0' "$dir/gradescope/results.json"
ok "no credit: not gradable for prairielearn" true_of '.gradable == false' "$dir/prairielearn/results.json"
ok "no credit: no points for classroom 50" true_of '.score == 0 and ."max-score" == 5000' "$dir/result.json"
ok "no credit: the page says so" says "$dir/index.html" "Not for credit"

. "$here/refused.sh"
. "$here/terminal.sh"
finish
