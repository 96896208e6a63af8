# What stands at the terminal: made-up results, by print_sample. To be sourced by report.sh.

echo "── the terminal"
COLUMNS=60 "$print_sample" >"$work/terminal"
ok "last line" [ "$(tail -1 "$work/terminal")" = "9 passed, 3 failed" ]
ok "the line before" [ "$(tail -2 "$work/terminal" | head -1)" = "1 not started, 1 not checked" ]
ok "points" says "$work/terminal" "50.5 of 80.5 points; 1 hidden step is graded, too"
ok "a pass" grep -qE '^  ✓ 1\.1 Reflect a direction +2\.5/2\.5$' "$work/terminal"
ok "a failure, in several lines" says <(tr -s ' \n' ' ' <"$work/terminal") \
    "for n = 20 the mean of cosα should be 0.9545, found 0.9524"
ok "its likely mistake" says "$work/terminal" "looks like: the exponent n in place of n+1"
ok "where to go on" says <(tr -s ' \n' ' ' <"$work/terminal") "make hint STEP=2.1 · contract: lib/steps/2_glossy_lobe.h"
ok "the first and the last 10 lines printed" eval 'grep -qx "        line 10" "$work/terminal" && grep -qx "        line 40" "$work/terminal"'
ok "and not more" not grep -qx '        line 11' "$work/terminal"
ok "the compiler's lines as they stand" grep -qx '      *14 |     return x' "$work/terminal"
ok "a crash, and where" says "$work/terminal" "in refract, line 9"
ok "a scatter that passes" grep -qx '  ✓ scatter of stage 1, by your 1.1 1.3' "$work/terminal"
ok "a scatter that fails" says <(tr -s ' \n' ' ' <"$work/terminal") "stage 2, scatter: the copper ball gets 31 % fewer photons than right (z = 14)"
ok "no scatter where nothing played" not says "$work/terminal" "scatter of stage 3"
ok "not started" grep -q '^  ○ 3\.4 ' "$work/terminal"
ok "hidden steps are silent" not grep -qE 'secret|2\.3' "$work/terminal"
ok "no colours or commands from a pipe" not grep -qP '\x1b|\x07|\xff' "$work/terminal"
ok "lines of sentences fit 60 columns" [ "$(grep -v 'exercises/' "$work/terminal" |
    LC_ALL=C awk '{ n = gsub(/[^\200-\277]/, "") } n > 60' | wc -l)" = 0 ]
"$print_sample" verbose >"$work/terminal"
ok "verbose: each check" says "$work/terminal" "✓ Directions follow the density: p = 0.3, wrong below 0.00033"
if [ "$(script -qec "echo yes" /dev/null 2>/dev/null </dev/null | tr -d '\r')" = yes ]; then
    TERM=xterm NO_COLOR='' script -qec "\"$print_sample\"" /dev/null >"$work/terminal" </dev/null
    ok "colours on a terminal" grep -q "$(printf '\033\\[32m')" "$work/terminal"
    TERM=xterm NO_COLOR=1 script -qec "\"$print_sample\"" /dev/null >"$work/terminal" </dev/null
    ok "none with NO_COLOR" not grep -q "$(printf '\033')" "$work/terminal"
fi
