#!/usr/bin/env bash
# Many submissions where numbers have a decimal comma, killed half-way and begun again: all are graded, none twice, each as its work
# deserves. Usage: many.sh BUILD, from the checkout's root. COUNT=200.
set -u
. "$(dirname "$0")/../../common.sh"
build=$1 count=${COUNT:-200}
turn=2_glossy_lobe/2.2_turn_to.c mistakes=(tests/mistakes/2.2_*/a.patch)

localedef -i de_DE -f UTF-8 "$work/de_DE.UTF-8" || bad "no decimal comma (on Debian: apt-get install locales)"
for ((i = 0; i < count; i++)); do
    kind=$([ $((i % 2)) = 0 ] && echo right || echo wrong)
    to=$work/class/$kind$i
    mkdir -p "$to/2_glossy_lobe" && cp "solutions/$turn" "$to/2_glossy_lobe/"
    [ $kind = right ] || patch -s -d "$to" -p2 <"${mistakes[i / 2 % ${#mistakes[@]}]}" || bad "$to: the patch does not fit"
done

class() { LOCPATH=$work LC_ALL=de_DE.UTF-8 exec "$@" make --no-print-directory BUILD="$build" DIR="$work/class" OUT="$work/out" class; }
graded() { cat "$work"/out/*/graded.json 2>/dev/null | grep -c '"status": "graded"'; }

(class setsid) >"$work/said" 2>&1 &
killed=$!
until [ "$(graded)" -ge $((count / 2)) ] || ! kill -0 $killed 2>/dev/null; do sleep 0.2; done
kill -9 -- -$killed
wait $killed 2>/dev/null
before=$(graded)
check "$before >= $count / 2 && $before < $count" "killed when $before of $count were graded"
(class env) >"$work/said" 2>&1 || bad "begun again: $(tail -5 "$work/said")"
kept=$(grep -c '\] kept' "$work/said")
check "$kept >= $before && $(grep -c '\] graded' "$work/said") == $count - $kept" "begun again: $kept kept, the others graded"
# Step 2.2 is worth 2.8 points; of a wrong one the picture may be right.
check "$(grep -c '^right[0-9]*,graded,2\.[0-9]*,100,' "$work/out/class.csv") == ($count + $count % 2) / 2" "right work has its points"
check "$(grep -c '^wrong[0-9]*,graded,0[.0-9]*,100,' "$work/out/class.csv") == ($count - $count % 2) / 2" "and wrong work has not"
ok "no work left behind" not ls "$work/out/.parts/"part.* "${TMPDIR:-/tmp}/photonlab-class.$UID."*
finish
