#!/bin/sh
# Installs what building and testing need, where the system's package manager is apt; elsewhere says what to install.
set -eu

packages="gcc make pkg-config libpng-dev libyaml-dev libcmocka-dev clang libomp-dev xz-utils
 binutils libgsl-dev libjansson-dev libseccomp-dev libarchive-dev bubblewrap gdb patch parallel zip unzip jq libxml2-utils perl
 libglfw3-dev libstb-dev libegl1 libgl1-mesa-dri xvfb xdotool pandoc gnuplot-nox"
packages=$(echo $packages)
# Newer systems have dropped these; something else does their work there.
where_there_is="libosmesa6"

others='photonlab needs a C99 compiler, GNU make, libpng and libyaml; make test also GSL, jansson, libseccomp, bubblewrap,
libarchive and gdb; make preview GLFW, the stb headers and OSMesa or EGL; make notes pandoc, its figures gnuplot; its own tests also
cmocka, clang with OpenMP, xz, patch, GNU parallel, zip, unzip, jq, xmllint, perl, Xvfb and xdotool.
  Fedora     sudo dnf install gcc make pkgconf libpng-devel libyaml-devel libcmocka-devel clang libomp-devel xz \
                 gsl-devel jansson-devel libseccomp-devel libarchive-devel bubblewrap gdb binutils patch parallel zip unzip jq libxml2 perl \
                 glfw-devel stb_easy_font-devel mesa-libEGL mesa-dri-drivers xorg-x11-server-Xvfb xdotool pandoc gnuplot
  Arch       sudo pacman -S gcc make pkgconf libpng libyaml cmocka clang openmp xz gsl jansson libseccomp libarchive bubblewrap gdb \
                 binutils patch parallel zip unzip jq libxml2 perl glfw stb mesa xorg-server-xvfb xdotool pandoc-cli gnuplot
  Homebrew   brew install make pkg-config libpng libyaml cmocka llvm libomp xz gsl jansson libarchive parallel jq \
                 glfw mesa pandoc gnuplot; stb_easy_font.h by hand, without it the preview has no text
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
if [ "$(id -u)" = 0 ]; then
    as_root=""
elif command -v sudo >/dev/null 2>&1; then
    as_root="sudo"
else
    echo "not root, and no sudo here. As root, run:"
    echo "  apt-get update && apt-get install -y$missing"
    exit 1
fi
$as_root apt-get update -qq
for package in $where_there_is; do
    is_installed "$package" || ! apt-cache policy "$package" | grep -q 'Candidate: [0-9]' || missing="$missing $package"
done
# shellcheck disable=SC2086  # the list is meant to fall apart into words
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
