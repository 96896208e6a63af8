#!/usr/bin/env bash
# All chapters as one PDF, where a TeX is installed; where none is, one sentence. Usage: make_pdf.sh BUILD
set -u
build=$1
out=$build/notes
here=course_notes
install="On Debian: sudo apt-get install texlive-xetex texlive-latex-recommended texlive-fonts-recommended lmodern fonts-dejavu librsvg2-bin"
engine=""
for name in xelatex lualatex tectonic; do
    [ -n "$engine" ] || ! command -v "$name" >/dev/null || engine=$name
done
if [ -z "$engine" ]; then
    echo "no PDF: there is no xelatex, lualatex or tectonic here. $install"
    exit 0
elif ! command -v rsvg-convert >/dev/null; then
    echo "no PDF: there is no rsvg-convert here, which takes SVG figures into it. $install"
    exit 0
fi
newest=$(find "$here" -type f \( -name '*.md' -o -name '*.lua' -o -name '*.tex' -o -path '*/figures/*.*' \) -newer "$out/photonlab.pdf" 2>/dev/null)
[ ! -s "$out/photonlab.pdf" ] || [ -n "$newest" ] || exit 0

mkdir -p "$out/.parts"
parts=()
while IFS=$'\t' read -r name _; do
    NOTES_PAGE=$name NOTES_PAGES=$out/.pages NOTES_FIGURES=$here/figures \
        pandoc -f markdown -t json --lua-filter "$here/figure.lua" -o "$out/.parts/$name.json" "$here/$name.md" || exit 1
    parts+=("$out/.parts/$name.json")
done <"$out/.pages"
if pandoc -f json "${parts[@]}" -s --no-highlight --toc --toc-depth=2 --pdf-engine="$engine" -H "$here/pdf.tex" \
    -V documentclass=article -V papersize=a4 -V geometry=margin=2.3cm -V fontsize=11pt -V colorlinks=1 -V linkcolor=NavyBlue \
    -V urlcolor=NavyBlue -V mainfont="DejaVu Serif" -V mainfontoptions=Scale=0.88 -V sansfont="DejaVu Sans" -V sansfontoptions=Scale=0.88 \
    -V monofont="DejaVu Sans Mono" -V monofontoptions=Scale=0.8 -V lang=en-GB -M title="photonlab: course notes" \
    -o "$out/.parts/photonlab.pdf" 2>"$out/.parts/pdf.log"; then
    mv "$out/.parts/photonlab.pdf" "$out/photonlab.pdf"
    grep -i 'missing character\|could not' "$out/.parts/pdf.log" | sort | uniq -c | sort -rn | head -20
    echo "$out/photonlab.pdf"
else
    echo "the PDF could not be made:" >&2
    tail -20 "$out/.parts/pdf.log" >&2
    exit 1
fi
