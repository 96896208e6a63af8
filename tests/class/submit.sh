#!/usr/bin/env bash
# Puts what a student wrote into one archive that anybody can grade. `make submit` runs it; its arguments come as
# PHOTONLAB_…
#
# Every started step is compiled first, as the judge compiles it: what does not build gets no points, so better know
# today.
set -u
cd "$(dirname "$0")/../.." || exit 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
most_bytes=1048576 # of a file; the judge takes no more

started=()
not_started=()
broken=0
for stub in exercises/.stubs/*/*.c; do
    file=${stub#exercises/.stubs/}
    step=${file##*/}
    step=${step%%_*}
    source=exercises/$file
    if [ ! -f "$source" ] || [ -L "$source" ] || cmp -s "$stub" "$source"; then
        not_started+=("$step")
        continue
    fi
    # shellcheck disable=SC2086  # flags fall apart into words
    if ! "$PHOTONLAB_CC" $PHOTONLAB_FLAGS -Ilib -c "$source" -o "$work/step.o" 2>"$work/said" ||
        ! "$PHOTONLAB_CC" $PHOTONLAB_LINK "$work/step.o" -o "$work/step.so" 2>>"$work/said"; then
        echo "✗ $step does not compile:"
        head -20 "$work/said" | sed 's/^/    /'
        broken=$((broken + 1))
        started+=("$step")
    elif nm -u "$work/step.o" | grep -q photonlab_step_not_started; then
        not_started+=("$step")
        echo "! $step still calls todo(\"$step\") and counts as not started: take that line away in $source"
    else
        started+=("$step")
    fi
done

# Objects, pictures, kept copies and links stay here. make test and make class take the same.
(find exercises -type f \( -name '*.c' -o -name '*.h' -o -name '*.inl' \) ! -path '*/.*' | LC_ALL=C sort) >"$work/list"
find exercises ! -type d ! -path '*/.*' ! -name README.md ! -name '*.png' | grep -vxFf "$work/list" | sed 's/^/left here:   /'
while IFS= read -r file; do
    size=$(wc -c <"$file")
    if [ "$size" -gt $most_bytes ]; then
        echo "✗ $file has $size bytes; the judge takes at most $most_bytes"
        broken=$((broken + 1))
    fi
done <"$work/list"

echo "started:     ${started[*]:-none}"
echo "not started: ${not_started[*]:-none}"
if [ "$broken" -gt 0 ] && [ "${PHOTONLAB_FORCE:-}" != 1 ]; then
    echo "No archive was made. With these faults all the same: make submit FORCE=1"
    exit 1
fi

name=$(printf %s "${PHOTONLAB_NAME:-$(id -un)}" | tr '/[:cntrl:]' '_' | sed 's/^[-.]/_/')
archive=$PHOTONLAB_BUILD/submit/$name-$(date +%Y-%m-%d).tar.gz
mkdir -p "$PHOTONLAB_BUILD/submit"
# The same files give the same bytes, where tar is GNU's.
same=()
tar --version 2>/dev/null | grep -q 'GNU tar' &&
    same=(--format=ustar --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=u=rw,go=r)
tar -cf "$work/archive.tar" ${same[@]+"${same[@]}"} -T "$work/list" && gzip -n -9 "$work/archive.tar" || exit 1
mkdir "$work/check" && gzip -dc "$work/archive.tar.gz" | tar -xf - -C "$work/check" || exit 1
while IFS= read -r file; do
    cmp -s "$file" "$work/check/$file" ||
        { echo "$file did not get into the archive whole; is the disk full?"; exit 1; }
done <"$work/list"
[ ! -e "$archive" ] || echo "(in the place of the one that was made earlier today)"
printf '%s\n' "$name" >"$PHOTONLAB_BUILD/submit/name" # for the finale's frame
cp "$work/archive.tar.gz" "$archive.new" && mv "$archive.new" "$archive" || exit 1
echo "$archive: $(wc -l <"$work/list" | tr -d ' ') files, ${#started[@]} steps started"
[ "${PHOTONLAB_FORCE:-}" != 1 ] || {
    echo "What it gets as it is (make test says why it is not more):"
    "$PHOTONLAB_BUILD/judge" --build "$PHOTONLAB_BUILD" --work "$work/test" --code exercises 2>/dev/null | grep ' points' | tail -1
}
