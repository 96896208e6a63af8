#!/usr/bin/env bash
# Do the includes follow the pages, and would rooms.sh see it if not? Each case spoils a small tree in one place.
set -u
cd "$(dirname "$0")/.." || exit 2
. tests/common.sh
export ROOMS=$PWD/tests/rooms.awk
tree=$work/tree

fresh() {
    rm -rf "$tree" && mkdir -p "$tree"/lib/base "$tree"/lib/math "$tree"/tests/unit
    printf '| room | holds | may include |\n|---|---|---|\n| `base` | errors | |\n| `math` | vectors | `base` |\nErrors: `error_set` in `base/error.h`\n' \
        >"$tree/lib/README.md"
    printf '| `unit` | tests | `lib` |\n' >"$tree/tests/README.md"
    echo 'void error_set(void);' >"$tree/lib/base/error.h"
    echo '#include "base/error.h"' >"$tree/lib/math/vector.h"
    echo '#include "math/vector.h"' >"$tree/tests/unit/test.c"
}

# spoilt TITLE SAID COMMAND: what is said after the command has spoilt the tree
spoilt() {
    fresh
    (cd "$tree" && eval "$3")
    local said
    said=$(sh tests/rooms.sh "$tree") && said="passed: $said"
    if [ "$said" = "$2" ]; then good "$1"; else bad "$1: $said"; fi
}

if said=$(sh tests/rooms.sh .); then good "the includes follow the pages"; else bad "$said"; fi
spoilt "a sound tree" "passed: " true
spoilt "an arrow that the page does not have" "lib/base/error.h:2: lib/base → lib/math: lib/README.md has no such arrow" \
    "echo '#include \"math/other.h\"' >>lib/base/error.h; touch lib/math/other.h"
spoilt "the library that includes tests" "lib/math/vector.h:2: lib/math → tests/unit: lib/README.md has no such arrow" \
    "echo '#include \"unit/test.h\"' >>lib/math/vector.h; touch tests/unit/test.h"
spoilt "a circle between rooms" "lib/README.md:3: lib/base → lib/math: no room above has this name" \
    "sed -i '3s/ |\$/ \`math\` |/' lib/README.md"
spoilt "a circle between files" "lib/math/a.h: a circle of includes: lib/math/a.h lib/math/b.h lib/math/a.h" \
    "echo '#include \"b.h\"' >lib/math/a.h; echo '#include \"a.h\"' >lib/math/b.h"
spoilt "a room that is not on the page" "lib/new/file.c: no page has a room lib/new" "mkdir lib/new; echo >lib/new/file.c"
spoilt "an arrow that nothing uses" "lib/README.md:4: lib/math → lib/base: nothing uses this arrow" "echo >lib/math/vector.h"
spoilt "a file that is gone" "lib/math/vector.h:1: there is no file base/gone.h" "echo '#include \"base/gone.h\"
#include \"base/error.h\"' >lib/math/vector.h"
spoilt "a page that names a function wrongly" 'lib/README.md:5: `error_put` stands in none of the files on this line' \
    "sed -i s/error_set/error_put/ lib/README.md"
spoilt "a crowded folder" "lib/math: holds more than 20 source files" "for i in \$(seq 20); do echo >lib/math/\$i.c; done"
finish
