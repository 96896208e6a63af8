#!/usr/bin/env bash
# Is everything that the notes name really there, and do their numbers come from their figures' data? Usage: check_notes.sh BUILD
# In a students' archive, which holds fewer files, it checks what there is.
set -u
build=${1:-build}
notes=$build/notes
figures=course_notes/figures
. tests/common.sh

# verdict TEXT FILE: a line that is good if FILE, with the complaints, is empty.
verdict() {
    if [ -s "$2" ]; then bad "$1:"; sed 's/^/    /' "$2"; else good "$1"; fi
}

gather() {
    local page name id target file
    for page in course_notes/*.md; do
        name=$(basename "$page" .md)
        pandoc -f markdown -t plain -o /dev/null --lua-filter course_notes/facts.lua "$page" >"$work/$name.one" || exit 1
        sed "s/^/$name	/" "$work/$name.one"
    done >"$work/facts"
    # What a link can lead to is what the pages really have, not what the sources promise.
    for page in "$notes"/*.html; do
        name=$(basename "$page" .html)
        [ -f "course_notes/$name.md" ] || continue
        echo "$name.html"
        grep -o ' id="[^"]*"' "$page" | sed "s|^ id=\"\(.*\)\"|$name.html#\1|"
    done >"$work/targets"
    "$build/photonlab" steps | awk -F '\t' '{ print $1, $6, "exercises/" $4 ".c" }' >"$work/steps"
}

# resolve: reads "WHERE<TAB>TARGET", prints the targets that are nowhere.
resolve() {
    awk -F '\t' 'NR == FNR { there[$0] = 1; next } !($2 in there) { print $1 ": " $2 " is nowhere" }' "$work/targets" -
}

check_links() {
    awk -F '\t' '$2 == "link" { t = $3; if (t ~ /^https:\/\//) next
                                if (t ~ /^#/) t = $1 ".html" t; print $1 ".md\t" t }' "$work/facts" | resolve >"$work/wrong"
    verdict "$(awk -F '\t' '$2 == "link"' "$work/facts" | wc -l) links between chapters lead somewhere" "$work/wrong"
    awk '{ print "step " $1 "\t" $2 }' "$work/steps" | resolve >"$work/wrong"
    verdict "every step's chapter and anchor in the step table" "$work/wrong"
    git ls-files -co --exclude-standard '*.md' 2>/dev/null | grep -v '^course_notes/' | while IFS= read -r file; do
        grep -oE '[0-9a-z_]+\.html#[0-9a-z-]+' "$file" | sed "s|^|$file	|"
        grep -oE 'course_notes/[0-9a-z_]+\.(md|sh|lua|mk)' "$file" | while IFS= read -r named; do
            [ -f "$named" ] || printf '%s\t%s\n' "$file" "$named"
        done
    done | resolve >"$work/wrong"
    for readme in exercises/*/README.md; do
        chapter=$(sed -n 's/.*notes: `\([0-9a-z_]*\)`, section.*/\1/p' "$readme")
        sed -n 's/^| \([1-9][0-9]*\.[1-9][0-9]*\) |[^|]*|[^|]*| `\([a-z-]*\)`.*/\1 \2/p' "$readme" | sed "s|\$| $chapter|"
    done | awk 'NR == FNR { want[$1] = $2; next } { found[$1] = $3 ".html#" $2 }
        END { for (id in want) if (found[id] != want[id]) print "exercises/: step " id ": " found[id] ", in the step table " want[id] }' \
        "$work/steps" - >>"$work/wrong"
    verdict "the READMEs name chapters and sections that there are" "$work/wrong"
}

# The links that a student clicks in a report, in a report.
check_report() {
    [ -x "$build/judge" ] && [ -x "$build/write_reports" ] || return
    mkdir -p "$work/none" "$build/notes-check/report"
    "$build/judge" --build "$build" --work "$work/judge" --compiler cc --flags "-O1 -fPIC" --link -shared --code "$work/none" \
        --report "$build/notes-check/report" >/dev/null 2>&1
    "$build/write_reports" --notes ../../notes "$build/notes-check/report"
    grep -oE 'href="\.\./\.\./notes/[^"]*"' "$build/notes-check/report/index.html" | sed 's|href="../../notes/\([^"]*\)"|report	\1|' |
        sort -u >"$work/links"
    resolve <"$work/links" >"$work/wrong"
    [ "$(wc -l <"$work/links")" = "$(wc -l <"$work/steps")" ] || echo "$(wc -l <"$work/links") links in the report" >>"$work/wrong"
    verdict "every step's link in a report" "$work/wrong"
}

# Chapter 0 shows what the terminal says: its first try, judged. How many points that is out of, tests/judge/points.txt decides.
check_terminal() {
    [ -x "$build/judge" ] && [ -s $figures/0_first.txt ] || return
    local points='s|/[0-9.]*$|/…|; s|^0 of [0-9.]* points|0 of … points|'
    mkdir -p "$work/first/1_diffuse_photon_map"
    { echo '#include "photonlab.h"'; sed -n '/^Vec3 reflect/,/^}/p' course_notes/0_start_here.md; } >"$work/first/1_diffuse_photon_map/1.1_reflect.c"
    "$build/judge" --build "$build" --work "$work/judge" --compiler cc --flags "-O1 -fPIC" --link -shared --code "$work/first" --step 1.1 2>&1 |
        sed "1{/^\$/d;}; s/ *\$//; $points" >"$work/said"
    grep -v '^make: ' $figures/0_first.txt | sed "$points" | diff - "$work/said" >"$work/wrong"
    [ ! -s "$work/wrong" ] || echo "it says something else now; \`make figures CHAPTER=0\` writes it down" >>"$work/wrong"
    verdict "chapter 0 shows what the terminal says" "$work/wrong"
}

# The letters in a step's contract must be those of its section: θ here is θ there.
letters='θ:theta φ:(var)?phi α:alpha η:eta ρ:rho Φ:Phi π:pi'
check_letters() {
    awk -v id="$1" -v letters="$letters" '
        BEGIN { n = split(letters, pair, " ") }
        FNR == NR { if ($0 ~ /^\/\/ [1-9][0-9]*\.[1-9][0-9]*  /) mine = ($2 == id); if ($0 !~ /^\/\//) mine = 0
                    if (mine && $0 ~ /^\/\/    /) contract = contract $0; next }
        { tex = tex $0 }
        END { for (i = 1; i <= n; i++) { split(pair[i], p, ":")
                if (index(contract, p[1]) && tex !~ ("[\\\\]" p[2])) print id ": " p[1] " of the contract is not in the formulas" } }' \
        lib/steps/*.h "$2"
}

check_steps() {
    local id target file chapter anchor
    : >"$work/wrong"
    : >"$work/strange"
    while read -r id target file; do
        chapter=${target%%.html*} anchor=${target#*#}
        awk -F '\t' -v c="$chapter" -v a="$anchor" '$1 == c && $2 == "file" && $4 == a { print $3 }' "$work/facts" | grep -qxF "$file" ||
            echo "$id: section $target does not name $file" >>"$work/wrong"
        grep -q "^| ${id%.*} | .*($chapter.html) |" course_notes/0_start_here.md ||
            echo "$id: course_notes/0_start_here.md has no row for its stage that leads to $chapter.html" >>"$work/wrong"
        grep -q "^| ${id/./\\.} |.*($target)" course_notes/index.md ||
            echo "$id: course_notes/index.md has no row that leads to $target" >>"$work/wrong"
        awk -F '\t' -v c="$chapter" -v a="$anchor" '$1 == c && $2 == "formula" && $4 == a { print $3 "\t" $5 }' "$work/facts" >"$work/tex"
        grep -q '^display' "$work/tex" || echo "$id: section $target has no formula on a line of its own" >>"$work/wrong"
        check_letters "$id" "$work/tex" >>"$work/strange"
    done <"$work/steps"
    awk -F '\t' '$2 == "file" { print $3 }' "$work/facts" | sort -u | while IFS= read -r file; do
        [ -e "$file" ] || echo "there is no $file" >>"$work/wrong"
    done
    verdict "each step's section names its file and has its formula" "$work/wrong"
    verdict "formulas use the letters of the steps' contracts" "$work/strange"
}

check_figures() {
    local name
    awk -F '\t' 'function number(name) { sub(/_.*/, "", name); return name }
        $2 == "figure" { where = $1 ": " ($4 == "" ? "a figure without file=" : $4)
        if ($4 == "" || $4 !~ /^[0-9a-z]+_[a-zA-Z0-9_]*\.(png|svg|txt)$/ || number($4) != number($1)) print where ": a strange name"
        if (seen[$4]++) print where ": made twice"
        if ($8 == "") print where ": no command"
        if ($3 == "figure" && length($6) < 12) print where ": alt= does not say what is seen"
        if ($3 == "figure" && length($7) < 12) print where ": no caption"
        if ($3 == "figure" && $5 == "") print where ": no id" }
        $2 == "figure" { commands[$1] = 1 }
        $2 == "image" { n = $3; sub(/^figures\//, "", n)
            if (n == $3 || number(n) != number($1)) print $1 ": " $3 " is no figure of this chapter"
            if (length($4) < 8) print $1 ": " $3 " has no words for who cannot see it"
            loose[$1] = $3 }
        END { for (page in loose) if (!(page in commands)) print page ": no command makes " loose[page] }' "$work/facts" >"$work/wrong"
    awk -F '\t' '$2 == "figure" { print $4 } $2 == "image" { sub(/^figures\//, "", $3); print $3 }' "$work/facts" | sort -u >"$work/named"
    while IFS= read -r name; do
        [ -s "$figures/$name" ] || echo "$name is missing; \`make figures\` makes it"
    done <"$work/named" >>"$work/wrong"
    ! git rev-parse >/dev/null 2>&1 || git ls-files $figures | sed 's|.*/||' | sort | comm -13 - "$work/named" | sed 's/$/ is not in git/' >>"$work/wrong"
    verdict "$(wc -l <"$work/named") figures: each is there, with command, alt and caption" "$work/wrong"

    # A file may also be written beside a figure, or be read by what makes one: its name stands there.
    { cat "$work/facts"; cat $figures/src/* 2>/dev/null; } >"$work/texts"
    ls $figures/*.* $figures/src/* 2>/dev/null | sed 's|.*/||; s/\.c$//' |
        awk -v of="$work/texts" 'BEGIN { while ((getline line <of) > 0) text = text line "\n" } !index(text, $0) { print $0 " is named nowhere" }' >"$work/wrong"
    verdict "no figure and no script that nothing uses" "$work/wrong"
}

check_numbers() {
    awk -F '\t' '$2 == "number" { split($4, from, ":"); print $1 "\t" $3 "\t" from[1] "\t" substr($4, length(from[1]) + 2) }' "$work/facts" |
        awk -F '\t' -v folder="$figures/" '
        function value(file, key,    line, word) {
            if (!((file) in read_in)) { read_in[file] = 1
                while ((getline line <(folder file)) > 0) if (split(line, word, " ") >= 2) kept[file, word[1]] = word[2] }
            return (file, key) in kept ? kept[file, key] : "" }
        { text = $2; gsub(/−/, "-", text); gsub(/[  ]/, "", text); v = value($3, $4)
          if (v == "") { print $1 ": " $3 " has no line " $4; next }
          if (text !~ /^[-+]?[0-9]+(\.[0-9]+)?$/) { print $1 ": \"" $2 "\" is no number"; next }
          digits = index(text, ".") ? length(text) - index(text, ".") : 0
          off = text - v; if (off < 0) off = -off
          if (off > 0.5 * 10 ^ -digits * 1.000001 + 1e-9 * (v < 0 ? -v : v))
              print $1 ": " $2 " in the text, " v " in " $3 " (" $4 ")" }' >"$work/wrong"
    verdict "$(awk -F '\t' '$2 == "number"' "$work/facts" | wc -l) numbers in the text are those of their data" "$work/wrong"
}

# The gallery: each known mistake stands, with the judge's words, in the tile of the picture that shows it, or in the list of those that
# no tile shows.
check_gallery() {
    [ -d tests/mistakes ] && [ -s $figures/gallery_seen.txt ] && [ -f course_notes/gallery.md ] || return
    awk -v OFS='\t' 'FNR == 1 { split(FILENAME, place, "/"); print place[3], $0 }' tests/mistakes/[1-9]*.*/text >"$work/known"
    # Lines of `tile TAB ID TAB WORDS` and of `unseen TAB STEP TAB WORDS`.
    awk -v OFS='\t' '
        { gsub(/\\/, "") }
        /^::: *\{\.tile/ { id = $0; sub(/.*#/, "", id); sub(/}.*/, "", id); words = ""; next }
        /^:::$/ { if (id ~ /^m-/) print "tile", id, words; id = ""; next }
        { words = words " " $0 }
        /^\| [1-9][0-9]*\.[1-9][0-9]* \|/ { split($0, cell, / *\| */); print "unseen", cell[2], cell[3] }' \
        course_notes/gallery.md | tr -s ' ' >"$work/gallery"
    awk -F '\t' '
        function id_of(m) { gsub(/[._]/, "-", m); return "m-" m }
        FILENAME ~ /known$/ { known[$1] = $2; next }
        FILENAME ~ /gallery$/ { if ($1 == "tile") { tile[$2] = $3; if (++count[$2] > 1) print "tile #" $2 ": twice" }
                                else row[$2 ": " $3]++; next }
        split($0, word, " ") >= 7 { seen[word[1]] = word[6]; picture[word[1]] = word[7] }
        END { for (m in known) if (!(m in seen)) print m ": gallery_seen.txt does not know it; `make figures CHAPTER=gallery` plays it"
                  else if (seen[m] == "yes") { id = id_of(picture[m]); wanted_tile[id] = 1
                      if (!index(tile[id], known[m])) print m ": tile #" id " does not say \"" known[m] "\"" }
                  else { id = m; sub(/_.*/, "", id); wanted[id ": " known[m]]++ }
              for (m in seen) if (!(m in known)) print m ": in gallery_seen.txt, but no known mistake"
              for (id in tile) if (!(id in wanted_tile)) print "tile #" id ": no known mistake that a picture shows"
              for (line in wanted) if (row[line] != wanted[line])
                  print line ": " row[line] + 0 " times in the list of those that no tile shows, not " wanted[line]
              for (line in row) if (!(line in wanted)) print line ": listed as shown by no tile, but is none of these" }' \
        "$work/known" "$work/gallery" $figures/gallery_seen.txt | sort >"$work/wrong"
    verdict "$(wc -l <"$work/known") known mistakes stand in the gallery" "$work/wrong"
}

check_pages() {
    local page name
    for page in course_notes/*.md; do
        name=$(basename "$page" .md)
        [ -s "$notes/$name.html" ] && [ ! "$page" -nt "$notes/$name.html" ] || { echo "$name.html has not been built from what $page is"; continue; }
        xmllint --noout "$notes/$name.html" 2>&1 | head -5
        ids=$(grep -o ' id="[^"]*"' "$notes/$name.html" | sort | uniq -d)
        [ -z "$ids" ] || echo "$name: twice: $ids"
        grep -q '<span class="math' "$notes/$name.html" && echo "$name: TeX that pandoc could not make MathML of: $(
            grep -o '<span class="math[^<]*' "$notes/$name.html" | head -3)"
        grep -q 'src=""' "$notes/$name.html" && echo "$name: an image is empty"
    done >"$work/wrong"
    verdict "the pages are well-formed, their formulas MathML" "$work/wrong"
    for page in "$notes"/*.html; do
        grep -oE '<(script|link|iframe|object|embed|form|base)[ >]|(src|srcset|data|poster)="[^d"][^"]*"|url\([^)]*\)|@import[^;]*|href="(http:|//|file:|\.\.|/)[^"]*"' \
            "$page" | sed "s|^|$(basename "$page"): |"
    done >"$work/wrong"
    verdict "nothing is fetched from elsewhere" "$work/wrong"
}

gather
check_pages
check_links
check_report
check_terminal
check_steps
check_figures
check_gallery
check_numbers
finish
