#!/usr/bin/env bash
# One picture by a cluster: a Slurm job array makes the parts of its passes, and a job that waits for all of them merges them.
# Usage: slurm.sh PROGRAM SCENE OUT PASSES PARTS [FLAG…]
#
# The folder is one that all nodes see. Flags for sbatch, a partition or a time limit say, go into SBATCH_… as its manual page
# lists them: SBATCH_PARTITION=short SBATCH_TIMELIMIT=10. A job that Slurm stops keeps its passes, and goes on from there when
# it is sent again, as it is when only some parts are to be made: PARTS_ASKED=3,7.
set -eu
program=$1 scene=$2 out=$3 passes=$4 parts=$5
shift 5
command -v sbatch >/dev/null || { echo "This needs Slurm's sbatch" >&2; exit 1; }
mkdir -p "$out.parts"
quoted=$(printf ' %q' "$program" "$scene" "$passes" "$parts" "$out" "$@")

# What each of the jobs runs; Slurm says which part it is, and asks it to stop a minute before its time is over.
array=$(sbatch --parsable --job-name=photonlab --array="${PARTS_ASKED:-1-$parts}" --output="$out.parts/%a.txt" --signal=TERM@60 <<END
#!/usr/bin/env bash
set -- $quoted
program=\$1 scene=\$2 passes=\$3 parts=\$4 file=\$5.parts/\$SLURM_ARRAY_TASK_ID.part
shift 5
[ ! -s "\$file" ] || set -- "\$@" --resume "\$file"
exec srun --ntasks=1 "\$program" render "\$scene" -o "\$file" --passes "\$passes" --part "\$SLURM_ARRAY_TASK_ID/\$parts" "\$@"
END
)
merge=$(sbatch --parsable --job-name=photonlab-merge --dependency=afterany:"$array" --output="$out.parts/merge.txt" <<END
#!/usr/bin/env bash
set -- $quoted
exec "\$1" merge "\$5".parts/*.part -o "\$5"
END
)
echo "$merge"
echo "parts: job $array; then job $merge makes $out, or says in $out.parts/merge.txt what is missing" >&2
