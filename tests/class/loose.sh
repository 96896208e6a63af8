# To be sourced by class.sh. Files that lie flat in the folder of submissions, as course systems hand them out:
# doejane_12345_1.1_reflect.c. What stands before the first `_` becomes a submission, a folder of copies in $loose.
loose=$out/.parts/loose
rm -rf "$loose"
mkdir -p "$loose" || exit 2
declare -A sorted=()
# Then numbers and other words of the course system's, then the file's own name.
step_name='[1-9][0-9]*\.[1-9][0-9]*_[a-z_]*'

is_sorted() { [ -n "${sorted[${1##*/}]:-}" ] && [ "${1%/*}" = "$directory" ]; }

# put_loose PERSON FILE NAME: handed in twice under one name, both are there, and class_unpack says so if they differ.
put_loose() {
    local to=$loose/$1 again=1
    mkdir -p "$to" || exit 2
    while [ -e "$to/$3" ] || [ -L "$to/$3" ]; do
        again=$((again + 1))
        to=$loose/$1/again-$again
        mkdir -p "$to" || exit 2
    done
    cp -P "$2" "$to/$3" || exit 2
    sorted[${2##*/}]=1
}

sort_loose() {
    local file name
    local -A people=()
    shopt -s nocasematch nullglob
    for file in "$directory"/*_*.c; do
        name=${file##*/}
        # Canvas puts -1, -2 behind what was handed in again.
        if [[ ! -d $file && $name =~ ^([^_]+)_(.*_)?($step_name)(-[0-9]+)?\.c$ ]]; then
            people[${BASH_REMATCH[1]}]=1
            put_loose "${BASH_REMATCH[1]}" "$file" "${BASH_REMATCH[3]}.c"
        fi
    done
    # Headers and what else in C comes with them.
    for file in "$directory"/*_*; do
        name=${file##*/}
        if [[ ! -d $file && -z ${sorted[$name]:-} && -n ${people[${name%%_*}]:-} &&
            $name =~ ^[^_]+_((late|[0-9]+|assignsubmission|file)_)*(.+\.(c|h|cc|cpp|cxx|c\.txt))$ ]]; then
            put_loose "${name%%_*}" "$file" "${BASH_REMATCH[3]}"
        fi
    done
    shopt -u nocasematch nullglob
}
sort_loose
