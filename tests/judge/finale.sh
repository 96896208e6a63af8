#!/usr/bin/env bash
# The course's picture, drawn large by a student's own steps and hung in a frame: once `make test` has nothing left to say.
# Arguments: the judge and its flags. Environment, as `make finale` sets it: PHOTONLAB_BUILD, PHOTONLAB_PLAYED (the student's
# steps, built), PHOTONLAB_NAME, PHOTONLAB_SIDE (pixels of each picture).
set -u
cd "$(dirname "$0")/../.." || exit 2
build=$PHOTONLAB_BUILD
out=$build/finale
program=$build/photonlab
mkdir -p "$out"

echo "All steps once more …"
if ! "$@" >"$out/test.txt"; then
    grep -E '^  (✗|!|○)' "$out/test.txt" | head -5
    tail -3 "$out/test.txt"
    echo "The finale waits until every step passes: make test"
    exit 1
fi
points=$(grep ' points$' "$out/test.txt" | tail -1)
steps=$(grep -c '^  ✓ [0-9]' "$out/test.txt")

# The name that the work was handed in under, unless there is another.
name=${PHOTONLAB_NAME:-$(cat "$build/submit/name" 2>/dev/null)}
[ -n "$name" ] || name=$(id -un)

# What the course has no stage for stays away: gathering, wavelengths.
of_stage() { grep -q "^Stage $1 " "$out/test.txt"; }
way=$(of_stage 4 && echo gather || echo photons)

# draw NAME WORDS FLAG…: a picture, and what became of its photons
draw() {
    local picture=$1 words=$2
    shift 2
    echo "$words …"
    "$program" render scenes/box_dispersion.yaml -o "$out/$picture.png" --integrator $way --k 60 --code "$PHOTONLAB_PLAYED" \
        --size "${PHOTONLAB_SIDE}x$PHOTONLAB_SIDE" --json "$@" >"$out/$picture.json"
}

# The ledger of a picture's photons in words; fluxes are of three channels, W.
ledger() {
    awk '
        function of(key,    part, text) {
            text = $0
            sub(".*\"" key "\":\\[", "", text)
            split(text, part, /[],]/)
            return part[1] + part[2] + part[3]
        }
        function whole(key,    text) { text = $0; sub(".*\"" key "\":", "", text); return text + 0 }
        {
            emitted = of("emitted")
            printf "%d photons set out with %.1f W and were stored %d times:\\n    %.1f %% absorbed, %.1f %% escaped, %.1f %% cut off, %+.2f %% by chance",
                whole("photons_emitted"), emitted, whole("photons_stored"), 100 * of("absorbed") / emitted,
                100 * of("escaped") / emitted, 100 * of("cut") / emitted, 100 * of("chance") / emitted
        }' "$1"
}

words="photon mapping: $steps steps, $points"
draw colours "The box with the diamond" --samples 32 || exit 1
set -- "$out/colours.png"
words="$words\n$(ledger "$out/colours.json")"
if of_stage 6; then
    draw spectral "The same with every wavelength" --samples 64 --spectral || exit 1
    set -- "$@" "$out/spectral.png"
    words="$words\n$(ledger "$out/spectral.json")"
fi
"$program" frame "$@" -o "$out/finale.png" --title "$name" --text "$words" || exit 1
echo "$out/finale.png: yours. (\`make report\` ends with it.)"
