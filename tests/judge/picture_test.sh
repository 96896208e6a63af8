#!/bin/sh
# How good the image verdict is: false verdicts on right code, and how surely it sees known mistakes in the first round.
#     sh tests/judge/picture_test.sh BUILD [GROUPS_OF_RIGHT_CODE [GROUPS_PER_MISTAKE [SET]]]
# Fails when right code fails more often than promised (0.4 % where V counts, 0.2 % elsewhere; at 99.9 % confidence), or
# when a mistake that the picture should show gets past. 598 groups without a miss show 99.5 % at 95 % confidence. A mistake
# that is marked `unseen` is the business of its step's own checks.
set -eu
build=$1
right=${2:-3000}
wrong=${3:-598}
only=${4:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# set | step | seen or unseen | mistake | what sed does to the solution
mistakes() {
    cat <<'TABLE'
1|1.1|seen|mirror direction with the wrong sign|s/-2.0f \* along/2.0f * along/
1|1.1|seen|no mirror: straight on|s/return vec3_along.*/return direction;/
1|1.2|seen|power too small by 5 %|s/light->power);$/colour_scale(light->power, 0.95f));/
1|1.2|seen|light shines from its corner|s/float u = rng_float(rng)/float u = 0.0f * rng_float(rng)/;s/float v = rng_float(rng)/float v = 0.0f * rng_float(rng)/
1|1.3|seen|uniform hemisphere|s/= sqrtf(u1)/= u1/;s/sqrtf(1.0f - u1)/sqrtf(1.0f - u1 * u1)/
1|1.4|seen|survivors not reweighted|s|1.0f / survival|1.0f|
1|1.4|seen|survivors reweighted twice|s|1.0f / survival|1.0f / (survival * survival)|
1|1.5|seen|stored after the roulette only|s/^        if (material_is_rough(material))$/        Photon arrived = photon;/;s/^            photon_store(trace, &photon, &hit);$//;s/photon.direction = steps.scatter_diffuse(hit.normal, rng);/photon_store(trace, \&arrived, \&hit); &/
1|1.6|seen|1/π missing|s/(PI \* r \* r)/(r * r)/
1|1.6|seen|cosine counted again|s/float weight = /&vec3_dot(stored_photon_wi(photon), hit->normal) * (/;s/ \/ r;$/ \/ r);/
1|1.6|seen|radius larger by 20 %|s/^    float r;$/    NearPhoton near[400]; Gather wide = *gather; wide.near = near; wide.k = gather->k * 144 \/ 100; float r;/;s/hit->position, gather,/hit->position, \&wide,/;s/gather->near\[/wide.near[/g
1|1.6|seen|no cone: every photon counts the same|s/float weight = .*/float weight = 1.0f;/;s/3.0f \/ (PI/1.0f \/ (PI/
2_source|2.3|seen|lobe about the normal|s/turn_to(local, mirror)/turn_to(local, normal)/
2_source|2.3|seen|no redraw: into the surface|s/normal) > 0.0f)/normal) > -2.0f)/
2_source|2.3|seen|no gap: always the lobe|s/mirror) <= 0.0f)/mirror) <= -2.0f)/
2_phong|2.4|seen|lobe about the normal|s/turn_to(local, mirror)/turn_to(local, normal)/
2_phong|2.4|seen|weight forgotten|s/\*weight = (exp.*/*weight = 1.0f;/
2_phong|2.4|seen|cosine forgotten in the weight|s/ \* cos_out;/;/
2_phong|2.1|unseen|n in place of n+1|s/(exponent + 1.0f)/fmaxf(exponent, 0.01f)/
2_phong|2.1|seen|uniform hemisphere|s/logf(u1) \/ (exponent + 1.0f)/logf(u1)/
2_phong|2.2|seen|lobe not turned|s/return vec3_along(turned, axis.*/return local;/
3|3.1|seen|Snell's ratio inverted|s/^    float cos_i = /    eta = 1.0f \/ eta; &/
3|3.2|seen|nothing is reflected|s/return 0.5f \* .*/return 0.0f;/
3|3.2|seen|no total reflection|s/return 1.0f;/return 0.0f;/
3|3.3|seen|one index for the three colours|s/glass->index\[[02]\];/glass->index[1];/
3|3.3|unseen|white has green's index|s/return (glass->index\[0\] + .*/return glass->index[1];/
3|3.4|seen|children bend as white|s/index(glass, children\[i\].colour)/index(glass, WHITE)/
3|3.4|unseen|flux divided by n² on entering|s/children\[i\].colour));/& children[i].power = colour_scale(children[i].power, 1.0f \/ (eta * eta));/
3|3.5|seen|each child has the whole power|/colour_grey(0.0f)/d;/colour_set_channel/d
3|3.5|seen|blue forgotten|s/return 3;/return 2;/
TABLE
}

# An object of the step's solution, changed. A change that no longer fits the solution is an error here.
build_mistake() {
    source=$(find solutions -name "$1_*.c")
    sed "$2" "$source" >"$work/step.c"
    if cmp -s "$source" "$work/step.c"; then
        echo "$1: the change \`$2\` changes nothing in $source" >&2
        exit 1
    fi
    ${CC:-cc} -std=c99 -D_DEFAULT_SOURCE -D_XOPEN_SOURCE=700 -O2 -ffp-contract=off -fno-math-errno -fPIC -shared -Ilib \
        "$work/step.c" -o "$work/step.so"
}

# "fail 3/600" in a line of calibrate's → 3
failed_groups() {
    sed -n 's|.*  fail \([0-9]*\)/.*|\1|p' "$1"
}

echo "Right code, $right groups a set:"
for set in 1 2_source 2_phong 3; do
    [ -z "$only" ] || [ "$only" = "$set" ] || continue
    [ "$right" -gt 0 ] || continue
    "$build/calibrate" --build "$build" --measure "$right" "$set" >"$work/line"
    cat "$work/line"
    # The 0.1 % quantile of so many groups, by its normal approximation with a margin for small numbers.
    level=0.002
    [ "$set" = 1 ] && level=0.004
    most=$(awk "BEGIN { m = $right * $level; print int(m + 3.1 * sqrt(m) + 2) }")
    if [ "$(failed_groups "$work/line")" -gt "$most" ]; then
        echo "   too many: at most $most were to be expected"
        failures=$((failures + 1))
    fi
done

[ "$wrong" -gt 0 ] && echo "Mistakes, $wrong groups each:"
mistakes >"$work/table"
while IFS='|' read -r set step seen name change; do
    [ "$wrong" -gt 0 ] || continue
    [ -z "$only" ] || [ "$only" = "$set" ] || continue
    build_mistake "$step" "$change"
    "$build/calibrate" --build "$build" --measure "$wrong" --step "$step" --object "$work/step.so" --name "$step $name" \
        "$set" >"$work/line" </dev/null
    cat "$work/line"
    if [ "$seen" = seen ] && [ "$(failed_groups "$work/line")" -lt "$wrong" ]; then
        echo "   the picture should show this every time"
        failures=$((failures + 1))
    fi
done <"$work/table"
[ "$failures" -eq 0 ] || { echo "$failures not as promised"; exit 1; }
