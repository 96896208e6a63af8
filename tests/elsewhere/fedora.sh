#!/bin/sh
# Installs on Fedora what `make setup` names there. With an argument: says how. Usage: fedora.sh [SAY]
set -eu
how=$(sed -n '/^  Fedora /,/[^\\]$/p' "$(dirname "$0")/../setup.sh" | sed 's/^  Fedora *sudo //; s/ \\$//; s/^ */ /; s/dnf install/& -y/' | tr -d '\n')
[ -n "${1:-}" ] && echo "$how" || $how
