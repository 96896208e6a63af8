# To be sourced by class.sh. Files that lie flat in the folder of submissions, as course systems hand them out: each person's
# go into a folder of copies in $loose, which is a submission.
#   Canvas   doejane_4711_98_work.tar.gz, doejane_LATE_4711_98_1.1_reflect-1.c: name, Canvas' number, the file's number
#   Moodle   Jane Doe_4711_assignsubmission_file_1.1_reflect.c
#   others   doejane_1.1_reflect.c: what stands before the first `_` of a file that is called like a step
loose=$out/.parts/loose
rm -rf "$loose"
mkdir -p "$loose" || exit 2
declare -A sorted=()
step_name='[1-9][0-9]*\.[1-9][0-9]*_[a-z_]*'

is_sorted() { [ -n "${sorted[${1##*/}]:-}" ] && [ "${1%/*}" = "$directory" ]; }

# put_loose PERSON FILE NAME: handed in twice under one name, both are there, and class_unpack says so if they differ.
put_loose() {
    local to=$loose/$1 name=$3 again=1
    # Canvas puts -1, -2 before the last ending of what was handed in again.
    [[ $name =~ ^($step_name)-[0-9]+\.c$ ]] && name=${BASH_REMATCH[1]}.c
    [[ $name =~ ^(.+\.tar)-[0-9]+(\.[a-z0-9]+)$ ]] && name=${BASH_REMATCH[1]}${BASH_REMATCH[2]}
    mkdir -p "$to" || exit 2
    while [ -e "$to/$name" ] || [ -L "$to/$name" ]; do
        again=$((again + 1))
        to=$loose/$1/again-$again
        mkdir -p "$to" || exit 2
    done
    cp -Pp "$2" "$to/$name" || exit 2
    sorted[${2##*/}]=1
}

sort_loose() {
    local file name
    local -A people=()
    shopt -s nocasematch nullglob
    for file in "$directory"/*_*; do
        name=${file##*/}
        if [ -d "$file" ]; then
            continue
        elif [[ $name =~ ^([^_]+(_LATE)?_[0-9]+|(LATE_)?anon_[a-z0-9]+)_[0-9]+_(.+)$ ]]; then
            put_loose "${BASH_REMATCH[1]}" "$file" "${BASH_REMATCH[4]}"
        elif [[ $name =~ ^(.+_[0-9]+)_assignsubmission_file_(.+)$ ]]; then
            put_loose "${BASH_REMATCH[1]}" "$file" "${BASH_REMATCH[2]}"
        elif [[ $name =~ ^([^_]+)_(.*_)?($step_name(-[0-9]+)?\.c)$ ]]; then
            people[${BASH_REMATCH[1]}]=1
            put_loose "${BASH_REMATCH[1]}" "$file" "${BASH_REMATCH[3]}"
        fi
    done
    # Headers and what else in C comes with them.
    for file in "$directory"/*_*; do
        name=${file##*/}
        if [[ ! -d $file && -z ${sorted[$name]:-} && -n ${people[${name%%_*}]:-} &&
            $name =~ ^[^_]+_((late|[0-9]+)_)*(.+\.(c|h|cc|cpp|cxx|c\.txt))$ ]]; then
            put_loose "${name%%_*}" "$file" "${BASH_REMATCH[3]}"
        fi
    done
    shopt -u nocasematch nullglob
}
sort_loose
