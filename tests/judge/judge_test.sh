#!/usr/bin/env bash
# What a student meets at the terminal: wrong folders and names, todo left behind, compile errors, points, exit codes, the
# debugger. `make check-judge` runs it.
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
build=$(cd "$PHOTONLAB_BUILD" && pwd)
stage1="$work/my code/1_diffuse_photon_map"
mkdir -p "$stage1"
judge=("$build/judge" --build "$build" --work "$work/test" --code "$work/my code")

# judged CODE TEXT FLAGS…: the judge's exit code, and a text in what it says.
judged() {
    local code=$1 text=$2
    shift 2
    expect "$code" "$text" "${judge[@]}" "$@"
}

judged 2 "expected a folder laid out like exercises/" --code "$work/nowhere"
judged 2 "the course has no step or stage like that; it has 1.1 1.2" --step 9.9
judged 2 "the course has no step or stage like that" --stage x
judged 2 "what is \`2.1\`" 2.1
judged 0 "0 passed, 0 failed" --stage 1
judged 1 "6 not started" --stage 1 --strict

# What a name holds is not run.
nasty="2.1';touch $work/ran;'\";touch $work/ran;\`touch $work/ran\`"
for target in test hint reset debug "render FLAGS=--help"; do
    make -s BUILD="$build" STEP="$nasty" STAGE="$nasty" SALT="$nasty" CODE="$nasty" SCENE="$nasty" $target </dev/null
done >"$work/out" 2>&1
ok "make runs no part of STEP, STAGE, SALT, CODE, SCENE" not test -e "$work/ran"

# Two makes at once in one folder, as an editor and a terminal start them.
mkdir "$work/two" && cp -R "$build/obj" "$work/two/" && find "$work/two" -type f -exec touch {} +
make -s BUILD="$work/two" all >"$work/first" 2>&1 &
make -s BUILD="$work/two" all >"$work/out" 2>&1 && wait $! || bad "two makes at once: $(cat "$work/first" "$work/out")"
ok "two makes at once build one program" "$work/two/photonlab" steps

# A right step in a folder with a blank in its name; the same in the wrong place.
cp solutions/1_diffuse_photon_map/1.1_reflect.c "$stage1/"
judged 0 "1 passed, 0 failed" --stage 1
PHOTONLAB_CC="${PHOTONLAB_CC:-cc} -pipe" judged 0 "1 passed, 0 failed" --step 1.1 # a compiler of two words
mv "$stage1/1.1_reflect.c" "$work/my code/1.1_mirror.c"
judged 0 "1.1_mirror.c is not graded: step 1.1 is looked for in" --stage 1
rm "$work/my code/1.1_mirror.c"

# todo left beside real code is named, in an untouched stub it is not.
sed 's/^    return .*/    return vec3_along(direction, normal, -2 * vec3_dot(direction, normal));/' \
    exercises/.stubs/1_diffuse_photon_map/1.1_reflect.c >"$stage1/1.1_reflect.c"
judged 0 "but line 6 still calls todo()" --step 1.1
cp exercises/.stubs/1_diffuse_photon_map/1.1_reflect.c "$stage1/"
judged 0 "1 not started" --step 1.1
ok "an empty step is not called started" not said "still calls"

# A compile error is that step's alone; a warning stands beside a failure.
cp solutions/1_diffuse_photon_map/1.2_emit_photon.c "$stage1/"
echo 'Vec3 reflect(Vec3 direction, Vec3 normal) { return direction normal; }' >"$stage1/1.1_reflect.c"
judged 1 "it does not compile" --stage 1
ok "the compiler's own line" grep "1.1_reflect.c:1:.*error" "$work/out"
ok "step 1.2 passes beside it" said "✓ 1.2"
# Of a million errors, the first is shown.
{ echo '_Static_assert(1 == 2, "the first");' && echo '#define A _Static_assert(0, "others");' &&
    for to in B C D E F G; do from=$(echo $to | tr B-G A-F); echo "#define $to $from $from $from $from $from $from $from $from $from $from"; done && echo G; } >"$stage1/1.1_reflect.c"
judged 1 "the first" --step 1.1
mkdir "$work/my code/deep" && mkfifo "$work/my code/deep/pipe.h"
echo '#include "../deep/pipe.h"' >"$stage1/1.1_reflect.c"
expect 2 "deep/pipe.h: is neither file nor folder" timeout 10 "${judge[@]}" --step 1.1
rm -r "$work/my code/deep"
printf '#include "photonlab.h"\nVec3 reflect(Vec3 direction, Vec3 normal) { (void)normal; (void)direction; }\n' >"$stage1/1.1_reflect.c"
judged 1 "non-void function" --step 1.1
printf '#include "photonlab.h"\nfloat two = 2;\nVec3 reflect(Vec3 d, Vec3 n) { return vec3_along(d, n, -two * vec3_dot(d, n)); }\n' >"$stage1/1.1_reflect.c"
judged 1 "write \`const\` before it" --step 1.1
printf '#include "photonlab.h"\nVec3 reflect(Vec3 d, Vec3 n) { static int calls; calls++; return vec3_along(d, n, -2.0f * vec3_dot(d, n) * (calls > 0)); }\n' >"$stage1/1.1_reflect.c"
judged 1 "take the word \`static\` away" --step 1.1
printf '#include "photonlab.h"\nVec3 reflect(Vec3 d, Vec3 n) { Rng rng = rng_create(1, 1); (void)d; return scatter_diffuse(n, &rng); }\n' >"$stage1/1.1_reflect.c"
judged 1 "write steps.scatter_diffuse(…)" --step 1.1
cp solutions/3_colour_dispersion/3.1_refract.c "$stage1/1.1_reflect.c"
judged 1 "there is no function \`reflect\` in it; \`refract\` is there, which is step 3.1's" --step 1.1
printf '#include <stdio.h>\n#include "photonlab.h"\nVec3 reflect(Vec3 d, Vec3 n) { printf("here\\n"); return *(Vec3 *)0; (void)d; (void)n; }\n' >"$stage1/1.1_reflect.c"
judged 1 "printed: (in the case that failed) here" --step 1.1

# The finale is of the student's own steps: none may be left for the reference to play, whatever STEP says.
mkdir -p "$work/nothing"
make -s BUILD="$build" CODE="$work/nothing" STEP=1.1 finale >"$work/out" 2>&1
[ $? != 0 ] && grep -q "waits until every step passes" "$work/out" && good "the finale waits for every step" || bad "the finale does not wait: $(tail -3 "$work/out")"

# make debug: gdb stops where it crashes.
mkdir -p "$work/build"
ln -s "$build"/* "$work/build/" 2>/dev/null
rm -rf "$work/build/test"
ln -s "$work/test" "$work/build/test"
GDB_FLAGS=-batch expect 0 "SIGSEGV" sh "$here/debug.sh" "$work/build" 1.1 </dev/null

# Right code prints as much as it likes; wrong code's words are those of the case that failed.
solved=solutions/1_diffuse_photon_map
sed 's/#include "photonlab.h"/&\n#include <stdio.h>/; s/float phi.*/& printf("u1 = %f, u2 = %f, cos_theta = %f, sin_theta = %f, phi = %f\\n", (double)u1, (double)u2, (double)cos_theta, (double)sin_theta, (double)phi);/' \
    $solved/1.3_scatter_diffuse.c >"$stage1/1.3_scatter_diffuse.c"
judged 0 "1 passed, 0 failed" --step 1.3 --seconds 60
sed 's/#include "photonlab.h"/&\n#include <stdio.h>/; s/ float along/ printf("normal.y = %g\\n", (double)normal.y); &/; s/-2.0f \* along/normal.y > 0.99f ? -along : &/' \
    $solved/1.1_reflect.c >"$stage1/1.1_reflect.c"
judged 1 "printed: (in the case that failed) normal.y = 1 make hint" --step 1.1
rm "$stage1/1.3_scatter_diffuse.c"

# Files to include: those that are handed in, too.
mkdir "$work/my code/util"
echo 'static inline float twice(float x) { return 2.0f * x; }' | tee "$work/my code/util/twice.inl" >"$work/my code/util/twice.txt"
with() { sed "s|#include \"photonlab.h\"|&\n#include \"../util/$1\"|; s/-2.0f \* along/-twice(along)/" $solved/1.1_reflect.c >"$stage1/1.1_reflect.c"; }
with twice.inl
judged 0 "1 passed, 0 failed" --step 1.1
with twice.txt
judged 1 "it includes \`util/twice.txt\`, which would not be handed in" --step 1.1
[ "$(id -u)" != 0 ] || PHOTONLAB_SANDBOX=uid judged 1 "it includes \`util/twice.txt\`" --step 1.1 # which compiles a copy
rm -r "$work/my code/util"

# A copy beside the steps plays nowhere, and is told once.
mkdir -p "$work/strays/1_diffuse_photon_map"
cp $solved/1.1_reflect.c "$work/strays/1_diffuse_photon_map/"
cp $solved/1.1_reflect.c "$work/strays/1_diffuse_photon_map/1.1_reflect copy.c"
stray() { make -s BUILD="$build" CODE="$work/strays" code-built >"$work/out" 2>&1; }
ok "a stray .c beside the steps stops nothing" stray
ok "and is named" grep "1.1_reflect copy.c is no step" "$work/out"
ok "once" eval 'stray && not grep "is no step" "$work/out"'

# The scatter of a stage: right code passes, a mistake shows, a crash costs that line alone, one step alone has none.
rm -rf "$work/my code"
mkdir -p "$work/my code"
cp -R solutions/. "$work/my code/"
judged 0 "✓ scatter of stage 2, by your 2.1 2.2 2.4" --stage 2 --report "$work/report"
ok "the scatter's picture" [ "$(head -c 4 "$work/report/pictures/scatter_2.png" | tail -c 3)" = PNG ]
judged 0 "✓ scatter of stage 1, by your 1.1 1.2 1.3 1.4 1.5" --stage 1
judged 0 "1 passed, 0 failed" --step 2.4
ok "one step alone has no scatter" not said scatter
patch -s -d "$work/my code" -p2 <tests/mistakes/2.4_lobe_about_normal/a.patch
judged 1 "✗ scatter of stage 2, by your 2.1 2.2 2.4 stage 2, scatter: " --stage 2
cp -R solutions/. "$work/my code/"
rm "$work/my code/2_glossy_lobe/2.4_scatter_glossy_phong.c"
judged 0 "✓ scatter of stage 2, by your 2.1 2.2 2.3" --stage 2
cp solutions/2_glossy_lobe/2.4_scatter_glossy_phong.c "$work/my code/2_glossy_lobe/"
# Where nothing draws, a sentence about what to install stands in the picture's place.
PHOTONLAB_WITHOUT=osmesa,egl "${judge[@]}" --stage 2 --report "$work/report" >"$work/out" 2>&1
ok "without OSMesa and EGL the report says what to install" grep '"picture_message": ".*install libosmesa6' "$work/report/report.json"
ok "and has no picture" grep '"picture": "",' "$work/report/report.json"
# Files of photons that are none.
preview=("$build/photonlab" preview tests/steps/scenes/scatter_2.yaml --snapshot "$work/p.png" --size 300x200 --photons-file)
photons=$work/test/scatter_2/yours.photons
head -c 1000 "$photons" >"$work/cut.photons"
{ head -c 5000 "$photons"; head -c 6000 /dev/zero | tr '\0' '\377'; tail -c +11001 "$photons"; } >"$work/nan.photons"
expect 1 "is no file of photons" "${preview[@]}" "$work/cut.photons"
expect 0 "" "${preview[@]}" "$work/nan.photons" # they are left out
# Wrong on the steel ball alone, where no check of the step looks: the scatter names the step.
sed -i 's/turn_to(local, mirror)/turn_to(local, exponent > 150.0f \&\& exponent < 250.0f ? normal : mirror)/' "$work/my code/2_glossy_lobe/2.4_scatter_glossy_phong.c"
judged 1 "look at 2.4: with the reference in its place the photons are right" --stage 2
cp solutions/2_glossy_lobe/2.4_scatter_glossy_phong.c "$work/my code/2_glossy_lobe/"
# A null pointer on the steel ball alone.
sed -i 's/^{$/{ if (exponent > 150.0f \&\& exponent < 250.0f) { bool *volatile none = 0; return *none; }/' "$work/my code/2_glossy_lobe/2.4_scatter_glossy_phong.c"
judged 1 "2.1 2.2 2.4 did not get through: segmentation fault in scatter_glossy_phong of step 2.4, line" --stage 2
ok "a crash in the scatter is told in its line, beside right steps" grep -qz "✓ 2.1.*! scatter of stage 2" "$work/out"
# Photons that the student's code writes down itself: in another place, and in the very form of the probe.
cp solutions/2_glossy_lobe/2.4_scatter_glossy_phong.c "$work/my code/2_glossy_lobe/"
cp tests/attacks/results_turned_back/*/*.c "$stage1/"
judged 1 "! scatter of stage 1, by your 1.1 1.2 1.3 1.4 1.5 stage 1, scatter: something other than the probe wrote" --stage 1
cat >"$stage1/1.1_reflect.c" <<'END'
#include "photonlab.h"
#include <stdint.h>
#include <stdlib.h>
#include <unistd.h>

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    const size_t count = 3 + 60000 * 15;
    const uint32_t head[2] = {0, (uint32_t)count};
    float *numbers = calloc(count, sizeof *numbers);
    numbers[1] = 24000.0f;
    if (write(3, head, sizeof head) < 0 || write(3, numbers, count * sizeof *numbers) < 0)
        return normal;
    _exit(0);
    return direction;
}
END
judged 1 "✗ scatter of stage 1, by your 1.1 1.2 1.3 1.4 1.5 stage 1, scatter: the scene gets 100 % fewer photons" --stage 1
expect 0 "2 of 2 are seen" bash "$here/scatter_power_test.sh" 1.2_corner 1.3_uniform
rm -rf "$work/my code"
mkdir -p "$stage1"
cp solutions/1_diffuse_photon_map/1.2_emit_photon.c "$stage1/"

# The points table; not the one in tests/judge/, which is for teachers to change: in this, 1.2 and all others weigh 1.
awk 'BEGIN { print "total 30\npicture 20" } $1 == "step" && $2 <= "2" { print $1, $2, 1; next } $1 == "step" { print $1, $2, 0 }' \
    tests/judge/points.txt >"$work/weights"
table() {
    { grep -v "^$1" "$work/weights"; echo "$2"; } >"$work/points"
    judged "$3" "$4" --step 1.2 --points "$work/points"
}
table "step 1.2" "step 1.2 2" 0 "8.57 of 8.57 points"
table "step 1.2" "step 1.2 6 hidden" 0 "1 hidden step is graded, too"
table "step 1.2" "step 1.2 6 hidden
stage 1 due $(date +%Y-%m-%d)" 0 "1 hidden step is graded, too"
table "step 1.2" "step 1.2 6 hidden
stage 1 due $(date -d yesterday +%Y-%m-%d)" 0 "✓ 1.2"
table "step 1.2" "# none" 2 "no line for step 1.2"
table "none" "step 1.1 5" 2 "each step once"
table "none" "step 9.9 5" 2 "a step that there is"
table "none" "stage 2 due 2026-02-30" 2 "a date that there are"
table "none" "stage 9 weight 2" 2 "of a stage"
table "step 2.1" "step 2.1 6
stages 1" 0 "5 of 5 points"
judged 2 "it has 1.1 1.2 1.3 1.4 1.5 1.6, and stages 1 to 1" --step 2.1 --points "$work/points"
table "none" "stages 1.5" 2 "how many stages"
table "none" "stages 99" 2 "how many stages"
table "picture" "picture 120" 2 "a percentage from 0 to 100"

# Asked to end at any moment, as by ctrl-C or a newer save in the preview, it leaves nothing behind: bubblewrap's second process
# would wait for its first for ever, or run what it was given.
left() { ps -eo ppid,stat,comm,pid | awk '$1 == 1 && $2 !~ /^Z/ && $3 ~ /^(bwrap|probe|cc)$/ { print $4 }' | sort; }
left >"$work/before"
for moment in $(seq 10 59); do
    setsid "${judge[@]}" --step 1.2 >"$work/out" 2>&1 &
    sleep "0.0$moment"
    kill -TERM $! 2>/dev/null
    wait $! 2>/dev/null
done
sleep 1
left | comm -13 "$work/before" - >"$work/out"
ok "ended at fifty moments, the judge leaves no process" not test -s "$work/out"

# The process that waits for its end may itself be killed: the judge goes on to its verdict, here of a loop that lasts a second.
stub=exercises/.stubs/1_diffuse_photon_map/1.1_reflect.c
sed 's/^{$/{ for (volatile int i = 0;; i++) continue;/' $stub >"$stage1/1.1_reflect.c"
setsid "${judge[@]}" --step 1.1 --seconds 1 >"$work/out" 2>&1 &
for try in $(seq 500); do pkill -KILL -x -P $! "sandbox's end" && break || sleep 0.01; done
ok "the judge's witness is killed" [ "$try" -lt 500 ]
wait $!
ok "the judge goes on" eval "[ $? = 1 ] && said 'it did not end' && not said 'line 0'"
rm "$stage1/1.1_reflect.c"

# Without a sandbox: loud, and not for credit.
export PHOTONLAB_SANDBOX=none
judged 0 "NO SANDBOX" --step 1.2
judged 3 "NO SANDBOX" --step 1.2 --credit
finish
