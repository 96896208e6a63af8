#!/usr/bin/env bash
# Does everything compile and link for a Mac? By zig's compiler, which brings Apple's headers; instead of the libraries that
# Homebrew installs there, headers of this machine and lists of the names in its libraries. Nothing of it can run here.
# Usage: macos.sh BUILD ZIG OBJECT_NAMES
set -u
build=$(cd "$1" && pwd)/macos zig=$PWD/$2 names=$3
. tests/common.sh
brew=$build/brew
mkdir -p "$brew/include/OpenGL" "$brew/lib"

# header NAME [AS]: one of this machine's, where Homebrew's would lie.
header() {
    local at
    for at in /usr/include "/usr/include/$(gcc -print-multiarch)" /usr/include/libpng16 /usr/lib/llvm-*/lib/clang/*/include; do
        [ ! -e "$at/$1" ] || { ln -sfn "$at/$1" "$brew/include/${2:-$1}" && return; }
    done
    bad "no $1 here: make setup check"
}

# library NAME FILE [SYMBOL]: what a Mac's linker asks of a library, made of the names in one of this machine; and one
# that is younger than that.
library() {
    local file
    file=$(find /usr/lib /lib -name "$2*" 2>/dev/null | sort | head -1)
    { printf -- '--- !tapi-tbd\ntbd-version: 4\ntargets: [x86_64-macos, arm64-macos]\ninstall-name: lib%s.dylib\nexports:\n' "$1"
      printf '  - targets: [x86_64-macos, arm64-macos]\n    symbols: ['
      nm -D --defined-only "${file:?$2 is not here: make setup check}" |
          awk '{ sub(/@.*/, "", $3) } $3 !~ /[.]/ && !there[$3]++ { printf "%s_%s", comma, $3; comma = ", " }'
      printf '%s]\n...\n' "${3:+, _$3}"; } >"$brew/lib/lib$1.tbd"
}

for name in png.h pngconf.h pnglibconf.h yaml.h jansson.h jansson_config.h gsl archive.h archive_entry.h GLFW stb KHR omp.h; do
    header "$name"
done
header GL/glcorearb.h OpenGL/gl3.h
for name in png16 yaml-0 gsl gslcblas jansson archive; do
    short=${name%[0-9][0-9]}
    library "${short%-0}" "lib$name.so"
done
library omp libomp.so __kmpc_dispatch_deinit

for processor in aarch64 x86_64; do
    there=$build/$processor
    mkdir -p "$there"
    # Asked to write to /dev/null, zig links nothing and finds no fault.
    cat >"$there/cc" <<END
#!/usr/bin/env bash
for word; do
    [ "\$last \$word" != "-o /dev/null" ] || word=$there/nothing
    words+=("\$word") last=\$word
done
# For a look at the syntax alone it makes an empty a.out.
[[ " \${words[*]} " != *" -fsyntax-only "* ]] || words+=(-o $there/nothing)
exec $zig cc -target $processor-macos "\${words[@]}"
END
    chmod +x "$there/cc"
    ok "$processor: library, program, preview, steps, judge and the class's tools compile and link" \
        make -k BUILD="$there" CC="$there/cc" SYSTEM=Darwin PKG= BREW="$brew" EXTRA=-Werror HAVE_PREVIEW=yes judge class-tools
    for file in libphotonlab.so photonlab judge probe write_reports solutions/1_diffuse_photon_map/1.1_reflect.so; do
        ok "$processor: $file is a Mac's" cmp -n 4 "$there/$file" <(printf '\317\372\355\376')
    done
done

# What the judge sees in a step before it runs is the same as in an object of Linux, and cut files are survived.
cat >"$work/step.c" <<'END'
#include <stdlib.h>
static int keeps(void) { static int count; return ++count; }
static int helper(int a) { return a > 0 ? helper(a - 1) + rand() : keeps(); }
static int (*const table[])(int) = {helper, abs};
const char *const names[] = {"a", "b"};
int reflect(int a) { return table[a & 1](a); }
END
echo '__attribute__((constructor)) static void early(void) { } int reflect; int refract(void) { early(); return 0; }' >"$work/early.c"
echo 'static int refract(int a) { return a < 2 ? 1 : refract(a - 1) + refract(a - 2); } int (*const reflect)(int) = refract;' >"$work/private.c"
seen() { # NAME PROCESSOR
    "$zig" cc -target "$2-macos" -O0 -fno-sanitize=all -c "$work/$1.c" -o "$work/$1.o" && "$names" "$work/$1.o" | sort | paste -sd, -
}
for processor in aarch64 x86_64; do
    for row in "step:function reflect,keeps-data,private helper,private keeps,variable keeps.count,wants abs,wants rand" \
        "early:function refract,keeps-data,private early,runs-at-load,variable reflect" "private:private refract"; do
        expect 0 "${row#*:}" seen "${row%%:*}" $processor
    done
done
size=$(wc -c <"$work/step.o") cut=0 refused=0 wrong=0
for ((end = 0; end < size; end += 7)); do
    head -c "$end" "$work/step.o" >"$work/cut.o"
    "$names" "$work/cut.o" >/dev/null 2>"$work/err"
    case $?$(cat "$work/err") in
    0) ;;
    "1$work/cut.o: is no object file of this machine's") refused=$((refused + 1)) ;;
    *) wrong=$((wrong + 1)) ;;
    esac
    cut=$((cut + 1))
done
check "$wrong == 0 && $refused > $cut / 4" "of $cut cut files $refused are refused, and none is read beyond its end"
finish
