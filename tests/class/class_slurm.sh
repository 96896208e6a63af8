#!/usr/bin/env bash
# `make class` by a Slurm cluster: a job array grades the class in parts, and a job that waits for all of them makes the table.
# Usage: class_slurm.sh [PARTS]; the rest comes as PHOTONLAB_… from teacher.mk.
#
# Checkout, submissions and output are in folders that all nodes see. Flags for sbatch go into SBATCH_… as its manual page lists
# them: SBATCH_PARTITION=short SBATCH_TIMELIMIT=60. What a part had finished when Slurm stopped it is kept when it is sent again:
# all of them, or SHARDS_ASKED=3,7 alone.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
parts=${1:-16}
command -v sbatch >/dev/null || { echo "This needs Slurm's sbatch" >&2; exit 1; }
bash "$here/class.sh" plan
out=$(cd "$PHOTONLAB_OUT" && pwd)
logs=$out/.parts/slurm
mkdir -p "$logs"
unset PHOTONLAB_SALT # it is in the plan, which only you can read
script=$(printf %q "$here/class.sh") place=$(printf %q "$out")

# A core for each part, whatever else the node has.
array=$(sbatch --parsable --job-name=photonlab-class --array="${SHARDS_ASKED:-1-$parts}" --cpus-per-task=1 --output="$logs/%a.txt" <<END
#!/usr/bin/env bash
PHOTONLAB_PARALLEL_FLAGS=-j1 exec bash $script grade $place "\$SLURM_ARRAY_TASK_ID/$parts"
END
)
table=$(sbatch --parsable --job-name=photonlab-table --dependency=afterany:"$array" --output="$logs/table.txt" <<END
#!/usr/bin/env bash
exec bash $script close $place
END
)
echo "$table"
echo "parts: job $array; then job $table makes $out/class.csv and says in $logs/table.txt what is missing" >&2
