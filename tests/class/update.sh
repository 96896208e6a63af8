#!/usr/bin/env bash
# Takes a newer photonlab into this folder. `make update FROM=…` runs it. What is the student's stays:
#   a started file in exercises/ (it differs from its stub); if the stub changed, the new one is put beside it,
#   as FILE.new-stub
#   files that were never the framework's
# Files of the framework that somebody changed are replaced, and kept in before-update-N/.
#
# The new one is unpacked and looked over in .update/ first. Then its files are moved here, one after the other; whoever is
# interrupted in that starts make update again, which moves the rest.
set -u
cd "$(dirname "$0")/../.." || exit 2
ready=.update/ready         # the new one, once it is whole and right
list=.update/list           # its files, in the order in which they are moved
differing=.update/differing # those of them that are to be moved
manifest=.photonlab-files   # of a handout: a checksum and a path a line

stop() {
    echo "update: $*" >&2
    exit 2
}

checksums() { # of the files whose names come in, a line each
    if command -v sha256sum >/dev/null; then tr '\n' '\0' | xargs -0 sha256sum; else tr '\n' '\0' |
        xargs -0 shasum -a 256; fi
}

names() { # of a manifest
    sed 's/^[0-9a-f]* [ *]//' "$1"
}

is_step() { case $1 in exercises/*/[0-9]*.c) [[ $1 != exercises/.stubs/* ]] ;; *) false ;; esac; }

is_old_as_given() { # unchanged since the last handout
    [ -f "$manifest" ] && grep -qxF "$(echo "$1" | checksums)" "$manifest"
}

# ---- nothing outside .update/ is touched

unpack() {
    local from=$1 tree=.update/new file
    rm -rf .update
    trap '[ -d "$ready" ] || rm -rf .update' EXIT
    mkdir -p "$tree" || exit 2
    if [ -d "$from" ]; then
        [ "$(cd "$from" && pwd -P)" != "$(pwd -P)" ] || stop "$from is this folder itself"
        tar -cf - --exclude=.git --exclude=./build --exclude=.update --exclude='before-update-*' -C "$from" . | tar -xf - -C "$tree" ||
            stop "$from: cannot be copied; is the disk full?"
    elif [ -f "$from" ]; then
        tar -tf "$from" >"$list" 2>/dev/null || stop "$from: is no archive that can be read"
        ! grep -qE '^/|(^|/)\.\.(/|$)' "$list" || stop "$from: holds paths that lead out of it"
        tar -xf "$from" -C "$tree" || stop "$from: cannot be unpacked"
        [ -f "$tree/Makefile" ] || for tree in "$tree"/*/; do tree=${tree%/}; done
    else
        stop "$from: no such file or folder"
    fi
    for file in Makefile lib/photonlab.h lib/steps/steps.h tests/setup.sh exercises/.stubs; do
        [ -e "$tree/$file" ] || stop "$from: is no photonlab, as $file is not in it"
    done
    if [ -f "$tree/$manifest" ]; then
        (cd "$tree" && names $manifest | checksums) 2>/dev/null | cmp -s - "$tree/$manifest" ||
            stop "$from: is not complete, or was changed"
    fi
    # Steps first, while their old stubs tell which are started; Makefile and manifest last: until then this is the old version.
    (cd "$tree" && if [ -f $manifest ]; then names $manifest && echo $manifest; else find . -type f | sed 's|^\./||'; fi) | awk -v last="$manifest" '
        { of = $0 == last ? 4 : $0 == "Makefile" ? 3 : /^exercises\/[^.]/ ? 1 : 2; lines[of] = lines[of] $0 "\n" }
        END { for (of = 1; of <= 4; of++) printf "%s", lines[of] }' >"$list" && mv "$tree" "$ready" || exit 2
}

# ---- every line can be done again

remove_old() {
    local file
    while IFS= read -r file; do
        [ -e "$file" ] || continue
        if is_old_as_given "$file"; then
            rm -f "$file" && rmdir -p "$(dirname "$file")" 2>/dev/null
            removed=$((removed + 1))
        else
            echo "no longer part of photonlab, left as you changed it: $file"
        fi
    done < <([ ! -f "$manifest" ] || names "$manifest" | grep -vxFf "$list")
}

there() { # of the files whose names come in, those in $1
    while IFS= read -r file; do [ ! -f "$1/$file" ] || echo "$file"; done
}

# find_differing: into $differing, the new one's files that are not the same here, in the list's order, as lines of a manifest.
find_differing() {
    there "$ready" <"$list" | (cd "$ready" && checksums) >.update/new.sums || return
    names .update/new.sums | there . | checksums >.update/old.sums
    awk 'FILENAME == ARGV[1] { same[$0]; next } !($0 in same)' .update/old.sums .update/new.sums >"$differing"
}

move_new() {
    local file stub n=1 kept
    while [ -e "before-update-$n" ]; do n=$((n + 1)); done
    kept=before-update-$n
    while IFS= read -r file; do
        [ -e "$ready/$file" ] || continue # moved before an interruption
        if is_step "$file"; then
            stub=exercises/.stubs/${file#exercises/}
            if [ -e "$file" ] && ! cmp -s "$file" "$stub"; then
                echo "yours, left alone: $file"
                cmp -s "$stub" "$ready/$file" && continue
                mv -f "$ready/$file" "$file.new-stub" || stop "$file.new-stub: cannot be made; make update again"
                echo "    its stub has changed; the new one is beside it: $file.new-stub"
                continue
            fi
        elif [ -e "$file" ] && [ "$file" != "$manifest" ] && ! is_old_as_given "$file"; then
            mkdir -p "$kept/$(dirname "$file")" && mv "$file" "$kept/$file" || stop "$file: cannot be kept; make update again"
            echo "replaced, yours is kept in $kept/: $file"
        fi
        mkdir -p "$(dirname "$file")" && mv -f "$ready/$file" "$file" || stop "$file: cannot be replaced; make update again"
        replaced=$((replaced + 1))
    done < <(names "$differing")
}

take_over() {
    replaced=0
    removed=0
    find_differing || stop "the new files cannot be compared with yours; is the disk full? Make update again"
    remove_old
    move_new
    rm -rf .update
    echo "$replaced files new or replaced, $removed removed"
}

from=${PHOTONLAB_FROM:-}
if [ -d "$ready" ]; then
    echo "finishing an update that was interrupted"
    take_over
    [ -n "$from" ] || exit 0
fi
ls solutions/*/*.c >/dev/null 2>&1 &&
    stop "this is the whole photonlab, with its solutions, and what students get has other files. Update it with git."
[ -n "$from" ] || stop "from where? make update FROM=photonlab-2.tar.gz, or a folder"
unpack "$from"
take_over
