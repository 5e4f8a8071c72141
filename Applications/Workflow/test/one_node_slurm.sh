#!/usr/bin/env bash
# A Slurm cluster of one node, this one, for tests: daemons of one's own on the loopback interface, without systemd, cgroups and accounts.
#
#   one_node_slurm.sh start FOLDER    ends when the node is idle; FOLDER/slurm.conf is for the environment variable SLURM_CONF
#   one_node_slurm.sh stop FOLDER
#
# Exit status 77: not possible here; the last line says why. FOLDER's path must be short: it holds a socket.
set -eu
action=$1
mkdir -p "$2"
folder=$(cd "$2" && pwd)

cannot() {
  echo "$1" >&2
  exit 77
}

# Two ports that nothing listens on.
free_ports() {
  python3 -c '
import socket
sockets = [socket.socket() for _ in range(2)]
for s in sockets:
    s.bind(("127.0.0.1", 0))
print(*(s.getsockname()[1] for s in sockets))'
}

# The node has more processors and memory than the machine: what runs is small.
write_configuration() {
  local node ports
  node=$(uname -n | cut -d . -f 1)
  read -r -a ports <<< "$(free_ports)"
  cat > "$folder/slurm.conf" << EOF
ClusterName=test
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=${ports[0]}
SlurmdPort=${ports[1]}
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
SlurmdParameters=config_overrides
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
ReturnToService=2
KillWait=5
NodeName=$node NodeAddr=127.0.0.1 CPUs=8 RealMemory=32000 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
EOF
}

start() {
  local program
  for program in munged slurmctld slurmd sinfo sbatch scontrol scancel python3; do
    command -v $program > /dev/null || cannot "no $program (Debian's munge, slurmctld, slurmd, slurm-client)"
  done
  [ "$(id -u)" -eq 0 ] || cannot "not root, as whom this cluster's daemons run"
  mkdir -p "$folder/state" "$folder/spool"
  mkdir -p -m 700 "$folder/munge"
  head -c 1024 /dev/urandom > "$folder/munge/key"
  chmod 400 "$folder/munge/key"
  # --force: a folder below one that others may write to.
  munged --force --key-file "$folder/munge/key" --socket "$folder/munge/socket" --pid-file "$folder/munge/pid" \
    --log-file "$folder/munge/log" --seed-file "$folder/munge/seed" || cannot "munged does not start"
  write_configuration
  export SLURM_CONF=$folder/slurm.conf
  slurmctld -c || cannot "slurmctld does not start: $(tail -n 1 "$folder/slurmctld.log")"
  slurmd || cannot "slurmd does not start: $(tail -n 1 "$folder/slurmd.log")"
  for _ in $(seq 60); do
    if [ "$(sinfo --noheader --format=%T 2> /dev/null)" = idle ]; then
      return
    fi
    sleep 0.5
  done
  cannot "the node is not idle after 30 s: $(tail -n 1 "$folder/slurmctld.log")"
}

# Ends the process whose number a file has, and waits for its end.
end_process() {
  local id
  [ -f "$1" ] || return 0
  id=$(cat "$1")
  kill "$id" 2> /dev/null || return 0
  for _ in $(seq 100); do
    kill -0 "$id" 2> /dev/null || return 0
    sleep 0.1
  done
  kill -KILL "$id" 2> /dev/null || true
}

stop() {
  if [ -f "$folder/slurm.conf" ]; then
    SLURM_CONF=$folder/slurm.conf timeout 10 scancel --user=root 2> /dev/null || true
  fi
  end_process "$folder/slurmd.pid"
  end_process "$folder/slurmctld.pid"
  end_process "$folder/munge/pid"
}

case $action in
  start) start ;;
  stop) stop ;;
  *) exit 2 ;;
esac
