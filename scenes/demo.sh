#!/bin/sh
# Renders the course's pictures and says what each shows. Usage: demo.sh PROGRAM DIRECTORY
set -eu
program=$1
out=$2
scenes=$(dirname "$0")
mkdir -p "$out"

# picture NAME SCENE FLAGS TITLE: small and quick first, so that there is something to look at within seconds.
picture() {
    name=$1 scene=$2 flags=$3 title=$4
    count=$((count + 1))
    echo "[$count/$total] $title"
    # shellcheck disable=SC2086  # flags fall apart into words
    "$program" render "$scenes/$scene.yaml" -o "$out/$name.png" $flags
    written="$written  $out/$name.png
      $title
"
}

total=11
count=0
written=""
echo "Eleven pictures, about a minute on two cores; the first is there at once."
picture 1_diffuse box_diffuse "--photons 500000 --k 200 --samples 16" "stage 1: diffuse photons; colour bleeds from the walls"
picture 1_photons_only box_diffuse "--integrator photons-only --photons 500000 --k 100" "stage 1: the map alone, looked up at the first surface"
picture 1_glass box_glass "--photons 1000000 --k 200 --samples 16" "stage 1: a mirror, a glass ball and its caustic"
picture 1_ring ring "" "stage 1: light in a mirror ring: a caustic with a cusp half-way to the rim"
picture 1_looking_glass box_glass "--photons 500000 --glass-sides 1" "the same with eye rays bent at the front of the glass only"
picture 2_glossy_source box_glossy "--steps 2.3 --samples 64" "stage 2: glossy photons as the source text scatters them"
picture 2_glossy_phong box_glossy "--samples 64" "stage 2: glossy photons that conserve energy"
picture 3_prism prism "" "stage 3: a prism parts a white beam"
picture 3_raindrop raindrop "" "stage 3: the rainbow of one drop"
picture 3_diamond diamond "" "stage 3: the fire of a diamond"
picture 3_dispersion box_dispersion "--samples 32" "stage 3: the course's picture: glossy and dispersing glass together"

echo
echo "Written:"
printf '%s' "$written"
