#!/usr/bin/env bash
# `make class-alike`: a class of the right solutions that tests/ has, each by another hand, and one of them again with other names
# and another layout. `make check-alike` runs it. Usage: alike.sh PYTHON
set -u
here=$(cd "$(dirname "$0")/.." && pwd)
root=$(cd "$here/../.." && pwd)
. "$here/../common.sh"
cd "$root" || exit 1
build=$(cd "$PHOTONLAB_BUILD" && pwd)

# Hand n wrote the nth alternative of each step.
for folder in tests/alternatives/*/*/; do
    n=0
    stage=$(basename "$(dirname "$folder")")
    for file in "$folder"*.c; do
        n=$((n + 1))
        mkdir -p "$work/class/hand$n/$stage"
        cp "$file" "$work/class/hand$n/$stage/$(basename "$folder").c"
    done
done
rm -rf "$work/class/hand5" # few steps have five
cp -R solutions "$work/class/hand0"
cp -R "$work/class/hand2" "$work/class/copy"
find "$work/class/copy" -name '*.c' -exec sed -i -E 's/\b(direction|normal|power|rng|cosine|phi|radius|sum)\b/my_\1/g; s/^    /\t/; s/ *\/\/.*//; /^$/d; s/ \{$/\n{/' {} +
cp -R "$work/class/hand2" "$work/class/copy2"
mkdir -p "$work/out/.parts"
for path in "$work"/class/*; do printf '%s\0%s\0' "$path" "$(basename "$path")"; done >"$work/out/.parts/.list"
ok "alike: written" "$1" "$here/alike.py" "$root" "$build" "$work/out"
page=$work/out/alike.html
check "$(grep -c ' · ' "$page") == 1" "alike: one group is listed: $(grep -o '<td>[a-z0-9]* · [a-z0-9]*' "$page" | tr '\n' ' ')"
ok "alike: the copies, with all steps the same, whatever the names" grep -qE "<td class=n>28–28<td>copy · copy2 · hand2<td>1.1 .* 6.4$" "$page"
ok "alike: the base rate stands in it" grep -qE '<tr><td>2.4<td class=n>7<td class=n>[0-9]<td class=n>[0-9.]* %<td class=n>[0-9]+ of 10' "$page"
ok "alike: and that it proves nothing" grep -q 'proves nothing' "$page"
finish
