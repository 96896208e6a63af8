# Pictures by passes, at the command line; to be sourced by cli.sh.

# Passes: in parts, and gone on with, the same bytes.
passes="$scene $quick --quiet --passes 11"
expect 2 "belong to --passes" "$program" render $scene -o "$work/a.part"
expect 2 "expected a part" "$program" render $passes --part 3 -o "$work/a.part"
expect 2 "for \`photonlab merge\`" "$program" render $passes --part 1/2 -o "$work/a.png"
expect 2 "cannot be parted" "$program" render $passes --part 1/12 -o "$work/a.part"
expect 2 "each pass needs the one before" "$program" render $passes --part 1/2 --radii pixel -o "$work/a.part"
expect 1 "expected the integrator photons" "$program" render $passes --radii pixel --integrator gather -o "$work/a.pfm"
expect 2 "expected files of passes" "$program" merge -o "$work/a.pfm"
expect 1 "is no file of passes" "$program" merge "$work/a.pfm" -o "$work/m.pfm"
expect 0 "" "$program" render $passes -o "$work/whole.pfm"
for part in 1 2 3 4; do expect 0 "" "$program" render $passes --part $part/4 -o "$work/p$part.part"; done
expect 0 "" "$program" merge "$work"/p[3412].part -o "$work/merged.pfm"
expect 0 "" "$program" merge "$work"/p?.part -o "$work/all.part"
expect 0 "" "$program" merge "$work/all.part" -o "$work/again.pfm"
expect 1 "passes 3 to 5 of 11 are missing: part 2/4" "$program" merge "$work"/p[341].part -o "$work/m.pfm"
expect 1 "both hold pass 3" "$program" merge "$work"/p?.part "$work/p2.part" -o "$work/m.pfm"
expect 0 "" "$program" render $passes --part 2/4 --seed 5 -o "$work/other.part"
expect 1 "other.part: does not belong to $work/p1.part: it was made by --seed 5, not 1" "$program" merge "$work"/p[134].part "$work/other.part" -o "$work/m.pfm"
expect 0 "" "$program" render $passes --part 2/4 --passes 12 -o "$work/other.part"
expect 1 "it is of 12 passes, not 11" "$program" merge "$work"/p[134].part "$work/other.part" -o "$work/m.pfm"
head -c 2000 "$work/p2.part" >"$work/cut.part"
expect 1 "cut.part: is cut off" "$program" merge "$work"/p[134].part "$work/cut.part" -o "$work/m.pfm"
for radii in pass pixel; do
    expect 0 "" "$program" render $passes --radii $radii --passes 3 -o "$work/three.part"
    expect 0 "" "$program" render $passes --radii $radii --resume "$work/three.part" -o "$work/resumed_$radii.pfm"
done
LC_ALL=C sed 's/ 1 eye rays/ 2147483647 eye rays/' "$work/three.part" >"$work/rays.part" # more than an int counts
expect 1 "rays.part: its numbers cannot be" "$program" merge "$work/rays.part" -o "$work/m.pfm"
expect 1 "it was made by --radii pixel, not pass" "$program" render $passes --resume "$work/three.part" -o "$work/m.pfm"
expect 0 "" "$program" render $passes --radii pixel -o "$work/pixel.pfm"
expect 0 "" "$program" render $scene $quick --quiet --seconds 0.1 -o "$work/seconds.part"
expect 0 "" "$program" merge "$work/seconds.part" -o "$work/m.pfm"
same_file() { ok "$3" cmp "$work/$1" "$work/$2"; }
same_file whole.pfm merged.pfm "four parts give the picture of one run"
same_file whole.pfm again.pfm "a file of all passes gives it, too"
same_file whole.pfm resumed_pass.pfm "so does a run that goes on"
same_file pixel.pfm resumed_pixel.pfm "also where each pixel has its radius"
if command -v parallel >/dev/null; then
    rm -rf "$work/many.pfm.parts"
    expect 0 "" bash scenes/machines/parallel.sh "$program" $scene "$work/many.pfm" 11 3 : $quick
    same_file whole.pfm many.pfm "and what GNU parallel shares out"
fi
"$program" render $scene $quick --passes 100000 -o "$work/stopped.pfm" 2>/dev/null &
until [ -s "$work/stopped.pfm" ]; do sleep 0.1; done
kill -TERM $!
wait $!
ok "a stopped run does not end as a finished one" test $? = 1
expect 0 "" "$program" diff "$work/stopped.pfm" "$work/stopped.pfm"
expect 1 "was stopped after" "$program" merge "$work/stopped.pfm.part" -o "$work/m.pfm"
