#!/bin/sh
# A page with what its live figures, or its pairs of right and wrong, need before its end. Usage: add_figures.sh MODULE.wasm PAGE.html
set -eu
module=$1 page=$2
sed '/^<\/body>$/,$d' "$page"
if grep -q 'class="tile right"' "$page"; then
    cat web/figures/tiles.html
    sed -n '/^<\/body>$/,$p' "$page"
    exit
fi
names=$(grep -o 'data-live="[a-z]*"' "$page" | sed 's/.*"\(.*\)"/\1/' | LC_ALL=C sort -u)
figures=""
for name in $names; do
    [ -f "web/figures/live/$name.js" ] || { echo "$page: there is no live figure '$name'; they are web/figures/live/*.js" >&2; exit 1; }
    figures="$figures web/figures/live/$name.js"
done
scenes=$(sed -n "s/^    scene: '\(.*\)',/scenes\/\1/p" $figures | LC_ALL=C sort -u)
template=$(mktemp)
trap 'rm -f "$template"' EXIT
{
    sed '/^@FIGURES@$/,$d' web/figures/figures.html
    for figure in $figures; do echo "@FILE $figure@"; done
    sed '1,/^@FIGURES@$/d' web/figures/figures.html
} >"$template"
sh web/page/make_page.sh "$template" "$module" $scenes
sed -n '/^<\/body>$/,$p' "$page"
