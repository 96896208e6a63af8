#!/usr/bin/env bash
# Runs fuzzers, one on each processor, each from seeds. Usage: fuzz.sh BUILD SECONDS NAME…; what they found stays in
# BUILD/fuzz/corpus_NAME, what broke them in BUILD/fuzz.
set -u
build=$1
seconds=$2
shift 2
scratch=$(mktemp -d -p /dev/shm 2>/dev/null || mktemp -d) # in memory: a file for each run
trap 'rm -rf "$scratch"' EXIT
export TMPDIR=$scratch
TIMEFORMAT='%U %S'
tiny=(--size 9x7 --photons 99 --samples 1 --quiet)

# seeds NAME: files that the program reads or writes, into the folder.
seeds() {
    local to=$build/fuzz/corpus_$1 file bits
    case $1 in
    scene | integrators) find tests scenes -name '*.yaml' -size -16k -exec cp {} "$to" \; ;;
    obj) # of large ones the beginning, and the end, where faces are
        find tests scenes -name '*.obj' -size -16k -exec cp {} "$to" \;
        for file in scenes/meshes/*.obj; do
            head -c 3000 "$file" >"$to/${file##*/}.head"
            { head -n 20 "$file" && tail -n 40 "$file"; } >"$to/${file##*/}.ends"
        done
        ;;
    png | pfm)
        for bits in 8 16; do
            "$build/photonlab" render scenes/box_glass.yaml "${tiny[@]}" --bits $bits -o "$to/seed$bits.$1"
        done
        find tests course_notes scenes -name "*.$1" -size -4k -exec cp {} "$to" \;
        ;;
    part)
        for bits in pass pixel; do
            "$build/photonlab" render scenes/box_glass.yaml "${tiny[@]}" --size 3x2 --passes 3 --radii $bits -o "$to/$bits.part"
        done
        ;;
    photons)
        "$build/photonlab" photons scenes/box_glass.yaml --photons 30 -o "$to/seed.ply" 2>/dev/null
        ;;
    points) cp tests/judge/points.txt "$to" ;;
    csv)
        printf 'name,id\nAda,1\n"Ko, ""J""",2\n' >"$to/commas"
        printf '\xef\xbb\xbfname;id\r\nÄda;1\r\n' >"$to/semicolons"
        printf 'name\tid\nAda\t"1\n2"\n' >"$to/tabs"
        ;;
    crash)
        printf 'printed\nphotonlab-crash signal=11 case=3 address=0x0 stack=near peak_kb=9000 step=1.3 frames=0x1a2,0x3b4\n\0%s' \
            $'scatter_diffuse\n/x/1.3_scatter_diffuse.c:12 (discriminator 3)\n??\n??:0\n' >"$to/segfault"
        printf 'photonlab-crash signal=31 case=0 address=0x0 stack=near peak_kb=9 syscall=57 frames=\n' >"$to/call"
        printf 'x.c:3: f: Assertion `a > 0'"'"' failed.\nphotonlab-crash signal=6 stack=far frames=0x1\n' >"$to/assertion"
        printf '==1==ERROR: AddressSanitizer: heap-buffer-overflow\nphotonlab-crash signal=6 frames=\n' >"$to/sanitizer"
        ;;
    report)
        cp tests/judge/report/test/report.json "$to"
        for file in 1.1 1.3 3.2; do
            "$build/judge" --build "$build" --code solutions --step $file --work "$scratch/work" --report "$scratch/report" >/dev/null 2>&1
            cp "$scratch/report/report.json" "$to/$file.json"
        done
        ;;
    probe) # cases of the sizes that steps 1.1 and 3.2 give, and what begins like them
        perl -e 'print chr($_), "photonlab probe 1\n", map { pack("V2x" . 4 * $_->[1], @$_) } [0, 3], [1, 6], [2, 6], [3, 400], [4, 100] for @ARGV' 0 >"$to/whole"
        perl -e 'print chr(10), "photonlab probe 1\n", pack("V2x4", 0, 1), pack("V2x8", 1, 2), pack("V2", 2, 5)' >"$to/cut"
        ;;
    *) echo "fuzz: no seeds for $1; give it a row in $0" && return 1 ;;
    esac
}

dictionaries() {
    cp tests/fuzz/*.dict "$build/fuzz/"
    "$build/scene_page" --words >>"$build/fuzz/scene.dict"
    cp "$build/fuzz/scene.dict" "$build/fuzz/integrators.dict"
}

# fuzz NAME: for so many seconds of a processor, however many others share it.
fuzz() {
    local corpus=$build/fuzz/corpus_$1 log=$build/fuzz/$1.log dictionary=$build/fuzz/$1.dict mark=✓
    mkdir -p "$corpus"
    seeds "$1" || return 1
    # The clock of -timeout is the wall's: so much that other work on the machine is no fault of a reader.
    { time FUZZ_SECONDS=$seconds "$build/fuzz/fuzz_$1" -timeout=120 -max_len=16384 -print_final_stats=1 \
        -artifact_prefix="$build/fuzz/" $([ ! -f "$dictionary" ] || echo "-dict=$dictionary") "$corpus" >"$log" 2>&1; } 2>"$scratch/$1.time" || mark=✗
    printf '%s %-12s %s s of a processor: %s runs, %s edges from seeds, %s at the end\n' $mark "$1" "$(awk 'END { printf "%.0f", $1 + $2 }' "$scratch/$1.time")" \
        "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" "$(sed -n 's/.*INITED cov: \([0-9]*\).*/\1/p' "$log")" \
        "$(sed -n 's/^#.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -1)"
    [ $mark = ✓ ] || { tail -30 "$log" && return 1; }
}

dictionaries || exit 1
for name in "$@"; do
    [ "$(jobs -rp | wc -l)" -lt "$(nproc)" ] || wait -n
    fuzz "$name" || : >"$scratch/failed" &
done
wait
[ ! -e "$scratch/failed" ]
