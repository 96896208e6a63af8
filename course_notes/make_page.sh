#!/bin/sh
# One chapter as one HTML file. Usage: make_page.sh BUILD NAME
set -eu
build=$1 name=$2
here=course_notes
out=$build/notes
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
NOTES_PAGE=$name NOTES_PAGES=$out/.pages NOTES_FIGURES=$here/figures \
    pandoc "$@" -o "$out/.parts/$name.html" "$here/$name.md"
mv "$out/.parts/$name.html" "$out/$name.html"
