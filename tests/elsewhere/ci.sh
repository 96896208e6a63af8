#!/usr/bin/env bash
# The files for GitHub's and GitLab's machines, by their schemas; their commands, as far as they can be looked at from here.
# Usage: ci.sh CHECK_JSONSCHEMA SHELLCHECK
set -u
. tests/common.sh
schema() { PYTHONPATH="$1" "$1/bin/check-jsonschema" --builtin-schema "vendor.$2" "$3"; }
ok "GitHub's fits its schema" schema "$1" github-workflows .github/workflows/ci.yml
ok "GitLab's fits its schema" schema "$1" gitlab-ci .gitlab-ci.yml
sed 's/^  script:/  scrpt:/' .gitlab-ci.yml >"$work/gitlab.yml"
sed 's/runs-on:/runs_on:/' .github/workflows/ci.yml >"$work/github.yml"
ok "and a mistake in it would be found" not schema "$1" github-workflows "$work/github.yml"
ok "and in GitLab's" not schema "$1" gitlab-ci "$work/gitlab.yml"
if command -v actionlint >/dev/null; then
    ok "GitHub's by actionlint" actionlint -shellcheck "$2" .github/workflows/ci.yml
else
    echo "  (actionlint is not here: go install github.com/rhysd/actionlint/cmd/actionlint@latest)"
fi
expect 0 "dnf install -y gcc make" sh tests/elsewhere/fedora.sh say

# Every target that is named is one, and both name the same.
targets() { sed -nE 's/^ *- (run: )?g?make //p' "$1" | tr ' ' '\n' | grep -v = | sort -u; }
for target in $(targets .github/workflows/ci.yml); do ok "make $target" make -n "$target"; done
ok "GitLab does what GitHub does" diff <(targets .github/workflows/ci.yml) <(targets .gitlab-ci.yml)
finish
