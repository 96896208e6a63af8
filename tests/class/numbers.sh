#!/usr/bin/env bash
# What a class costs, and what the table and the pages do at ten thousand rows, which are copies of a few: into numbers.md beside.
# `make class-numbers` runs it. COUNT=8 submissions of all steps are graded, ROWS=10000 made of them.
set -u
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
cd "$root" || exit 1
build=$(cd "$PHOTONLAB_BUILD" && pwd)
export PHOTONLAB_BUILD=$build
count=${COUNT:-8} rows=${ROWS:-10000}
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

# A browser says itself how long it took.
browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
opened="no chromium here" sorted="" filtered=""
if [ -n "$browser" ]; then
    cat "$big/index.html" - >"$work/page.html" <<'END'
<script>addEventListener('load',()=>setTimeout(()=>{const lay=()=>document.body.offsetHeight;lay();const said=[performance.now()];
const timed=f=>{const t=performance.now();f();lay();said.push(performance.now()-t)};
timed(()=>[...t.tHead.rows[0].cells].find(c=>c.textContent==='points').click());
timed(()=>{const f=document.getElementById('find');f.value='student00777';f.dispatchEvent(new Event('input'))});
document.body.textContent='TIMES '+said.map(x=>(x/1000).toFixed(1)).join(' ')+' END'}))</script>
END
    read -r opened sorted filtered < <("$browser" --headless --disable-gpu --no-sandbox --user-data-dir="$work/profile" --timeout=120000 \
        --dump-dom "file://$work/page.html" 2>/dev/null | sed -n 's/.*TIMES \(.*\) END.*/\1/p')
fi
alike="not tried"
[ ! -x "$build/alike/bin/python" ] || read -r alike _ < <(cost "$build/alike/bin/python" "$here/alike.py" . "$build" "$big")

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
| \`index.html\` opened by a browser; sorted; one row found | $opened s; $sorted s; $filtered s |
| \`make class-alike\` | $alike s |
END
mv "$here/numbers.md.new" "$here/numbers.md" && cat "$here/numbers.md"
