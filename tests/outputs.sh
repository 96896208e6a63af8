#!/usr/bin/env bash
# Fingerprints of what the program makes: pictures, photons, snapshots, and what the probe measures of every solution. A
# change of shape alone leaves every line as it was. Usage, in the checkout: outputs.sh BUILD [quick]   (or: make outputs)
set -u
build=$1
quick=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# print NAME COMMAND…: the command writes $work/out; its hash, or that there is none.
print() {
    local name=$1
    shift
    rm -f "$work/out"
    "$@" >"$work/said" 2>&1
    if [ -s "$work/out" ]; then
        echo "$(sha256sum <"$work/out" | cut -c1-32) $name"
    else
        echo "nothing: $(head -1 "$work/said") $name"
    fi
}

as() { # as ENDING COMMAND…: the command's last word is a file with this ending
    local file=$work/file.$1
    shift
    rm -f "$file"
    "$@" "$file" && mv "$file" "$work/out"
}

photonlab=$build/photonlab
seeds="1 2"
[ -z "$quick" ] || seeds=1
for scene in scenes/*.yaml tests/agreement/*.yaml tests/steps/scenes/*.yaml; do
    name=$(basename "$scene" .yaml)
    [ -z "$quick" ] || case $name in box_glossy | box_dispersion | lights | picture_3 | prism) ;; *) continue ;; esac
    for seed in $seeds; do
        for steps in 2.3,3.4 2.4,1.5; do
            flags="$scene --steps $steps --seed $seed --photons 5000"
            for integrator in photons photons-only; do
                print "$name $steps seed $seed $integrator.pfm" \
                    as pfm "$photonlab" render $flags --size 48x32 --samples 2 --integrator $integrator -o
            done
            print "$name $steps seed $seed photons.ply" as ply "$photonlab" photons $flags -o
        done
        print "$name seed $seed path.png" \
            as png "$photonlab" render "$scene" --seed "$seed" --size 48x32 --samples 2 --integrator path -o
    done
    for view in points paths lobe screen tree; do
        for more in "--split" "--colour photon --no-wireframe --camera 1,2,4,0,0,0 --path 3 --flight 2" "--colour bounce --diffuse"; do
            # shellcheck disable=SC2086  # flags fall apart into words
            print "$name $view $more" as png "$photonlab" preview "$scene" --photons 3000 --size 480x300 --view $view $more --snapshot
        done
    done
done

probe=$build/probe
[ -x "$probe" ] || probe="$photonlab probe" # as it was once
make -s test CODE=solutions SALT=outputs BUILD="$build" >"$work/verdicts" 2>&1
echo "$(sed 's/ *$//' "$work/verdicts" | sha256sum | cut -c1-32) what make test says of the solutions"
for object in "$build"/solutions/*/*.so; do
    name=$(basename "$object" .so)
    step=${name%%_*}
    for cases in calls scenes; do
        [ -s "$build/test/$step/$cases.txt" ] || continue
        echo "$(sha256sum <"$build/test/$step/$cases.txt" | cut -c1-32) cases of $step $cases"
        print "probe $step $cases" $probe --step "$step" --object "$object" --references "$build/solutions" --root . \
            "$build/test/$step/$cases.txt" -o "$work/out"
    done
done
