#!/usr/bin/env bash
# Runs the study on this machine with a temporary Slurm (Debian, Ubuntu: apt-get install slurm-wlm).
#   one_machine.sh FOLDER     writes the table, the vases and summary.csv to FOLDER
set -eu
[ $# = 1 ] || { echo "usage: $0 FOLDER" >&2; exit 2; }
for program in slurmctld slurmd sbatch caterpillar; do
  command -v "$program" >/dev/null || { echo "$program was not found on the PATH." >&2; exit 1; }
done
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1/log"
cd "$1"

slurm=$(mktemp -d)
export SLURM_CONF=$slurm/slurm.conf
host=$(hostname -s)
cat >"$SLURM_CONF" <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
# This Slurm is not reachable from outside. A cluster uses munge here.
AuthType=auth/none
CredType=cred/none
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation=$slurm/state
SlurmdSpoolDir=$slurm/spool
SlurmctldPidFile=$slurm/slurmctld.pid
SlurmdPidFile=$slurm/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
MaxArraySize=10001
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$(awk '/MemTotal/ { print int($2 / 1024 * 0.9) }' /proc/meminfo)
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
mkdir "$slurm/state" "$slurm/spool"
slurmctld -D >"$slurm/slurmctld.log" 2>&1 & controller=$!
slurmd -D -N "$host" >"$slurm/slurmd.log" 2>&1 & node=$!
trap 'kill $node $controller 2>/dev/null; wait; rm -rf "$slurm"' EXIT
for _ in $(seq 60); do
  sinfo -h -o %T 2>/dev/null | grep -qx idle && break
  sleep 0.5
done
sinfo -h -o %T 2>/dev/null | grep -qx idle || { echo "Slurm did not start:" >&2; tail -n 5 "$slurm"/*.log >&2; exit 1; }

cp "$here/vase.turtle" .
bash "$here/values.sh" >values.csv
begin=$(date +%s)
sbatch --wait "$here/study.sbatch" || echo "Some tasks failed. See the files in log/." >&2
echo "$(($(date +%s) - begin)) s"
bash "$here/collect.sh" >summary.csv
awk -F, '$7 == "done" || $7 == "skipped" { n++ } END { print n + 0 " of " NR - 1 " vases done" }' summary.csv
