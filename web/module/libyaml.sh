#!/bin/sh
# libyaml's sources, which nobody ships for WebAssembly: those of the system's own package, into a folder. Usage:
# libyaml.sh FOLDER. Where there is no apt, LIBYAML=DIR says where they lie unpacked.
set -eu
folder=$1
if [ -n "${LIBYAML:-}" ]; then
    cp "$LIBYAML"/src/*.[ch] "$folder/"
    exit 0
fi
if ! command -v apt-get >/dev/null; then
    echo "web: the sources of libyaml are needed; unpack them, and say where: LIBYAML=DIR make wasm" >&2
    exit 1
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# The archives that packages come from have their sources, too; lists of our own, so that no rights are needed.
# shellcheck disable=SC2016  # apt fills these in
apt-get indextargets --format '$(ORIGIN) deb-src $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
    sed -En 's/^(Debian|Ubuntu) (.* main)$/\2/p' | sort -u >"$work/sources.list"
mkdir -p "$work/lists/partial" "$work/archives/partial"
apt_here() {
    apt-get -qq -o Dir::Etc::SourceList="$work/sources.list" -o Dir::Etc::SourceParts=- -o Dir::State::Lists="$work/lists" \
        -o Dir::Cache="$work" -o Dir::Cache::Archives="$work/archives" -o Debug::NoLocking=1 -o APT::Sandbox::User="$(id -un)" "$@"
}
cd "$work"
apt_here update
apt_here source --download-only libyaml
tar xf libyaml_*.orig.tar.*
cp libyaml-*/src/*.[ch] "$folder/"
