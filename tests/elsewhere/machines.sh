#!/usr/bin/env bash
# The same bytes as here from programs for other processors, and the same means from one with another C library: glibc's expm1f, which
# the reference of step 2.1 calls, rounds by the processor, and musl's sinf otherwise than glibc's. Compilers, C libraries and the
# emulator are Debian's packages; libpng, zlib and libyaml for those machines are fetched by apt into a folder, and not installed.
# Usage: machines.sh BUILD PROGRAM [MACHINE…]
set -u
. tests/common.sh
build=$PWD/$1/elsewhere program=$2
shift 2
debs=$build/apt
mkdir -p "$debs/lists/partial" "$debs/archives/partial"

# fetch ARCHITECTURE WHAT PACKAGE…: `download` or `source`, into the present folder.
fetch() {
    local options="-qq -o APT::Architecture=$1 -o APT::Architectures=$1 -o Dir::State::Lists=$debs/lists -o Dir::Cache=$debs
        -o Dir::State::status=/dev/null -o APT::Sandbox::User=root -o Acquire::Languages=none -o Dir::Etc::sourceparts=/dev/null"
    local what=$2
    shift 2
    . /etc/os-release
    for kind in deb deb-src; do echo "$kind [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian $VERSION_CODENAME main"; done >"$debs/list"
    # shellcheck disable=SC2086  # fall apart into words
    apt-get $options -o Dir::Etc::sourcelist="$debs/list" update && apt-get $options -o Dir::Etc::sourcelist="$debs/list" $what "$@"
}

# libraries ARCHITECTURE: theirs, below $there
libraries() (
    [ ! -d "$there/usr" ] || exit 0
    mkdir -p "$there/debs" && cd "$there/debs" && fetch "$1" download libpng16-16 libpng-dev zlib1g libyaml-0-2 libyaml-dev || exit
    for deb in *.deb; do dpkg-deb -x "$deb" "$there" || exit; done
)

# sources: the same three, built by musl's compiler into $there/lib, as no package has them for musl.
sources() (
    [ ! -f "$there/lib/libyaml.a" ] || exit 0
    mkdir -p "$there/include" "$there/lib" && cd "$there" && fetch amd64 "source --download-only" libpng1.6 zlib libyaml &&
        for archive in *.orig.tar.*; do tar -xf "$archive" || exit; done && cp libpng*/scripts/pnglibconf.h.prebuilt include/pnglibconf.h &&
        cp libpng*/*.h zlib*/*.h libyaml*/include/yaml.h include/ || exit
    archive() { # NAME FILE…
        local name=$1 file
        shift
        for file; do
            musl-gcc -O2 -fPIC -w -Iinclude -DHAVE_UNISTD_H -DYAML_VERSION_STRING='"0"' -DYAML_VERSION_MAJOR=0 -DYAML_VERSION_MINOR=0 \
                -DYAML_VERSION_PATCH=0 -c "$file" -o "lib/$name-$(basename "$file").o" || exit
        done
        ar rcs "lib/lib$name.a" lib/"$name"-*.o
    }
    archive z zlib*/*.c && archive png libpng*/png*.c && archive yaml libyaml*/src/*.c
)

# machine NAME ARCHITECTURE TRIPLE EMULATOR
machine() {
    there=$build/$1
    mkdir -p "$there"
    local libs="$there/usr/lib/$3:$there/lib/$3"
    [ "$2" != i386 ] || libs=${libs//i686/i386}
    ok "$1: its libraries" libraries "$2"
    make_there "$1" "$3-gcc" "-I$there/usr/include" "-L${libs%%:*} -lpng -lyaml -Wl,-rpath-link,$libs"
    same_there "$1" "gloss|dispersion" "$4 -L /usr/$3 -E LD_LIBRARY_PATH=$libs:/usr/$3/lib"
}

make_there() {
    ok "$1: it builds" make BUILD="$there/build" CC="$2" HAVE_PREVIEW= PKG= PKG_CFLAGS="$3" PKG_LIBS="$4" "${@:5}" all
}

# same_there NAME ROUNDS EMULATOR, ROUNDS as same_bytes.sh takes it
same_there() {
    printf '#!/bin/sh\nexec %s %s "$@"\n' "$3" "$there/build/photonlab" >"$there/run"
    chmod +x "$there/run"
    bash tests/same_bytes.sh "$program" "$there/run" "$1" "$2" >"$work/same"
    grep -v ' passed, ' "$work/same"
    ok "$1: every picture and photon file" grep -q ' 0 failed' "$work/same"
}

[ $# -gt 0 ] || set -- musl i386 s390x aarch64
for name; do
    case $name in
    musl)
        there=$build/musl
        ok "musl: its libraries, from source" sources
        make_there musl musl-gcc "-I$there/include" "-L$there/lib -lpng -lyaml -lz" OPENMP_WAY= # which is glibc's
        same_there musl . env
        ;;
    i386) machine i386 i386 i686-linux-gnu qemu-i386-static ;;
    s390x) machine s390x s390x s390x-linux-gnu qemu-s390x-static ;;
    aarch64) machine aarch64 arm64 aarch64-linux-gnu qemu-aarch64-static ;;
    *) bad "$name: musl, i386, s390x or aarch64" ;;
    esac
done
finish
