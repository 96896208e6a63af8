# Students' code at the command line; to be sourced by cli.sh.

# A student's step plays; the rest is the reference's. A stub counts as not started, a variable called todo does not.
stage1=$work/code/1_diffuse_photon_map
mkdir -p "$stage1" "$work/empty"
# student STEP BODY: the step's function, as its solution begins, with this in it.
student() {
    printf '#include "photonlab.h"\n%s\n{ %s }\n' \
        "$(grep -m1 "^[A-Za-z0-9 ]* ${1#*_}(" "solutions/1_diffuse_photon_map/$1.c")" "$2" >"$work/step.c"
    ${CC:-cc} -std=c99 -g -shared -fPIC -Ilib "$work/step.c" -o "$stage1/$1.so"
}
student 1.4_russian_roulette 'float todo = rng_float(rng); (void)power, (void)reflectance; return todo > 2.0f;'
student 1.1_reflect '(void)normal; todo("1.1"); return direction;'
play="$program render scenes/box_diffuse.yaml $quick -o $work/c.png --code $work/code"
expect 0 "your code plays: 1.4" $play --json
ok "photons that all die leave no indirect light" grep -q '"photons_stored":0,' "$work/out"
ok "a stub is named" said 'still calling todo(): 1.1'
expect 0 "" "$program" render $scene $quick -o "$work/w.pfm" --quiet --spectral
expect 0 "" "$program" render $scene $quick -o "$work/w3.pfm" --quiet --spectral --steps 6.4
ok "--spectral plays step 6.4" cmp "$work/w.pfm" "$work/w3.pfm"
expect 0 "" "$program" render $scene $quick -o "$work/w1.pfm" --quiet --spectral --wavelengths 1
ok "--wavelengths 1 is another picture" not cmp -s "$work/w.pfm" "$work/w1.pfm"
expect 0 "the path tracer plays no step" $play --integrator path
expect 0 "your code plays: nothing yet" "$program" render $scene $quick -o "$work/c.png" --code "$work/empty"
expect 1 "is no directory of steps" "$program" render $scene $quick -o "$work/c.png" --code "$work/nowhere"
expect 1 "is no directory of steps" "$program" render $scene $quick -o "$work/c.png" --code "$work/a.png"

# The loop of step 1.5 plays by itself while there is no 3.4.
student 1.5_trace_photon '(void)trace, (void)photon, (void)rng;'
expect 0 "your code plays: 1.4 1.5" $play
expect 0 "built, but not played (see --steps): 1.5" $play --steps 3.4
rm "$stage1/1.5_trace_photon.so"

# Right code is not accused, however few its photons are.
accused=0
for seed in 1 2 3 4 5 6 7 8 9 10; do
    for photons in 1 2 30 100 1000; do
        "$program" photons scenes/box_glossy.yaml --photons $photons --seed $seed -o "$work/few.ply" 2>&1 | grep -q energy: &&
            accused=$((accused + 1))
    done
done
check "$accused == 0" "few photons of right code: $accused of 50 runs accused"

# What a wrong step does is said.
student 1.4_russian_roulette '*power = colour_scale(colour_mul(*power, reflectance), 2.0f); return rng_float(rng) < 0.9f;'
expect 0 "or does not fit its directions: look at your step 1.4 (russian_roulette)" $play
student 1.4_russian_roulette '(void)reflectance; *power = colour_grey(NAN); return rng_float(rng) < 0.7f;'
rm -f "$work/c.png"
expect 1 "one of your steps may have returned NaN" $play
said "magenta" || bad "bad pixels are not told: $(cat "$work/err")"
ok "a picture with bad pixels is saved" test -s "$work/c.png"
rm "$stage1/1.4_russian_roulette.so"
student 1.3_scatter_diffuse '(void)rng; return vec3_scale(normal, 2.0f);'
expect 0 "at the light: your step 1.3 (scatter_diffuse) gave a direction whose length is 2, not 1" $play
rm "$stage1/1.3_scatter_diffuse.so"

student 1.1_reflect 'return vec3_scale(normal, vec3_dot(direction, normal) * NAN);'
expect 0 "of them at a mirror: your step 1.1 (reflect) gave a direction whose length is no number (NaN), not 1" \
    "$program" photons $scene --photons 2000 -o "$work/c.ply" --code "$work/code"
rm "$stage1/1.1_reflect.so"

# A crash and a loop without end are named, and end nothing but the work.
student 1.3_scatter_diffuse '(void)rng; return *(Vec3 *)(size_t)(normal.x > 2.0f);'
expect 1 "step 1.3, step.c:3: scatter_diffuse: segmentation fault" $play
expect 1 "step 1.3, step.c:3: scatter_diffuse: segmentation fault" \
    "$program" photons $scene --photons 2000 -o "$work/c.ply" --code "$work/code"
student 1.3_scatter_diffuse 'volatile float turns = 0.0f; for (;;) turns = turns + normal.x * rng_float(rng);'
$play --threads 1 >"$work/out" 2>"$work/err" &
while kill -0 $! 2>/dev/null && ! said "your code plays"; do sleep 0.1; done
# It counts seconds of processor time by this signal.
for ((seconds = 0; seconds < 11; seconds++)); do pkill -PROF -P $!; sleep 0.02; done
wait $!
check "$? == 1" "a loop that never ends is ended"
ok "and named" said "a loop that never ends?"
rm "$stage1/1.3_scatter_diffuse.so"

echo 'not an object' >"$stage1/1.4_russian_roulette.so"
expect 1 "step 1.4: cannot load" $play
rm "$stage1/1.4_russian_roulette.so" && mkfifo "$stage1/1.4_russian_roulette.so"
expect 1 "is not a regular file" timeout 20 $play
rm "$stage1/1.4_russian_roulette.so"
head -c 9000 "$build/solutions/1_diffuse_photon_map/1.4_russian_roulette.so" >"$stage1/1.4_russian_roulette.so"
expect 1 "is cut off" $play
mv "$stage1/1.4_russian_roulette.so" "$stage1/1.4_russian_roulete.so"
expect 1 "1.4_russian_roulete.so: no step has this name" $play
