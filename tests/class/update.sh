#!/usr/bin/env bash
# Takes a newer photonlab into this folder. `make update FROM=…` runs it. What is the student's stays:
#   a started file in exercises/ (it differs from its stub); if the stub changed, the new one is put beside it,
#   as FILE.new-stub
#   files that were never the framework's
# Files of the framework that somebody changed are replaced, and kept in before-update-N/.
#
# All is prepared in .update/ first. Then a list of renames is written down, and done; whoever is interrupted in it
# starts make update again, and the list is done to its end.
set -u
cd "$(dirname "$0")/../.." || exit 2
room=.update
manifest=.photonlab-files # of a handout: a checksum and a path a line

stop() {
    echo "update: $*" >&2
    exit 2
}

checksums() { # of the files whose names come in, a line each
    if command -v sha256sum >/dev/null; then tr '\n' '\0' | xargs -0 sha256sum; else tr '\n' '\0' |
        xargs -0 shasum -a 256; fi
}

# ---- the second half: what stands in .update/switch is done; every line can be done again

do_switch() {
    local action file
    while IFS=' ' read -r action file; do
        case $action in
        put)
            [ -e "$room/ready/$file" ] || continue
            mkdir -p "$(dirname "$file")" && mv -f "$room/ready/$file" "$file" ||
                stop "$file: cannot be replaced; make update again"
            ;;
        remove) rm -f "$file" && rmdir -p "$(dirname "$file")" 2>/dev/null ;;
        esac
    done <"$room/switch"
    cat "$room/said"
    rm -rf "$room"
}

if [ -f "$room/switch" ]; then
    echo "finishing an update that was interrupted"
    do_switch
    [ -n "${PHOTONLAB_FROM:-}" ] || exit 0
fi
rm -rf "$room"

ls solutions/*/*.c >/dev/null 2>&1 &&
    stop "this is the whole photonlab, with its solutions, and what students get has other files. Update it with git."

# ---- the first half: nothing outside .update/ is touched

from=${PHOTONLAB_FROM:-}
[ -n "$from" ] || stop "from where? make update FROM=photonlab-2.tar.gz, or a folder"
mkdir -p "$room/new" "$room/ready" || exit 2
trap '[ -f "$room/switch" ] || rm -rf "$room"' EXIT
if [ -d "$from" ]; then
    [ "$(cd "$from" && pwd -P)" != "$(pwd -P)" ] || stop "$from is this folder itself"
    tree=$from
elif [ -f "$from" ]; then
    tar -tf "$from" >"$room/list" 2>/dev/null || stop "$from: is no archive that can be read"
    ! grep -qE '^/|(^|/)\.\.(/|$)' "$room/list" || stop "$from: holds paths that lead out of it"
    tar -xf "$from" -C "$room/new" || stop "$from: cannot be unpacked"
    tree=$room/new
    [ -f "$tree/Makefile" ] || for folder in "$tree"/*/; do tree=${folder%/}; done
else
    stop "$from: no such file or folder"
fi
for file in Makefile lib/photonlab.h lib/steps/steps.h tests/setup.sh exercises/.stubs; do
    [ -e "$tree/$file" ] || stop "$from: is no photonlab, as $file is not in it"
done

# The framework's files, there and here. Without a list, all that lies there counts, and nothing is known to be old
# here.
if [ -f "$tree/$manifest" ]; then
    sed 's/^[0-9a-f]* [ *]//' "$tree/$manifest" >"$room/there"
    (cd "$tree" && checksums) <"$room/there" >"$room/sums" 2>/dev/null
    cmp -s "$room/sums" "$tree/$manifest" || stop "$from: is not complete, or was changed"
    echo "$manifest" >>"$room/there"
else
    (cd "$tree" && find . \( -name .git -o -path ./build -o -name .update -o -name 'before-update-*' \) -prune -o \
        -type f -print) |
        sed 's|^\./||' >"$room/there"
fi
: >"$room/here"
[ ! -f "$manifest" ] || sed 's/^[0-9a-f]* [ *]//' "$manifest" >"$room/here"
is_step() { case $1 in exercises/*/[0-9]*.c) [ -f "$tree/exercises/.stubs/${1#exercises/}" ] ||
    [ -f "exercises/.stubs/${1#exercises/}" ] ;; *) false ;; esac; }
is_old_as_given() { # unchanged since the last handout
    [ -f "$manifest" ] && grep -qxF "$(echo "$1" | checksums)" "$manifest"
}

n=1
while [ -e "before-update-$n" ]; do n=$((n + 1)); done
kept=before-update-$n
: >"$room/said" && : >"$room/plan" && mkdir "$room/saved"
replaced=0
put() { # put FILE SOURCE
    mkdir -p "$room/ready/$(dirname "$1")" && cp "$2" "$room/ready/$1" ||
        stop "$1: cannot be prepared; is the disk full?"
    echo "put $1" >>"$room/plan"
}
save() {
    mkdir -p "$room/ready/$kept/$(dirname "$1")" && cp -p "$1" "$room/ready/$kept/$1" ||
        stop "$1: cannot be kept; is the disk full?"
    echo "put $kept/$1" >>"$room/plan"
    echo "replaced, yours is kept in $kept/: $1" >>"$room/said"
}

# Makefile and list come last: until then this is the old version, with a switch to finish.
{ grep -vxE "Makefile|$manifest" "$room/there"; grep -xE "Makefile|$manifest" "$room/there"; } >"$room/order"
while IFS= read -r file; do
    if is_step "$file"; then
        stub=exercises/.stubs/${file#exercises/}
        if [ -e "$file" ] && ! cmp -s "$file" "$stub"; then
            cmp -s "$file" "$tree/$stub" && continue
            echo "yours, left alone: $file" >>"$room/said"
            cmp -s "$stub" "$tree/$stub" && continue
            put "$file.new-stub" "$tree/$stub"
            echo "    its stub has changed; the new one is beside it: $file.new-stub" >>"$room/said"
            continue
        fi
        cmp -s "$file" "$tree/$stub" || { put "$file" "$tree/$stub" && replaced=$((replaced + 1)); }
    elif ! cmp -s "$file" "$tree/$file"; then
        [ ! -e "$file" ] || is_old_as_given "$file" || [ "$file" = "$manifest" ] || save "$file"
        put "$file" "$tree/$file"
        replaced=$((replaced + 1))
    fi
done <"$room/order"

removed=0
while IFS= read -r file; do
    grep -qxF "$file" "$room/there" && continue
    [ -e "$file" ] || continue
    if is_old_as_given "$file"; then
        echo "remove $file" >>"$room/plan"
        removed=$((removed + 1))
    else
        echo "no longer part of photonlab, left as you changed it: $file" >>"$room/said"
    fi
done <"$room/here"

echo "$replaced files new or replaced, $removed removed" >>"$room/said"
mv "$room/plan" "$room/switch"
do_switch
