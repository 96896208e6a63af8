#!/usr/bin/env bash
# Did a change of shape change what comes out? Builds another commit beside this one and compares what both make (see
# outputs.sh). Usage, in the checkout: same_as.sh COMMIT BUILD     (or: make check-same AS=COMMIT)
set -u
build=$2
commit=$(git rev-parse --verify --quiet "$1^{commit}") || { echo "AS=$1: git knows no such commit"; exit 2; }
there=$build/as/$commit
mkdir -p "$there"
git archive "$commit" | tar -x -C "$there" || exit 1
make -s -C "$there" BUILD=build judge meshes >"$there/log" 2>&1 || { tail -5 "$there/log"; exit 1; }
cp tests/outputs.sh "$there/tests/"
(cd "$there" && bash tests/outputs.sh build) >"$there/outputs" &
bash tests/outputs.sh "$build" >"$build/as/outputs"
wait
diff "$there/outputs" "$build/as/outputs" | sed -n 's/^< [^ ]* /  was, and is not the same: /p; s/^> [^ ]* /  is, and was not the same: /p'
changed=$(diff "$there/outputs" "$build/as/outputs" | grep -c '^<')
echo "$(($(wc -l <"$there/outputs") - changed)) passed, $changed failed"
[ "$changed" = 0 ]
