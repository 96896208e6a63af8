#!/usr/bin/env bash
# `build/probe` and `photonlab steps`: what they give, and how they refuse. Usage: probe.sh PROGRAM BUILD
set -u
here=$(dirname "$0")
. "$here/common.sh"
program=$1
probe=$2/probe
solutions=$2/solutions
mkdir "$work/none"

object_of() {
    "$program" steps | awk -F '\t' -v id="$1" -v dir="$solutions" '$1 == id { print dir "/" $4 ".so" }'
}

# probe STEP REFERENCES LINE…: runs the cases, numbers in text on standard output.
probe() {
    local step=$1 references=$2
    shift 2
    printf '%s\n' "$@" >"$work/cases"
    "$probe" --step "$step" --object "$(object_of "$step")" --references "$references" --print "$work/cases" 2>"$work/err"
}

# gives STEP CASE NUMBERS: the numbers that a deterministic case gives.
gives() {
    local found
    found=$(probe "$1" "$work/none" "$2")
    if [ "$found" = "case 0: $3" ]; then good "probe $1 $2"; else bad "probe $1 $2: expected $3, found $found $(cat "$work/err")"; fi
}

# refuses STEP CASE TEXT: exit code 1 and this text.
refuses() {
    probe "$1" "$work/none" "$2" >"$work/out"
    local code=$?
    if [ $code = 1 ] && grep -qF -- "$3" "$work/err"; then good "probe $1 '$2' is refused"; else bad "probe $1 '$2': exit $code, $(cat "$work/err")"; fi
}

rows=$(grep -cE '^(SCENE_)?STEP\(' "$here/../lib/steps/steps.def")
check "$("$program" steps | wc -l) == $rows" "steps lists as many as there are rows"
gives 1.1 "call 1 1 0 0 -1 0 0 1" "0 0 1"
gives 2.2 "call 1 1 0 0 1 0 1 0" "0 1 0"
gives 3.2 "call 1 1 1 0.666667" "0.039999906"
gives 3.3 "call 1 1 1.25 1.5 1.75 0" "1.5"
gives 3.1 "call 1 1 0.8 0 -0.6 0 0 1 1.5" "0 -77 -77 -77" # total reflection leaves its result alone
gives 1.6 "call 1 1 5 0 0 0 0 0 0 1 0 0 1 0 0.5 0.5 0.5 0 0 0 1 0" "0 0 0"
gives 4.2 "call 2 1 tests/steps/scenes/gather.yaml 3 3 3 0.25 1 0 0 -1 0" "0.572957814 0.381971866 0.190985933 0.572957814 0.381971866 0.190985933"
gives 4.4 "call 1 1 $(printf '2 %.0s' {1..216})$(printf 'inf %.0s' {1..216})0.1 9" "4"
gives 4.5 "call 1 1 1 0 0 0 0 1 0 3 4 5 2 $(printf '0 %.0s' {1..18})0 0 0.125 0 1 0 0.25" "1 3 4 5"
gives 4.5 "call 1 1 0 0 0 0.125 0 1 0 0.25" "0 -77 -77 -77"
refuses 4.2 "call 1 1 no.yaml 3 3 3 0 1 0 0 -1 0" "no.yaml"
refuses 4.3 "call 1 1 tests/steps/scenes/gather.yaml 3 3 3 0.25 1 0 0 1 0" "meets nothing"
refuses 1.1 "call 1 1 0 0 -1 0 0" "the arguments do not fit step 1.1"
refuses 1.1 "call 1 1 0 0 -1 0 0 1 7" "the arguments do not fit step 1.1"
refuses 1.1 "call 0 1 0 0 -1 0 0 1" "the arguments do not fit step 1.1"
refuses 1.1 "cal 1 1" "no kind of case"
refuses 1.5 "call 1 1" "not called alone"
refuses 1.1 "paths no.yaml 10 1 5 1.5 1" "no.yaml"
refuses 1.1 "paths scenes/prism.yaml 10 1 5 9.9 1" "no choice"

# The same seed, the same numbers; another, others.
a=$(probe 2.1 "$work/none" "call 3 7 20")
b=$(probe 2.1 "$work/none" "call 3 7 20")
c=$(probe 2.1 "$work/none" "call 3 8 20")
if [ -n "$a" ] && [ "$a" = "$b" ] && [ "$a" != "$c" ]; then good "seeds decide the numbers"; else bad "seeds: $a | $b | $c"; fi

# The limit by the clock is for what waits: a step at work goes on beyond it.
at_work=$(PHOTONLAB_PROBE_SECONDS=0.05 probe 2.1 "$work/none" "call 400000 7 20" | wc -w)
check "$at_work == 1200002" "a step at work is not ended by the clock"

# Step 2.3 gives a sixth number: did it call redraw_cap_reached()? The lobe here lies 5° below the surface.
caps=$(probe 2.3 "$solutions" "call 40 1 0.9961947 0 0.08715574 0 0 1 10000" | cut -d: -f2 |
    awk '{ for (i = 1; i < NF; i += 6) { if ($i + $(i + 5) != 1) wrong++; caps += $(i + 5) }; print NF, wrong + 0, (caps > 5 && caps < 35) }')
if [ "$caps" = "240 0 1" ]; then good "step 2.3 tells of its cap"; else bad "step 2.3 and its cap: $caps $(cat "$work/err")"; fi

# A step that is not there ends the program with a word about it; with it, the pass runs.
if probe 1.2 "$work/none" "call 1 1 0 0 0 1 0 0 0 0 1 1 1 1" >/dev/null; then
    bad "an absent step was called without a word"
elif grep -q "a step was called that is not there" "$work/err"; then
    good "a step that is absent says so"
else
    bad "absent step: $(cat "$work/err")"
fi
for case in "paths scenes/box_glass.yaml 100 2 9 3.4 1" "picture photons-only scenes/box_glass.yaml 8 8 500 20 9 2.3,1.5 1" \
    "passes 3 pass photons-only scenes/box_glass.yaml 8 8 500 20 9 2.3,1.5 1" \
    "passes 3 pixel photons scenes/box_glass.yaml 8 8 500 20 9 2.4,3.4 1"; do
    numbers=$(probe 1.1 "$solutions" "$case" | wc -w)
    check "$numbers > 100" "probe 1.1 $case"
done
echo "scatter scenes/box_glass.yaml 50 400 9 2.4,3.4 1" >"$work/scatter"
several() { "$probe" --several "$1" --objects "$work" --references "$solutions" "$work/scatter" -o "$work/photons" --print; }
mkdir -p "$work/1.1" && cp "$solutions/1_diffuse_photon_map/1.1_reflect.so" "$work/1.1/step.so"
several "" >"$work/reference" 2>&1
check "$(wc -w <"$work/reference") == $((2 + 3 + 400 * 15))" "a scatter has room for 400 photons"
several 1.1 >"$work/several" 2>&1
if cmp -s "$work/reference" "$work/several"; then good "the same object by another way: the same photons"; else bad "scatter: $(head -c 200 "$work/several")"; fi
if several 1.2 >/dev/null 2>"$work/err"; then bad "a missing object is taken"; else good "a missing object is refused"; fi
if several 1.1,7 >/dev/null 2>"$work/err"; then bad "step 7 is taken"; else good "step 7 is refused"; fi
if "$probe" --step 9.9 --object a --references b c >/dev/null 2>"$work/err"; then bad "step 9.9 is taken"; else good "step 9.9 is refused"; fi
finish
