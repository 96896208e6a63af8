#!/bin/sh
# One chapter as one HTML file. Usage: make_page.sh FOLDER NAME [MODULE.wasm]: with the module, figures that can be moved move.
set -eu
out=$1 name=$2 module=${3:-}
here=course_notes
mkdir -p "$out/.parts"

# Style and template in one, so that the page needs no other file.
sed -e "/^@STYLE@\$/{
r $here/style.css
d
}" "$here/template.html" >"$out/.parts/$name.template"

# beside WHICH: "name<TAB>title" of the chapter before or after this one.
beside() {
    awk -F '\t' -v name="$name" -v which="$1" '
        $1 == name { if (which == "before") print last; found = NR } { last = $0 }
        which == "after" && found && NR == found + 1' "$out/.pages"
}
tab=$(printf '\t')
before=$(beside before)
after=$(beside after)
[ "$name" != index ] || after=$(head -1 "$out/.pages")
set -- -f markdown -t html5 --standalone --mathml --no-highlight --toc --toc-depth=2 \
    --template "$out/.parts/$name.template" --lua-filter "$here/figure.lua"
[ -z "$before" ] || set -- "$@" -V "previous=${before%%"$tab"*}" -V "previous-title=${before#*"$tab"}"
[ -z "$after" ] || set -- "$@" -V "next=${after%%"$tab"*}" -V "next-title=${after#*"$tab"}"
[ "$name" = index ] || set -- "$@" -V contents=1
[ -z "$module" ] || export NOTES_LIVE=1
NOTES_PAGE=$name NOTES_PAGES=$out/.pages NOTES_FIGURES=$here/figures \
    pandoc "$@" -o "$out/.parts/$name.html" "$here/$name.md"

# Pandoc's MathML, spaced as TeX would. Brackets around nothing tall do not stretch: browsers pad those that may. A name like cos
# gets thin spaces, none at a formula's beginning, after a sign or before a bracket. A minus after a sign belongs to the right.
# \mathrm is upright in browsers that do not know <mstyle mathvariant>.
flat='([^<]|</?m([inrs]|text)[^>]*>|</?mo(ver)?>|<mo(ver)? ([^s]|stretchy="f)[^>]*>)*'
cat >"$out/.parts/$name.sed" <<SPACES
s@<h[2-4][^>]* id="([^"]*)"[^>]*>@&<a class="permalink" href="#\1" aria-label="link to this section">¶</a>@
/<math/!b
s@(m(ax|in)size="[0-9.]+)"@\1em"@g
:letters
s@(<mstyle mathvariant="normal"><mi>[^<]*)</mi><mi>@\1@
t letters
s@<mstyle mathvariant="normal">(<mi)(>[^<]*</mi>)</mstyle>@\1 mathvariant="normal"\2@g
:brackets
s@(<mo stretchy=")true(" form="prefix">[[(]</mo>$flat<mo stretchy=")true(" form="postfix">[])]</mo>)@\1false\2false\8@
t brackets
s@<mo>([a-z][a-z]+)</mo>@<mo lspace="0.17em" rspace="0.17em">\1</mo>@g
s@((<semantics>|<mrow>|[^)]</mo>|="prefix">.</mo>)(<m(sub|sup|subsup|row)>)*<mo lspace=")0.17em@\10@g
s@( rspace=")0.17em(">[a-z]+</mo>(<mrow>)?<mo [^>]*form="prefix")@\10\2@g
s@(</mo>(<mspace [^>]*></mspace>)*)<mo>−</mo>@\1<mo form="prefix">−</mo>@g
s@<mo>=</mo>(</mrow><annotation)@<mo rspace="0">=</mo>\1@g
SPACES
sed -E -f "$out/.parts/$name.sed" "$out/.parts/$name.html" >"$out/.parts/$name.spaced"

if [ -n "$module" ] && grep -qE 'class="(live|tile right)"' "$out/.parts/$name.spaced"; then
    sh web/figures/add_figures.sh "$module" "$out/.parts/$name.spaced" >"$out/.parts/$name.live"
    mv "$out/.parts/$name.live" "$out/.parts/$name.spaced"
fi
mv "$out/.parts/$name.spaced" "$out/$name.html"
