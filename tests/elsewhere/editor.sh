#!/usr/bin/env bash
# .vscode/ and .devcontainer/ held against what is there: targets, ports, a debugger, what compilers print; and tasks are run as
# VS Code runs them. Usage: editor.sh BUILD
set -u
. tests/common.sh
tasks=.vscode/tasks.json launch=.vscode/launch.json container=.devcontainer/devcontainer.json
for file in .vscode/*.json $container; do ok "$file is JSON" jq -e . "$file"; done
jq -r '.tasks[].command' $tasks >"$work/commands"
jq -r '.postCreateCommand' $container >>"$work/commands"
make -pRrq : 2>/dev/null | sed -n 's/^\([a-z][a-z_.]*\):.*/\1/p' >"$work/targets"
for target in $(grep -oE 'make [a-z_.]+' "$work/commands" | cut -d' ' -f2 | sort -u); do
    ok "make $target is one" grep -qx "$target" "$work/targets"
done
port=$(jq -r '.forwardPorts[0]' $container)
ok "the preview comes at the port that is forwarded" grep -q "WEB=1 PORT=$port\$" "$work/commands"
ok "a launch's first task is one" jq -en 'input as $tasks | all(input.configurations[].preLaunchTask; IN($tasks.tasks[].label))' $tasks $launch

# A step with a mistake is the file that is open.
export CODE=$work/code
step=$CODE/1_diffuse_photon_map/1.1_reflect.c
mkdir -p "${step%/*}"
sed 's/-2.0f/-1.0f/' solutions/1_diffuse_photon_map/1.1_reflect.c >"$step"
task() { # LABEL TEXT: it is run, and says so
    sh -c "$(jq -r --arg named "$1" '.tasks[] | select(.label == $named).command' $tasks | sed "s/\${fileBasename}/${step##*/}/g")" \
        >"$work/said" 2>&1
    ok "$1: $2" grep -qF "$2" "$work/said"
}
task "test this step" "the factor 2 is missing"
task "hint for this step" "Step 1.1: Reflect a direction"
task "test this step for the debugger" "the factor 2 is missing"
mapfile -t program < <(jq -r '.configurations[0] | .program, .args[]' $launch | sed "s/\${fileBasenameNoExtension}/1.1_reflect/; s|^build\$|$1|")
jq -r '.configurations[0].setupCommands[].text' $launch >"$work/gdb"
printf '%s\n' 'break 1.1_reflect.c:8' run 'info args' >>"$work/gdb"
gdb -q -batch -x "$work/gdb" --args "${program[@]}" >"$work/said" 2>&1
ok "launch: a breakpoint in the step's file, at the case that failed" grep -q '^Breakpoint 1, reflect ' "$work/said"
ok "launch: its inputs" grep -q '^normal = {' "$work/said"

# What compilers say of a file, as the judge shows it.
matcher=$(jq -r '.tasks[].problemMatcher | objects | .pattern.regexp' $tasks)
echo 'int x = y;' >>"$step"
for compiler in gcc clang; do
    $compiler -std=c99 -fsyntax-only -Ilib "$step" 2>&1 | sed 's/^/        /' |
        jq -rR --arg matcher "$matcher" 'match($matcher)? | [.captures[].string] | join("|")' >"$work/found"
    ok "$compiler: file, line, column and words of an error" grep -qE "^$step\|$(wc -l <"$step")\|9\|error\|.*y" "$work/found"
done
finish
