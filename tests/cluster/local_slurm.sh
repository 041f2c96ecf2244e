#!/usr/bin/env bash
# Starts a Slurm of one node in a folder: munged, slurmctld and slurmd; prints nothing. `stop` ends them.
#   local_slurm.sh start|stop FOLDER
set -euo pipefail
folder=$2
case $1 in
start)
    mkdir -p "$folder/state"
    host=$(hostname -s)
    # The path of a socket has at most 108 bytes, also of those in the spool folder.
    sockets=$(mktemp -d)
    printf '%s\n' "$sockets" >"$folder/sockets"
    dd if=/dev/urandom of="$folder/key" bs=32 count=1 status=none
    chmod 600 "$folder/key"
    cat >"$folder/slurm.conf" <<CONF
ClusterName=local
SlurmctldHost=$host
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$sockets/munge
CredType=cred/munge
CryptoType=crypto/munge
SlurmctldPort=$((20000 + $$ % 20000))
SlurmdPort=$((20001 + $$ % 20000))
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
StateSaveLocation=$folder/state
SlurmdSpoolDir=$sockets/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
SchedulerParameters=sched_interval=1,batch_sched_delay=0,defer_batch
MinJobAge=600
NodeName=$host CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
    export SLURM_CONF=$folder/slurm.conf
    munged --force --key-file="$folder/key" --socket="$sockets/munge" --pid-file="$folder/munged.pid" \
        --log-file="$folder/munged.log" --seed-file="$folder/seed"
    slurmctld -i
    slurmd
    for _ in $(seq 100); do
        [ "$(sinfo -h -o %T 2>/dev/null)" = idle ] && exit 0
        sleep 0.2
    done
    echo "the node did not become idle: $(sinfo -h -o %T 2>&1)" >&2
    exit 1
    ;;
stop)
    for daemon in slurmd slurmctld munged; do
        [ -f "$folder/$daemon.pid" ] && kill "$(cat "$folder/$daemon.pid")" || true
    done
    [ -f "$folder/sockets" ] && rm -rf "$(cat "$folder/sockets")"
    ;;
esac
