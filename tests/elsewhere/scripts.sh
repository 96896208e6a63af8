#!/usr/bin/env bash
# What students run, with the tools that a Mac has: none of GNU's, no sandbox, a bash of 2007. In the place of a Mac's tools stand
# busybox's, the awk and tar that a Mac has, and a guard that refuses what only GNU's take. Usage: scripts.sh SHELLCHECK
set -u
shellcheck=$PWD/$1
. tests/common.sh
bin=$work/bin tree=$work/tree
mkdir "$bin" "$tree"
for name in bash sh make gcc as ld ar nm gzip getconf locale pandoc perl shasum cksum; do
    ln -s "$(command -v $name)" "$bin/" || bad "no $name here"
done
ln -s "$(command -v original-awk)" "$bin/awk"
ln -s "$(command -v bsdtar)" "$bin/tar"
for name in basename cat chmod cmp comm cp cut date dd diff dirname du echo env expr false find fold grep head id kill ln ls mkdir mktemp \
    mv nice od paste printf ps pwd readlink rm rmdir sed seq sleep sort split stat tail tee test touch tr true uname uniq wc whoami xargs; do
    ln -s guard "$bin/$name"
done
cat >"$bin/guard" <<END
#!$(command -v bash)
name=\${0##*/} old=" -"
for word; do [ "\$name \$word" != "sed -E" ] || old=""; done
for word; do
    case "\$name\$old \$word" in
    "sed - "*\\\\[+?\\|]* | "sed"*" -i" | "sed"*" -"[!e]*z* | "date - -d"* | "date - "*%N* | "stat - -c"* | "mv - -T" | "ln - -"*T* | \\
    "grep - -"*P* | "find - -printf" | "head - -"*-[0-9]* | "mktemp - -p" | "xargs - -d"* | "du - -b" | *" --"?*)
        echo "\$name \$*" >>"$work/refused"
        exit 64 ;;
    esac
done
[ "\$name" != wc ] || { $(command -v busybox) wc "\$@" | $(command -v busybox) sed 's/^/     /'; exit; }
exec $(command -v busybox) "\$name" "\$@"
END
chmod +x "$bin/guard"
for wrong in "sed -i s/a/b/ x" "sed s/a\\+/b/ x" "date -d yesterday" "stat -c %s x" "sort --version-sort x"; do
    # shellcheck disable=SC2086  # falls apart into words
    expect 64 "" env PATH="$bin" ${wrong%% *} ${wrong#* }
done
: >"$work/refused"

# As on a Mac, there is no sandbox.
git ls-files -z | xargs -0 tar -cf - | tar -xf - -C "$tree"
mac() { (cd "$tree" && env -i PATH="$bin" HOME="$work" "$bin/make" SYSTEM=Other CC=gcc "$@"); }
expect 0 "Homebrew" mac setup
expect 0 "make preview" mac help
expect 0 "build/photonlab" mac
expect 0 "NO SANDBOX: the sandbox needs Linux" mac test CODE=solutions STAGE=1
ok "and whose rights the code has is said" said "The code runs with your rights"
ok "and it is graded" said "✓ 1.6"
expect 2 "NO SANDBOX" mac test CODE=solutions STEP=1.1 JUDGE_FLAGS=--credit
expect 0 "Hint 1 of 3" mac hint STEP=1.1
expect 2 "there is no step" mac hint STEP=9.9
cp "$tree/solutions/1_diffuse_photon_map/1.1_reflect.c" "$tree/exercises/1_diffuse_photon_map/"
expect 0 "1 steps started" mac submit NAME=ada
expect 0 "✓ 1.1" mac report STEP=1.1
expect 0 "is kept as" mac reset STEP=1.1
expect 0 "" mac render SCENE=scenes/box_diffuse.yaml FLAGS='--size 32x32 --photons 1000'
expect 0 "build/preview.png" mac snapshot STAGE=1
expect 0 "finale.png" mac finale CODE=solutions SIDE=16
expect 0 "index.html" mac notes
expect 0 "" mac clean
ok "no tool was asked for what a Mac's does not know" diff "$work/refused" /dev/null

# What bash 3.2 does not know, and an empty array under set -u, which it takes for unset.
students="scenes/*.sh scenes/machines/parallel.sh tests/setup.sh tests/common.sh tests/class/submit.sh tests/class/update.sh
    tests/judge/finale.sh tests/judge/debug.sh tests/steps/*.sh course_notes/make_page.sh course_notes/make_pdf.sh"
# shellcheck disable=SC2086  # a list
ok "nothing that is younger than a Mac's bash" not grep -nE 'declare -A|local -[An]|mapfile|readarray|\$\{[a-z_]+(\^|,)|&>>|\|&|coproc|wait -n|EPOCH|BASHPID|globstar|\[-1\]' $students
# shellcheck disable=SC2086
ok "what students run: shellcheck" "$shellcheck" -x -S warning -e SC2054,SC2148,SC2154 $students
ok "all scripts: shellcheck's errors" "$shellcheck" -S error -e SC2148 $(git ls-files '*.sh')
finish
