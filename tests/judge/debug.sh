#!/bin/sh
# Opens gdb on the case that failed when the step was last tested. Usage: debug.sh BUILD STEP [run]: `run` only runs the
# case, below an editor's debugger, say. The step may be its file's name.
set -eu
build=$1
step=${2%%_*}
directory=$build/test/$step
command -v gdb >/dev/null 2>&1 || {
    echo "gdb is not installed; make setup does that"
    exit 1
}
if [ ! -e "$directory/step.so" ]; then
    echo "step $step is not started, or does not compile: there is nothing to run yet (make test STEP=$step)"
    exit 0
fi
if [ ! -s "$directory/failing" ]; then
    echo "nothing to debug: step $step has not failed on a single case (make test STEP=$step tells more)"
    exit 0
fi
read -r cases number status <"$directory/failing"
line=$(sed -n "$((number + 1))p" "$directory/$cases")
symbol=$("$build/photonlab" steps | awk -F '\t' -v id="$step" '$1 == id { print $2 }')
echo "the case that failed, in $directory/$cases: $line"
echo "(call: how many times, seed, then the inputs in the order of the contract in lib/steps/)"
run=${3:-}
set -- "$build/probe" --step "$step" --object "$directory/step.so" --references "$build/solutions" --root . \
    --only "$number" --print "$directory/$cases"
[ "$run" != run ] || exec "$@"
if [ "$status" = error ]; then
    echo "gdb runs until it crashes; then: backtrace, up, info locals, print x"
    set -- -ex run -ex backtrace --args "$@"
else
    echo "gdb stops in $symbol with these inputs; then: next, print x, finish, info locals"
    set -- -ex "break $symbol" -ex run --args "$@"
fi
exec gdb -q ${GDB_FLAGS:-} -ex "set breakpoint pending on" -ex "set debuginfod enabled off" -ex "set pagination off" -ex "set print frame-arguments all" "$@"
