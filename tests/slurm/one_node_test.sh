#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# A sweep by scripts/slurm on a real Slurm of one node, which this starts and stops: the joined record must be that of one run.
# Takes the program. Exit status: 0 well, 1 not, 77 skipped, with the reason.
set -u
program=$1
scripts=$(cd "$(dirname "$0")/../../scripts/slurm" && pwd)
skip() { echo "skipped: $1"; exit 77; }
fail() { echo "failed: $1"; tail -n 5 "$folder"/*.log "$folder"/out/*.log "$folder"/out/shards/*.log 2>/dev/null; exit 1; }

[ "$(id -u)" = 0 ] || skip "Slurm's daemons need root here"
for tool in slurmctld slurmd sbatch munged; do
  command -v $tool >/dev/null || skip "$tool is not installed (Debian: apt-get install slurm-wlm munge)"
done
[ -r /etc/munge/munge.key ] || skip "munge has no key"

folder=$(mktemp -d)
pids=()
stop() {
  for name in slurmd slurmctld; do [ -s "$folder/$name.pid" ] && kill "$(cat "$folder/$name.pid")" 2>/dev/null; done
  [ "${#pids[@]}" -gt 0 ] && kill "${pids[@]}" 2>/dev/null
  sleep 1
  rm -rf "$folder"
}
trap stop EXIT

if ! munge -n >/dev/null 2>&1; then
  install -d -o munge -g munge /run/munge || skip "/run/munge cannot be made"
  setpriv --reuid=munge --regid=munge --init-groups munged --foreground >"$folder/munged.log" 2>&1 &
  pids+=($!)
  for _ in $(seq 20); do munge -n >/dev/null 2>&1 && break; sleep 0.5; done
  munge -n >/dev/null 2>&1 || skip "munged does not start: $(tail -n 1 "$folder/munged.log")"
fi

host=$(hostname -s)
mkdir "$folder/state" "$folder/spool"
export SLURM_CONF=$folder/slurm.conf
cat >"$SLURM_CONF" <<CONF
ClusterName=lamina
SlurmctldHost=$host(127.0.0.1)
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SlurmUser=root
ReturnToService=2
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
SlurmctldPort=16817
SlurmdPort=16818
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
CONF
slurmctld || skip "slurmctld does not start: $(tail -n 1 "$folder/slurmctld.log")"
slurmd || skip "slurmd does not start: $(tail -n 1 "$folder/slurmd.log")"
for _ in $(seq 60); do [ "$(sinfo -h -o %t 2>/dev/null)" = idle ] && break; sleep 0.5; done
[ "$(sinfo -h -o %t 2>/dev/null)" = idle ] || skip "the node does not become idle: $(sinfo -h -o '%t %E')"

sweep=(open_plane --variant linear_cap --set lights.sun.intensity=0:4:1 --size 32x32 --backend vulkan --truth-rays 0 --view above --cache "$folder/cache")
"$program" list --parameters open_plane >/dev/null || fail "the program does not run"
"$program" sweep "${sweep[@]}" --out "$folder/alone" >"$folder/alone.log" 2>&1 || fail "one run alone ends with $?"
merge=$(LAMINA=$program "$scripts/submit" 3 "$folder/out" "${sweep[@]}") || fail "the jobs are not taken"
for _ in $(seq 2400); do [ -z "$(squeue -h -j "$merge" 2>/dev/null)" ] && break; sleep 0.5; done
[ -e "$folder/out/record.jsonl" ] || fail "job $merge left no record"
# All but the run line, which names machines and the command; merging one record alone puts its fields in the same order.
"$program" merge "$folder/alone" --out "$folder/one" >/dev/null || fail "one record alone does not merge"
cmp <(tail -n +2 "$folder/one/record.jsonl") <(tail -n +2 "$folder/out/record.jsonl") || fail "the joined record is another"
echo "passed: $(grep -c '"kind":"cell"' "$folder/out/record.jsonl") cells of 3 array tasks"
