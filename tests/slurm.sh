#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A Slurm of this user, without systemd, in a folder of its own: munged, slurmctld, and a slurmd for each node.
#   tests/slurm.sh up DIR [NODES]   starts it, with one node of two processors, or with NODES that share this machine, of
#                                   one processor each; SLURM_CONF=DIR/slurm.conf then reaches it
#   tests/slurm.sh down DIR         ends it, with its jobs
set -euo pipefail
export PATH=$PATH:/usr/sbin:/sbin
usage() { echo "usage: tests/slurm.sh up DIR [NODES] | down DIR" >&2; exit 2; }
[ $# -eq 2 ] || [ $# -eq 3 ] || usage
nodes=${3:-1}
mkdir -p "$2"
dir=$(cd "$2" && pwd)

# Ports of no other Slurm that starts now, below those that the system gives to connections, with nobody behind them.
free_port() {
  local port offset
  for ((port = 10000 + $$ * 8 % 20000; ; port += 8)); do
    for ((offset = 0; offset <= nodes; ++offset)); do
      (: <>"/dev/tcp/127.0.0.1/$((port + offset))") 2>/dev/null && continue 2
    done
    echo "$port"
    return
  done
}

names() { [ "$nodes" -eq 1 ] && hostname -s || seq -f node%g "$nodes"; }

node_lines() {
  local port=$2
  for name in $(names); do
    echo "NodeName=$name NodeHostname=$1 NodeAddr=127.0.0.1 Port=$((++port)) CPUs=$((nodes == 1 ? 2 : 1)) State=UNKNOWN"
  done
}

up() {
  for program in munged slurmctld slurmd; do
    command -v "$program" >/dev/null || { echo "slurm.sh: no $program: apt-get install slurm-wlm munge" >&2; exit 1; }
  done
  local host port
  host=$(hostname -s)
  port=$(free_port)
  mkdir -p "$dir"/{state,spool,munge}
  chmod 700 "$dir/munge"
  head -c 128 /dev/urandom >"$dir/munge/key"
  chmod 400 "$dir/munge/key"
  munged --force --key-file="$dir/munge/key" --socket="$dir/munge/socket" --pid-file="$dir/munge.pid" \
    --log-file="$dir/munge/log" --seed-file="$dir/munge/seed"
  cat >"$dir/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$dir/munge/socket
CredType=cred/munge
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool/%n
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd-%n.pid
SlurmctldLogFile=$dir/slurmctld.log
SlurmdLogFile=$dir/slurmd-%n.log
SlurmctldPort=$port
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,batch_sched_delay=1
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
$(node_lines "$host" "$port")
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
  export SLURM_CONF=$dir/slurm.conf
  slurmctld -f "$SLURM_CONF"
  for name in $(names); do slurmd -f "$SLURM_CONF" -N "$name"; done
  local -r end=$((SECONDS + 60))  # sinfo itself waits long for a controller that is not there
  while ((SECONDS < end)); do
    [[ $(timeout 5 sinfo --noheader --format=%T:%D 2>/dev/null) != "idle:$nodes" ]] || return 0
    sleep 0.25
  done
  tail -n 20 "$dir"/*.log >&2
  echo "slurm.sh: not all nodes idle after a minute; the logs stand above" >&2
  down
  exit 1
}

down() {
  SLURM_CONF=$dir/slurm.conf scancel --user="$(id -un)" 2>/dev/null || true
  for _ in $(seq 40); do
    [ -n "$(SLURM_CONF=$dir/slurm.conf squeue --noheader 2>/dev/null)" ] || break
    sleep 0.25
  done
  local file pid
  for file in "$dir"/slurmd-*.pid "$dir"/slurmctld.pid "$dir"/munge.pid; do
    [ -f "$file" ] || continue
    pid=$(cat "$file")
    kill "$pid" 2>/dev/null || continue
    for _ in $(seq 40); do
      [[ $(ps -o stat= -p "$pid") == [!Z]* ]] || break  # gone, or not yet waited for
      sleep 0.25
    done
    kill -9 "$pid" 2>/dev/null || true
  done
}

case $1 in up) up ;; down) down ;; *) usage ;; esac
