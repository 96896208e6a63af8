# The fan behind a prism by three bands, by 16 lamps of a single line each, by wavelengths, and by 31 lines, which all others are held against;
# and what hero wavelengths gain. Usage: sh 6_hue.sh BANDS.pfm LINES.pfm WAVELENGTHS.pfm NUMBERS, with BUILD in the environment
to=$BUILD/figures/6_hue
fan=${to}_fan.yaml
sed 's/vertical_fov: 25/vertical_fov: 8/' tests/spectra/fan.yaml >"$fan"

# lines N: the scene with N lamps in place of its beam
lines() {
    awk -v n="$1" '/type: beam/ {
        for (i = 0; i < n; i++) {
            row = $0
            sub(/type: beam/, sprintf("type: beam, spectrum: \"%.3f\"", 380 + 350 * (i + 0.5) / n), row)
            sub(/power: [^}]*/, sprintf("power: [%.9f, %.9f, %.9f]", 0.002 / n, 0.002 / n, 0.002 / n), row)
            print row
        }
        next
    } { print }' "$fan" >"$to.yaml"
}

# render OUT SCENE FLAGS…
render() {
    out=$1 scene=$2
    shift 2
    "$BUILD/photonlab" render "$scene" -o "$out" --quiet "$@" || exit 1
}

# error NAME PICTURE REFERENCE
error() {
    echo "$1 $("$BUILD/photonlab" diff "$2" "$3" --json | sed 's/.*"relmse_all": *\([^,}]*\).*/\1/')"
}

lines 31
render "$to.sum.pfm" "$to.yaml" --photons 4000000 --size 288x96 --spectral
lines 16
render "$2" "$to.yaml" --photons 4000000 --size 288x96 --spectral
render "$1" "$fan" --photons 4000000 --size 288x96
render "$3" "$fan" --photons 4000000 --size 288x96 --spectral
{
    error bands "$1" "$to.sum.pfm"
    error lines "$2" "$to.sum.pfm"
    error wavelengths "$3" "$to.sum.pfm"
    grey="scenes/box_glossy.yaml --spectral --size 64x64 --samples 16 --reuse 0"
    render "$to.many.pfm" $grey --photons 6400000 --k 400
    render "$to.one.pfm" $grey --photons 200000 --k 100 --wavelengths 1
    render "$to.three.pfm" $grey --photons 200000 --k 100
    error one "$to.one.pfm" "$to.many.pfm"
    error three "$to.three.pfm" "$to.many.pfm"
} >"$4.new" && awk '{ print; v[$1] = $2 } END { print "gain", v["one"] / v["three"] }' "$4.new" >"$4" && rm "$4.new"
