#!/bin/sh
# Installs what is missing, where the system's package manager is apt; elsewhere says what to install. Usage: setup.sh [TARGET…]
# What students need comes always, what teachers need where their files are, and the rest with a target that needs it.
set -eu

packages="gcc make pkg-config libpng-dev libyaml-dev binutils libgsl-dev libjansson-dev libseccomp-dev bubblewrap gdb
 libglfw3-dev libstb-dev fonts-dejavu-core libegl1 libgl1-mesa-dri pandoc"
[ ! -f tests/class/teacher.mk ] || packages="$packages libarchive-dev parallel zip unzip"
# make setup WEB=1: one's photons in a browser.
[ "${WEB:-0}" = 0 ] || packages="$packages clang lld llvm wasi-libc libclang-rt-dev-wasm32 libmicrohttpd-dev"
for target in "$@"; do
    case $target in
    bench) packages="$packages g++ libnanoflann-dev python3-pip unzip povray xz-utils" ;;
    wasm | site | *-wasm | *-site | *-tab)
        packages="$packages clang lld llvm wasi-libc libclang-rt-dev-wasm32 libmicrohttpd-dev nodejs pandoc webp"
        case $target in *-site | *-tab) packages="$packages npm chromium firefox-esr xvfb xauth" ;; esac
        ;;
    class-alike | check-alike) packages="$packages python3-venv" ;;
    check-export) packages="$packages python3 python3-venv libopenexr-dev" ;;
    check* | reference | agreement | bench-* | calibrate | fuzz* | *figures | *-table)
        packages="$packages git curl libmicrohttpd-dev libcmocka-dev libopenexr-dev clang libomp-dev locales xz-utils patch jq libxml2-utils perl python3 xvfb xdotool x11-utils gnuplot-nox"
        ;;
    esac
    [ "$target" != check-elsewhere ] || packages="$packages qemu-user-static musl-tools dpkg-dev gcc-i686-linux-gnu gcc-s390x-linux-gnu
        gcc-aarch64-linux-gnu libc6-dev-i386-cross libc6-dev-s390x-cross libc6-dev-arm64-cross"
    case $target in check-macos | check-elsewhere | check-ci) packages="$packages python3-pip busybox original-awk libarchive-tools" ;; esac
    case $target in fuzz*) packages="$packages libclang-rt-dev" ;; esac
    case $target in check-debian | check-devcontainer) packages="debootstrap git" ;; esac
done
# Newer systems have dropped these, or call them otherwise.
where_there_is="libosmesa6"

others='photonlab needs a C99 compiler, GNU make, libpng and libyaml; make test also GSL, jansson, libseccomp, bubblewrap,
libarchive and gdb; make preview GLFW, the stb headers, the font DejaVu Sans and OSMesa or EGL, in the browser
(WEB=1) clang, lld, llvm, wasi-libc, compiler-rt for wasm32 and libmicrohttpd; make notes pandoc, its figures gnuplot; pictures in EXR OpenEXR; its own tests also
cmocka, clang with OpenMP, xz, patch, GNU parallel, zip, unzip, jq, xmllint, perl, python3, Xvfb, xprop and xdotool.
  Fedora     sudo dnf install gcc make pkgconf libpng-devel libyaml-devel openexr-devel libcmocka-devel clang libomp-devel xz \
                 gsl-devel jansson-devel libmicrohttpd-devel libseccomp-devel libarchive-devel bubblewrap gdb binutils patch parallel zip unzip jq libxml2 perl python3 \
                 glfw-devel stb_truetype-devel dejavu-sans-fonts mesa-libEGL mesa-dri-drivers xorg-x11-server-Xvfb xprop xdotool pandoc gnuplot
  Arch       sudo pacman -S gcc make pkgconf libpng libyaml openexr cmocka clang openmp xz gsl jansson libmicrohttpd libseccomp libarchive bubblewrap gdb \
                 binutils patch parallel zip unzip jq libxml2 perl glfw stb ttf-dejavu mesa xorg-server-xvfb xorg-xprop xdotool pandoc-cli gnuplot
  Homebrew   brew install make pkg-config libpng libyaml openexr cmocka llvm libomp xz gsl jansson libmicrohttpd libarchive parallel jq \
                 glfw mesa pandoc gnuplot; stb_truetype.h by hand, without it the preview has no text
             (the sandbox of make test is for Linux alone: on macOS use a Linux machine or container for it)'

if ! command -v apt-get >/dev/null 2>&1; then
    printf '%s\n' "$others"
    exit 0
fi
is_installed() {
    dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q 'install ok installed'
}
missing=""
for package in $packages; do
    is_installed "$package" || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

echo "installing:$missing"
stop() {
    echo "$1 As root, run:"
    echo "  apt-get update && apt-get install -y --no-install-recommends$missing"
    exit 1
}
as_root=""
if [ "$(id -u)" != 0 ]; then
    as_root="sudo"
    command -v sudo >/dev/null 2>&1 || stop "not root, and no sudo here."
    sudo true || stop "sudo does not let you."
fi

# Whoever holds one of apt's and dpkg's locks stands in /proc/locks, by the file's number.
is_busy() {
    for lock in /var/lib/apt/lists/lock /var/lib/dpkg/lock-frontend /var/lib/dpkg/lock /var/cache/apt/archives/lock; do
        number=$(stat -c %i "$lock" 2>/dev/null) && grep -q ":$number " /proc/locks 2>/dev/null && return 0
    done
    return 1
}

# apt ARGUMENTS…: after whoever is at it now, a system that updates itself in the background say.
apt() {
    waited=0
    while is_busy; do
        [ $waited != 0 ] || echo "the package manager is busy with something else; waiting for it, ten minutes at most"
        [ $waited -lt 600 ] || stop "it still is: run make setup again later."
        sleep 2
        waited=$((waited + 2))
    done
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600 "$@" >/dev/null
}
apt update
for package in $where_there_is; do
    is_installed "$package" || ! apt-cache policy "$package" | grep -q 'Candidate: [0-9]' || missing="$missing $package"
done
# shellcheck disable=SC2086  # the list is meant to fall apart into words
apt install -y --no-install-recommends $missing
