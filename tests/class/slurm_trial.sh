#!/usr/bin/env bash
# `make class-slurm` on a cluster of this one machine, which is set up in a folder of its own for as long as this takes: a class
# in parts, a part stopped and sent again, the same table as without a cluster. `make class-slurm-trial` runs it.
# Needs slurmctld, slurmd and munged (Debian: slurm-wlm munge), and root.
set -u
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
. "$here/../common.sh"
cd "$root" || exit 1
export PHOTONLAB_BUILD=$root/${PHOTONLAB_BUILD#"$root/"}
export PATH=$PATH:/usr/sbin
for tool in slurmctld slurmd sbatch munged; do
    command -v "$tool" >/dev/null ||
        { echo "class-slurm-trial needs $tool (on Debian: apt-get install slurm-wlm munge)"; exit 1; }
done
[ "$(id -u)" = 0 ] || { echo "class-slurm-trial needs root, as slurmd does"; exit 1; }

# Daemons of its own, beside a cluster that this machine may belong to.
start_cluster() {
    local host
    host=$(hostname -s)
    chmod 755 "$work"
    mkdir "$work/slurm" "$work/munge" "$work/spool" && chmod 755 "$work/munge"
    head -c 64 /dev/urandom >"$work/munge/key" && chmod 600 "$work/munge/key"
    munged --force --socket "$work/munge/socket" --key-file "$work/munge/key" --pid-file "$work/munge/pid" \
        --log-file "$work/munge/log" --seed-file "$work/munge/seed" 2>/dev/null
    cat >"$work/slurm/slurm.conf" <<END
ClusterName=photonlab
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
StateSaveLocation=$work/slurm
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/ctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/ctld.log
SlurmdLogFile=$work/slurmd.log
ReturnToService=2
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
    export SLURM_CONF=$work/slurm/slurm.conf
    slurmctld && slurmd || return 1
    for _ in $(seq 60); do [ "$(sinfo -h -o %t)" = idle ] && return 0; sleep 0.5; done
    tail -5 "$work"/*.log
    return 1
}

stop_cluster() {
    local pid
    for pid in "$work/slurmd.pid" "$work/ctld.pid" "$work/munge/pid"; do
        [ ! -f "$pid" ] || kill "$(cat "$pid")" 2>/dev/null
    done
    sleep 1
    rm -rf "$work"
}
trap stop_cluster EXIT

waits() { # until no job is left
    for _ in $(seq 600); do [ -z "$(squeue -h)" ] && return 0; sleep 0.5; done
    return 1
}

# Six submissions of two steps each, one of which cannot be read.
class=$work/class
for who in ada bob cyd dan eve; do
    mkdir -p "$class/$who" && cp solutions/1_diffuse_photon_map/1.[12]_*.c "$class/$who/"
done
mkdir "$class/fay"
printf 'login,group\neve,1\nada,2\nzoe,2\n' >"$work/roster.csv"
export PHOTONLAB_DIR=$class PHOTONLAB_ROSTER=$work/roster.csv PHOTONLAB_PARALLEL_FLAGS="" PHOTONLAB_SALT=pepper
table() { sed 's/,[0-9.]*$//' "$work/$1/class.csv"; } # but for the seconds

start_cluster || { bad "a cluster of this machine"; finish; exit 1; }
good "a cluster of this machine: $(sinfo -h -o '%n, %c cores')"
PHOTONLAB_OUT=$work/slurm-out bash "$here/class_slurm.sh" 3 >"$work/said" 2>&1 || bad "class_slurm.sh: $(cat "$work/said")"
array=$(sed -n 's/^parts: job \([0-9]*\).*/\1/p' "$work/said")
for _ in $(seq 100); do grep -qs '\] graded' "$work/slurm-out/.parts/slurm/1.txt" && break; sleep 0.2; done
scancel "$array"_1
ok "the table's job comes after the parts, whatever became of them" waits
check "$(grep -c ',graded,' "$work/slurm-out/class.csv") >= 4" "a part was stopped: $(
    grep 'with a result' "$work/slurm-out/.parts/slurm/table.txt")"
ok "no file that others can read tells the salt" not grep -rlsF pepper "$work/slurm-out/.parts/slurm"
kept=$(sha256sum "$work"/slurm-out/*/report.json)
PHOTONLAB_OUT=$work/slurm-out SHARDS_ASKED=1 bash "$here/class_slurm.sh" 3 >"$work/said" 2>&1
ok "that part alone, sent again" waits
check "$(grep -c '\] kept' "$work/slurm-out/.parts/slurm/1.txt") >= 1" "it keeps what it had"
ok "and no other is touched" sha256sum --quiet -c <<<"$kept"
says_all=$(cat "$work/slurm-out/.parts/slurm/table.txt")
[[ $says_all == *"6 submissions, 6 with a result, 0 not graded"* ]] &&
    good "all have a result" || bad "all have a result: $says_all"
PHOTONLAB_OUT=$work/plain-out bash "$here/class.sh" >"$work/said" 2>&1 || bad "class.sh: $(tail -3 "$work/said")"
ok "the same table as without a cluster" cmp <(table slurm-out) <(table plain-out)
finish
