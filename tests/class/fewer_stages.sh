# The students' archive of a course with the points and the stages that points.txt says. To be sourced by handout.sh.

# fewer_stages TOP LAST: what students write ends with stage LAST: empty steps, lists, hints, wrong pictures. What the program can
# do besides stays, and the chapters about it stay, to be read.
fewer_stages() {
    local top=$1 last=$2 later="[$(($2 + 1))-9]"
    (cd "$top" && rm -rf exercises/$later* exercises/.stubs/$later* lib/steps/hints/$later* course_notes/figures/gallery_${later}_*)
    sed -i -e '/^<!-- all stages -->$/,/^<!-- end of all stages -->$/d' -e "/^| \[*${later}[ .][^|]*|/d" "$top/README.md" \
        "$top/exercises/README.md" "$top"/course_notes/{0_start_here,index,gallery}.md || return 1
    sed -i "1s/\$/, beyond the course\n\n*Your course ends with stage $last. This chapter is for those who like to read on: the program does what it tells, and nobody asks you for its steps.*/
        /^\*Step $later\.[0-9]*, \`exercises/d" "$top/course_notes/"${later}_*.md || return 1
    sed -i -z -E "s/\[([^]]*)\]\(gallery\.html#[a-z]*-${later}[^)]*\)/\1/g" "$top/course_notes/"${later}_*.md || return 1
    awk -v "tile=[(]#m-$later-" -v "section=[{]#step-$later-" '
        function show() { if (bullet !~ tile) printf "%s", bullet; bullet = "" }
        /^- / { show(); bullet = $0 "\n"; next }
        bullet && /^  / { bullet = bullet $0 "\n"; next }
        { show() }
        /^## / { away = $0 ~ section }
        !away' "$top/course_notes/gallery.md" >"$top/gallery.new" && mv "$top/gallery.new" "$top/course_notes/gallery.md" || return 1
    sed -i "s/ $later\.[0-9]*//g" "$top"/course_notes/figures/0_{rendered,submit}.txt
}

# first_points TOP POINTS STEPS: chapter 0 shows what the terminal will say of step 1.1, that is worth so much, in a course of so
# many steps.
first_points() {
    local file old
    old=$(sed -n 's/ of .* points$//p' "$1/course_notes/figures/0_all.txt")
    for file in "$1"/course_notes/figures/0_*.txt; do
        awk -v "old=$old" -v "new=$2" -v "steps=$3" '
            / points$/ { sub(" of " old " ", " of " new " "); sub("^" old " ", new " ") }
            / not started$/ && $1 > 0 { $1 = steps - 1 }
            /^  [^ ]+ 1\.1 / { wide = length($0); right = $NF; sub(/ +[^ ]+$/, "")
                               sub("/" old "$", "/" new, right); sub("^" old "/", new "/", right)
                               $0 = sprintf("%s%" wide - length($0) "s", $0, right) }
            { print }' "$file" >"$file.new" && mv "$file.new" "$file" || return 1
    done
}
