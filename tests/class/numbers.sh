#!/usr/bin/env bash
# What a class costs, and what the table and the pages do at ten thousand rows, which are copies of a few: into numbers.md beside.
# `make class-numbers` runs it. COUNT=4 submissions of all steps are graded, ROWS=10000 made of them.
set -u
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
cd "$root" || exit 1
build=$(cd "$PHOTONLAB_BUILD" && pwd)
export PHOTONLAB_BUILD=$build
count=${COUNT:-4} rows=${ROWS:-10000}
command time true 2>/dev/null || { echo "class-numbers needs the program time (on Debian: apt-get install time)"; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# All steps, with a known mistake in every second, another for each submission.
for i in $(seq "$count"); do
    to=$work/class/student$i
    mkdir -p "$work/class" && cp -R solutions "$to"
    for source in solutions/*/*.c; do
        step=${source##*/} step=${step%%_*}
        mistakes=(tests/mistakes/"$step"_*/)
        patch=${mistakes[i % ${#mistakes[@]}]}a.patch
        [ $(((10#${step%.*} + 10#${step#*.} + i) % 2)) = 0 ] || patch -s -d "$to" -p2 <"$patch" || exit 1
    done
done

# cost COMMAND…: seconds of processor time, of it and all that it starts, and its largest process in MB.
cost() { command time -f '%U %S %M' -o "$work/time" "$@" >"$work/said" 2>&1 || { cat "$work/said" >&2; exit 1; }
    awk '{ printf "%.1f %.0f\n", $1 + $2, $3 / 1024 }' "$work/time"; }
export PHOTONLAB_DIR=$work/class PHOTONLAB_OUT=$work/out PHOTONLAB_PARALLEL_FLAGS=""
bash "$here/class.sh" plan || exit 1
read -r seconds memory < <(cost bash "$here/class.sh" grade "$work/out" 1/1)
read -r again _ < <(cost bash "$here/class.sh" grade "$work/out" 1/1)
disk=$(du -sk --exclude=.parts "$work/out" | cut -f1)
each=$(awk "BEGIN { printf \"%.1f\", $seconds / $count }")

echo "making $rows rows of $count" >&2
big=$work/big
mkdir -p "$big/.parts"
for i in $(seq "$rows"); do
    printf -v name 'student%05d' "$i"
    cp -al "$work/out/student$((i % count + 1))" "$big/$name"
    printf '%s\0' "$name" >&3
    printf '%s\0%s\0' "$work/class/student$((i % count + 1))" "$name" >&4
    printf 'Student %d,student%05d,group %d,s%05d@example.org\n' "$i" "$i" $((i % 40)) "$i" >&5
done 3>"$big/.parts/.names" 4>"$big/.parts/.list" 5>"$work/roster"
{ echo name,login,group,email; sort -t, -k3,3 "$work/roster"; } >"$work/roster.csv"
read -r table table_memory < <(cost "$build/class_table" --roster "$work/roster.csv" --pictures course_notes/figures "$big" "$big/.parts/.names")
kilobytes() { du -k "$big/$1" | cut -f1; }

# A browser opens the page, sorts it by points and finds one row; an empty page is what it needs for itself.
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
looks() {
    cost "$browser" --headless --disable-gpu --no-sandbox --single-process --no-zygote --user-data-dir="$work/profile" \
        --timeout=600000 --dump-dom "file://$1" | cut -d' ' -f1
}
opened="no chromium here"
if [ -n "$browser" ]; then
    cat "$big/index.html" - >"$work/page.html" <<'END'
<script>addEventListener('load',()=>{const lay=()=>document.body.offsetHeight;lay();
[...t.tHead.rows[0].cells].find(c=>c.textContent==='points').click();lay();
const f=document.getElementById('find');f.value='student00777';f.dispatchEvent(new Event('input'));lay();
document.body.textContent=`${b.rows.length} row of ${b.rows[0].cells[1].textContent}`})</script>
END
    echo '<p>' >"$work/empty.html"
    looks "$work/empty.html" >"$work/own" # the first makes the profile
    opened=$(looks "$work/page.html")
    grep -q '1 row of student00777' "$work/said" || { echo "the page does not find a row: $(tail -c 200 "$work/said")" >&2; exit 1; }
    opened="$opened s, $(looks "$work/empty.html") s of it for an empty page"
fi
# Identical work: reading costs for each submission, so that of a few tells; comparing for each pair, so all rows are compared.
alike="not tried" read_each=0 compared=0
python=$build/alike/bin/python
if [ -x "$python" ]; then
    read -r compared _ < <(cost "$python" "$here/alike.py" . "$build" "$big")
    mkdir -p "$work/few/.parts"
    for i in $(seq 100); do
        cp -al "$work/class/student$((i % count + 1))" "$work/few/$i"
        printf '%s\0%s\0' "$work/few/$i" "$i"
    done >"$work/few/.parts/.list"
    read -r read_each _ < <(cost "$python" "$here/alike.py" . "$build" "$work/few")
    alike=$(awk "BEGIN { printf \"%.0f minutes of a core: %.2f s to read a submission, %s s to compare all with all\", ($compared + $rows * $read_each / 100) / 60, $read_each / 100, $compared }")
fi

cat >"$here/numbers.md.new" <<END
# What a class costs

Written by \`make class-numbers\`: $count submissions of all $(ls solutions/*/*.c | wc -l) steps, a known mistake in every second of
them, graded on $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1); and $rows rows made of copies. Processor time, so that other work does not matter;
of a core, since one submission uses one.

| a submission | |
|---|---|
| graded | $each s |
| looked at again, nothing new | $(awk "BEGIN { printf \"%.2f\", $again / $count }") s |
| memory, largest process | $memory MB |
| its report on the disk | $((disk / count)) kB |

| a course of $rows | |
|---|---|
| graded, in hours of a core | $(awk "BEGIN { printf \"%.0f\", $seconds / $count * $rows / 3600 }") |
| on 64 cores, \`make class-slurm SHARDS=64\` | $(awk "BEGIN { printf \"%.0f\", $seconds / $count * $rows / 60 / 64 }") minutes |
| reports on the disk | $(awk "BEGIN { printf \"%.0f\", $disk / $count * $rows / 1e6 }") GB |
| table and pages made | $table s, $table_memory MB of memory |
| \`class.csv\`, \`index.html\`, \`lecture.html\` | $(kilobytes class.csv), $(kilobytes index.html), $(kilobytes lecture.html) kB |
| \`index.html\` opened by a browser, sorted, one row found | $opened |
| \`make class-alike\` | $alike |
END
mv "$here/numbers.md.new" "$here/numbers.md" && cat "$here/numbers.md"
