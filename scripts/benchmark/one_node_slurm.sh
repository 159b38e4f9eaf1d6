#!/usr/bin/env bash
# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
#
# A Slurm cluster of this machine alone, to try the profile on. Touches nothing outside DIR; needs
# the packages of scripts/setup.sh --slurm.
#   one_node_slurm.sh start DIR   starts it; then: export SLURM_CONF=DIR/slurm.conf
#   one_node_slurm.sh stop DIR    stops it
set -euo pipefail

if [[ $# != 2 || ! "$1" =~ ^(start|stop)$ ]]; then
  echo "usage: one_node_slurm.sh start|stop DIR" >&2
  exit 2
fi
command=$1
mkdir -p "$2"
directory=$(realpath "$2")
export SLURM_CONF=$directory/slurm.conf
# Debian keeps the daemons where only root's PATH looks.
PATH=$PATH:/usr/sbin:/sbin

# Two free ports, so that several clusters can stand on one machine.
free_ports() {
  python3 -c '
import socket
sockets = [socket.socket() for _ in range(2)]
for one in sockets: one.bind(("127.0.0.1", 0))
print(*(one.getsockname()[1] for one in sockets))'
}

write_configuration() {
  local controller_port node_port
  read -r controller_port node_port < <(free_ports)
  cat >"$SLURM_CONF" <<CONFIGURATION
ClusterName=one_node
SlurmctldHost=localhost
SlurmctldPort=$controller_port
SlurmdPort=$node_port
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$directory/munge.socket
CredType=cred/munge
StateSaveLocation=$directory/state
SlurmdSpoolDir=$directory/spool
SlurmctldPidFile=$directory/slurmctld.pid
SlurmdPidFile=$directory/slurmd.pid
SlurmctldLogFile=$directory/slurmctld.log
SlurmdLogFile=$directory/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=sched_interval=1,batch_sched_delay=0
ReturnToService=2
MpiDefault=none
NodeName=localhost CPUs=$(nproc) RealMemory=$(free -m | awk '/^Mem:/ {print $2}') State=UNKNOWN
PartitionName=all Nodes=localhost Default=YES MaxTime=INFINITE State=UP
CONFIGURATION
}

node_is_idle() {
  sinfo --noheader --format=%t 2>/dev/null | grep -qx idle
}

# Repeats a command until it succeeds; fails after 10 s.
wait_until() {
  for _ in {1..100}; do
    if "$@"; then return 0; fi
    sleep 0.1
  done
  return 1
}

# Daemons that run already must not outlive one that does not.
give_up() {
  echo "one_node_slurm.sh: Slurm does not start; see $directory/*.log" >&2
  stop
}

start() {
  trap give_up EXIT
  mkdir -p "$directory/state" "$directory/spool"
  # Munge insists that nobody else can read its key or write its folders.
  chmod 755 "$directory"
  (umask 077 && head -c 128 /dev/urandom >"$directory/munge.key")
  munged --force --socket="$directory/munge.socket" --key-file="$directory/munge.key" \
    --pid-file="$directory/munge.pid" --log-file="$directory/munge.log" \
    --seed-file="$directory/munge.seed"
  write_configuration
  slurmctld
  # It tells its number only after it went to the background, and cannot be stopped before that.
  wait_until test -s "$directory/slurmctld.pid"
  slurmd -N localhost
  wait_until node_is_idle
  trap - EXIT
}

# One that has ended but was not yet waited for by its parent is a zombie.
has_ended() {
  [[ "$(ps -o stat= -p "$1")" =~ ^(Z|$) ]]
}

# Ends a daemon and waits until it writes no more.
stop_daemon() {
  local process
  process=$(cat "$directory/$1.pid" 2>/dev/null) || return 0
  kill "$process" 2>/dev/null || return 0
  if wait_until has_ended "$process"; then return 0; fi
  echo "one_node_slurm.sh: $1, process $process, did not end within 10 s" >&2
}

stop() {
  for daemon in slurmd slurmctld munge; do stop_daemon "$daemon"; done
}

"$command"
