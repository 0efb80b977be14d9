#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The distance between a material's layers, swept in shards: thickness.sh SHARDS OUT [OPTIONS...], of the heart or of SCENE. On a Slurm cluster each shard is a task of an array, and a
# job after them joins what they leave (scripts/slurm/submit). Where there is no Slurm the shards run here, one after another. OUT is on a
# disk that all nodes see. A shard that was stopped goes on where it was when it runs again.
set -eu
shards=$1 out=$2
shift 2
lamina=${LAMINA:-lamina}
sweep=("${SCENE:-heart}" --set 'objects.*.thickness=0:32:8' "$@")
if command -v sbatch >/dev/null && [ "${LAMINA_NO_SLURM:-}" = "" ]; then
  LAMINA=$(command -v "$lamina") exec "$(dirname "$0")/../../scripts/slurm/submit" "$shards" "$out" "${sweep[@]}"
fi
parts=()
for ((k = 1; k <= shards; ++k)); do
  "$lamina" sweep "${sweep[@]}" --shard "$k/$shards" --out "$out/shards/shard-$k"
  parts+=("$out/shards/shard-$k")
done
"$lamina" merge "${parts[@]}" --out "$out"
