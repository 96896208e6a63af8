#!/bin/sh
# Installs what building and testing need, where the system's package manager is apt; elsewhere says what to install.
set -eu

packages="gcc make pkg-config libpng-dev libcyaml-dev libyaml-dev libcmocka-dev clang libomp-dev xz-utils
 binutils libgsl-dev libjansson-dev libseccomp-dev libarchive-dev bubblewrap gdb patch parallel zip unzip jq libxml2-utils perl"
packages=$(echo $packages)

others='photonlab needs a C99 compiler, GNU make, libpng, libcyaml and libyaml; make test also GSL, jansson, libseccomp, bubblewrap,
libarchive and gdb; its own tests also cmocka, clang with OpenMP, xz, patch, GNU parallel, zip, unzip, jq, xmllint and perl.
  Fedora     sudo dnf install gcc make pkgconf libpng-devel libcyaml-devel libyaml-devel libcmocka-devel clang libomp-devel xz \
                 gsl-devel jansson-devel libseccomp-devel libarchive-devel bubblewrap gdb binutils patch parallel zip unzip jq libxml2 perl
  Arch       sudo pacman -S gcc make pkgconf libpng libyaml cmocka clang openmp xz gsl jansson libseccomp libarchive bubblewrap gdb \
                 binutils patch parallel zip unzip jq libxml2 perl; libcyaml from the AUR
  Homebrew   brew install make pkg-config libpng libcyaml libyaml cmocka llvm libomp xz gsl jansson libarchive parallel jq
             (the sandbox of make test is for Linux alone: on macOS use a Linux machine or container for it)'

if ! command -v apt-get >/dev/null 2>&1; then
    printf '%s\n' "$others"
    exit 0
fi
missing=""
for package in $packages; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing="$missing $package"
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
# shellcheck disable=SC2086  # the list is meant to fall apart into words
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
