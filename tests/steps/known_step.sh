#!/bin/sh
# Is STEP one of the course's? Otherwise says which there are. Usage: known_step.sh TARGET STEP (in the folder that holds
# exercises/). Works without the program, so that a step can be reset when nothing builds.
case $2 in
*[!0-9.]*) ;;
[0-9]*.[0-9]*) for stub in exercises/.stubs/*/"$2"_*.c; do [ -f "$stub" ] && exit 0; done ;;
esac
if [ -z "$2" ]; then
    echo "which step? make $1 STEP=1.1"
else
    echo "there is no step \`$2\`"
fi >&2
echo "The steps are:" >&2
for stub in exercises/.stubs/*/*.c; do
    name=$(basename "$stub" .c)
    echo "  ${name%%_*}  $(echo "${name#*_}" | tr _ ' ')"
done | sort -t . -k 1,1n -k 2,2n >&2
exit 2
