#!/bin/sh
# A page in one file, from a template. Usage: make_page.sh TEMPLATE MODULE.wasm [SCENE.yaml…]
# In it, lines of their own: @FILE path@ becomes the file; @MODULE@ the module, packed, for Photonlab.compile; @SCENES@ the
# scenes as they are, and the meshes that they name, packed.
set -eu
template=$1 module=$2
shift 2
pack() {
    gzip -9nc "$1" | base64 | tr -d '\n'
}
LC_ALL=C
export LC_ALL
while IFS= read -r line || [ -n "$line" ]; do
    case $line in
    "@FILE "*@)
        file=${line#@FILE }
        cat "${file%@}"
        ;;
    @MODULE@)
        printf '<script type="application/wasm" id="photonlab-module">'
        pack "$module"
        echo '</script>'
        ;;
    @SCENES@)
        for scene in "$@"; do
            printf '<script type="text/yaml" data-name="%s">' "${scene##*/}"
            cat "$scene"
            echo '</script>'
        done
        [ $# = 0 ] || sed -n 's/.*file: *\([^,} ]*\.obj\).*/\1/p' "$@" | sort -u | while read -r mesh; do
            [ -r "scenes/$mesh" ] || { echo "scenes/$mesh is not here; make meshes makes it" >&2; exit 1; }
            printf '<script type="text/mesh" data-name="%s">' "$mesh"
            pack "scenes/$mesh"
            echo '</script>'
        done
        ;;
    *) printf '%s\n' "$line" ;;
    esac
done <"$template"
