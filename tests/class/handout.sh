#!/usr/bin/env bash
# The students' archive. `make handout` runs it; its arguments come as PHOTONLAB_… from class.mk.
#
# Without solutions' sources, the reference comes along as shared objects in prebuilt/<machine>-<system>/, and
# prebuilt/steps.mk makes the Makefile take them; PHOTONLAB_TAB: the folder of the browser's part, where there is one.
set -u
here=$(cd "$(dirname "$0")" && pwd)
. "$here/files.sh"
. "$here/fewer_stages.sh"
cd "$here/../.." || exit 2
with=${PHOTONLAB_WITH_SOLUTIONS:-}
[ "$with" = 1 ] || with=""
[ -n "$(ls solutions/*/*.c 2>/dev/null)" ] ||
    { echo "handout: there are no solutions here to build the reference from" >&2; exit 2; }
points=${PHOTONLAB_POINTS:-tests/judge/points.txt}
course=$("$PHOTONLAB_BUILD/class_table" --points "$points") || exit 2 # a step a line, and what it is worth
version=$(framework_version)
mkdir -p "$PHOTONLAB_OUT" || exit 2
work=$(mktemp -d "$PHOTONLAB_OUT/.making.XXXXXX") || exit 2
trap 'rm -rf "$work"' EXIT
top=$work/photonlab-$version

# What shows how the steps are solved, how they are usually done wrong, or how to cheat; and the teacher's own tools.
secret='^tests/(mistakes|alternatives|attacks|unit|bench|fuzz|shortage|malformed|extend|elsewhere|scene_page|class|agreement|export|preview|web)/|^course_notes/teachers|^CONTRIBUTING|^tests/.*/README\.md$'
secret="$secret|^tests/[^/]*\\.(awk|md|mk|sh)\$|^tests/judge/.*test|^tests/judge/(README\\.md|calibrate/)"
secret="$secret|^tests/steps/(make_exercises\\.sh|stub\\.awk)"
# Programs behind figures in which a line or two of a step stand, right or wrong; and what plays the known mistakes.
secret="$secret|^course_notes/figures/src/[0-9a-z]*_((ledger|roulette|sample|curves|gather)\\.c|(play|terminal)\\.sh|patches\\.awk)\$"
[ -n "$with" ] || secret="$secret|^solutions/"
students='^tests/(common\.sh|setup\.sh|help\.awk)$|^tests/class/(class\.mk|submit\.sh|update\.sh)$|^tests/mistakes/features\.txt$'
framework_files | grep -E "$students" >"$work/list"
framework_files | grep -vE "$secret|$students" >>"$work/list"
copy_files "$top" <"$work/list" || exit 1
cp "$points" "$top/tests/judge/points.txt" || exit 1

# Stubs as they were, whatever somebody has tried in exercises/.
for stub in exercises/.stubs/*/*.c; do
    cp "$stub" "$top/exercises/${stub#exercises/.stubs/}" || exit 1
done
find "$top/exercises" -name '*.c' ! -path '*/.stubs/*' | while IFS= read -r file; do
    [ -f "exercises/.stubs/${file#"$top/exercises/"}" ] || rm -f "$file"
done

last=$(echo "$course" | sed -n '$s/\..*//p')
! compgen -G "exercises/.stubs/$((last + 1))_*" >/dev/null || fewer_stages "$top" "$last" || exit 1
first_points "$top" "$(echo "$course" | sed -n 's/^1\.1 //p')" "$(echo "$course" | wc -l)" || exit 1

# What is for teachers alone would lead to files that are not there: sections of READMEs, and lines of `make help`.
find "$top" \( -name '*.md' -exec sed -i '/^<!-- teachers -->$/,/^<!-- end of teachers -->$/d' {} + \) -o \
    \( -name Makefile -o -name '*.mk' \) -exec sed -i -E '/^##(teacher|maintainer|check) /d' {} + || exit 1

# What `make check` runs there.
cat >"$top/tests/check.sh" <<'END'
echo "photonlab's own tests are not in the students' archive. \`make test\` grades your work."
END

# The README names nothing that is not there.
sed -i '/^    make setup check /d' "$top/README.md" || exit 1

if [ -z "$with" ]; then
    sed -i '/^| `solutions\/` |/d' "$top/README.md" || exit 1
    platform=$(uname -m)-$(uname -s)
    for object in "$PHOTONLAB_BUILD"/solutions/*/*.so; do
        to=$top/prebuilt/$platform/solutions/${object#"$PHOTONLAB_BUILD"/solutions/}
        mkdir -p "$(dirname "$to")" && cp "$object" "$to" && strip $([ "$(uname -s)" = Darwin ] && echo -x) "$to" ||
            exit 1
    done
    cp "$here/prebuilt.mk" "$top/prebuilt/steps.mk" || exit 1
    if [ -n "${PHOTONLAB_TAB:-}" ]; then
        mkdir "$top/prebuilt/wasm" && cp "$PHOTONLAB_TAB/library.o" "$PHOTONLAB_TAB/reference.a" "$top/prebuilt/wasm/" || exit 1
    fi
fi

(cd "$top" && find . -type f ! -name .photonlab-files | sed 's|^\./||' | LC_ALL=C sort | tr '\n' '\0' |
    xargs -0 sha256sum >.photonlab-files) || exit 1
archive=$PHOTONLAB_OUT/photonlab-$version.tar.gz
tar -cf "$work/archive.tar" --format=ustar --sort=name --owner=0 --group=0 --numeric-owner --mode=go-w -C "$work" \
    "photonlab-$version" &&
    gzip -n -9 "$work/archive.tar" && mv "$work/archive.tar.gz" "$archive" || exit 1
echo "$archive: stages 1 to $last, $(wc -l <"$top/.photonlab-files") files, $(du -k "$archive" | cut -f1) kB, $(
    [ -n "$with" ] && echo "with solutions' sources" || echo "reference built for ${platform%-*} ${platform#*-}")"
