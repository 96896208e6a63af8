# To be sourced in the checkout's root. The framework's files, as archives for others take them.

# framework_files: all that belongs to it; in a git checkout what git knows or would take in, so no build, no
# submissions.
framework_files() {
    if [ -e .git ] && git rev-parse >/dev/null 2>&1; then
        git ls-files -co --exclude-standard | while IFS= read -r file; do [ ! -f "$file" ] || echo "$file"; done
    else
        find . \( -path ./build -o -path ./submissions -o -name .update -o -name 'before-update-*' \) -prune -o -type \
            f -print |
            sed 's|^\./||' | grep -vE '^(compile_commands\.json|scenes/meshes/(diamond|bumpy_sphere|ring)\.obj)$'
    fi | grep -vE '\.(new-stub|saved-[0-9]+)$|^\.ci/|^\.git(attributes|hub/|lab-ci|/)' | LC_ALL=C sort
}

# framework_version: what the archive is called.
framework_version() {
    if [ -n "${PHOTONLAB_VERSION:-}" ]; then
        printf %s "$PHOTONLAB_VERSION" | tr -c 'A-Za-z0-9._-' '_'
    else
        git describe --tags --always --dirty 2>/dev/null || date +%Y-%m-%d
    fi
}

# copy_files TO: the files whose names come in.
copy_files() (
    set -o pipefail
    mkdir -p "$1" && tar -cf - -T - | tar -xpf - -C "$1"
)
