# Reports that are refused, flags, files that cannot be written. To be sourced by report.sh.

echo "── reports that are refused"
# refuse WORDS FILTER: ends with 1, says the words, writes nothing.
refuse() {
    prepare "refused $1" "$2"
    refuse_file "$1"
}
refuse_file() {
    "$report" "$dir" >"$work/said" 2>&1
    local code=$?
    if [ $code = 1 ] && says "$work/said" "$1" && [ ! -e "$dir/index.html" ]; then
        good "refused: $1"
    else
        bad "ended with $code; said: $(cat "$work/said"); expected: $1"
    fi
    rm -rf "$dir"
}
refuse 'expected an object' '[]'
refuse 'format: expected "photonlab report 2"; found "photonlab report 1"' '.format = "photonlab report 1"'
refuse 'steps[1].points: expected a number; found nothing' 'del(.steps[1].points)'
refuse 'steps[1].points: expected at most 6; found 7' '.steps[1].points = 7'
refuse 'steps[0].points: expected 0 to 1e+09; found -1' '.steps[0].points = -1'
refuse 'points is 100, but the steps'"'"' points add up to 19.5' '.points = 100'
refuse 'points_max is 40, but the steps'"'"' add up to 50' '.points_max = 40'
refuse 'passed is 4, but 3 steps have the status pass' '.passed = 4'
refuse 'not_started is 0, but 1 steps have the status todo' '.not_started = 0'
refuse 'steps[2].status: expected pass, fail, error, todo or skip' '.steps[2].status = "passed"'
refuse 'steps[2].hidden: expected true or false; found a number' '.steps[2].hidden = 0'
refuse 'steps[2].stage: expected 1 to 99; found 0' '.steps[2].stage = 0'
refuse 'steps[2]: expected 17 fields; found 18' '.steps[2].more = 1'
refuse 'the whole: expected 13 fields; found 14' '.more = 1'
refuse 'steps[2].id: expected a number like 2.1' '.steps[2].id = "2.2\"><b>"'
refuse 'steps[1].checks: expected a list' '.steps[1].checks = null'
refuse 'steps[1].checks[0].p: expected a number or null; found a text' '.steps[1].checks[0].p = "0.1"'
refuse 'steps[1].checks[0].histogram: expected as many' '.steps[1].checks[0].histogram.observed = [1]'
refuse 'steps[1].checks[0].histogram.observed: expected numbers' '.steps[1].checks[0].histogram.observed = [true]'
refuse 'steps[1].checks[1].picture.yours: expected a path below' '.steps[1].checks[1].picture.yours = "/etc/passwd.pfm"'
refuse 'steps[1].checks[1].picture.yours: expected a path below ' '.steps[1].checks[1].picture.yours = "a/../../b.pfm"'
refuse 'steps[3]: expected an object; found a text' '.steps[3] = "x"'
refuse 'scatters[0].picture: expected a path below' '.scatters[0].picture = "../x.png"'
refuse 'scatters[1].stage: expected one more than 1; found 1' '.scatters[1].stage = 1'
refuse 'scatters[1]: expected 9 fields; found 10' '.scatters[1].points = 5'
refuse 'scatters: expected a list' 'del(.scatters)'
prepare text .; head -c 200 "$here/report.json" >"$dir/report.json"; refuse_file "report.json:"
prepare nan .; sed -i 's/0\.25/NaN/' "$dir/report.json"; refuse_file "invalid token near 'NaN'"
prepare twice .; sed -i 's/"credit"/"format": "x", "credit"/' "$dir/report.json"; refuse_file "duplicate object key"
prepare bytes .; sed -i 's/exercises/\xff\xfe/' "$dir/report.json"; refuse_file "unable to decode byte 0xff"
prepare none .; rm "$dir/report.json"; refuse_file "cannot be read"
prepare folder .; rm "$dir/report.json"; mkdir "$dir/report.json"; refuse_file "is a directory"

echo "── flags, and files that cannot be written"
prepare flags .
code() { "$@" >"$work/said" 2>&1; echo $?; }
check "$(code "$report") == 2" "no directory ends with 2"
check "$(code "$report" --no "$dir") == 2" "an unknown flag ends with 2"
check "$(code "$report" --notes) == 2" "--notes without a path ends with 2"
check "$(code "$report" --notes https://x.org "$dir") == 2" "--notes elsewhere ends with 2"
check "$(code "$report" --help) == 0" "--help ends with 0"
mkdir "$dir/index.html"
check "$(code "$report" "$dir") == 1" "index.html is a directory: ends with 1"
ok "and says so" says "$work/said" "index.html: is a directory"
