#!/bin/sh
# Renders the course's pictures and says what each shows. Usage: demo.sh PROGRAM DIRECTORY
set -eu
program=$1
out=$2
scenes=$(dirname "$0")
mkdir -p "$out"

# picture NAME COST SCENE FLAGS TITLE: the quick ones first, so that there is something to look at within seconds. The cost is
# about the seconds it takes on two cores; only the ratios matter.
picture() {
    name=$1 cost=$2 scene=$3 flags=$4 title=$5
    count=$((count + 1))
    left=""
    [ $done_cost -gt 5 ] && left=" (about $((($(date +%s) - started) * (total_cost - done_cost) / done_cost)) s left in all)"
    done_cost=$((done_cost + cost))
    echo "[$count/$total] $title$left"
    # shellcheck disable=SC2086  # flags fall apart into words
    "$program" render "$scenes/$scene.yaml" -o "$out/$name.png" $flags
    written="$written  $out/$name.png
      $title
"
}

total=15
total_cost=72
done_cost=0
count=0
started=$(date +%s)
written=""
echo "Fifteen pictures, one to two minutes on two cores; the first is there at once."
picture 1_diffuse 1 box_diffuse "--photons 500000 --k 200 --samples 16" "stage 1: diffuse photons; colour bleeds from the walls"
picture 1_photons_only 2 box_diffuse "--integrator photons-only --photons 500000 --k 100" "stage 1: the map alone, looked up at the first surface"
picture 1_glass 4 box_glass "--photons 1000000 --k 200 --samples 16" "stage 1: a mirror, a glass ball and its caustic"
picture 1_looking_glass 1 box_glass "--photons 500000 --glass-sides 1" "the same glass ball with eye rays bent at its front only"
picture 1_ring 2 ring "" "stage 1: light in a mirror ring: a caustic with a cusp half-way to the rim"
picture 2_glossy_source 8 box_glossy "--steps 2.3 --samples 32" "stage 2: glossy photons as the source text scatters them"
picture 2_glossy_phong 10 box_glossy "--samples 32" "stage 2: glossy photons by the modified Phong BRDF, which makes no energy"
picture 2_photons_only 4 box_glossy "--integrator photons-only --samples 4" "stage 2: the same from the map alone: few photons lie in a narrow lobe, hence the blotches"
picture 3_prism 3 prism "" "stage 3: a prism parts a white beam"
picture 3_raindrop 5 raindrop "" "stage 3: the rainbow of one drop"
picture 3_diamond 4 diamond "" "stage 3: the fire of a diamond"
picture 3_dispersion 16 box_dispersion "--samples 32" "stage 3: the course's picture: glossy and dispersing glass together"
picture 4_glass 3 box_glass "--integrator gather --photons 400000 --k 60 --samples 16" "stage 4: the mirror, the glass ball and its caustic, gathered: no blotches"
picture 4_glossy 5 box_glossy "--integrator gather --photons 300000 --k 60 --samples 32" "stage 4: glossy balls in gathered light: what they mirror shows"
picture 5_ring 4 ring "--passes 16 --photons 200000 --radius 0.004" "stage 5: the ring by passes, each with a smaller radius: the cusp grows sharp"

echo
echo "Written:"
printf '%s' "$written"
