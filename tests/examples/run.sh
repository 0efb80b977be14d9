#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs every example, small: run.sh PROGRAM SOURCE_FOLDER. What cannot run here is skipped, with the reason.
set -euo pipefail
export LAMINA=$1
source=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
small=(--size 48x48 --backend osmesa --truth-rays 0)
holds() { grep -q -- "$2" "$1" || { echo "$1 lacks: $2" >&2; cat "$1" >&2; exit 1; }; }
# A timer may not be certified on a busy machine, which is status 1; a cell that failed is not allowed.
run() {
  local status=0
  "$@" >said 2>&1 || status=$?
  if [ $status -gt 1 ]; then cat said >&2; echo "$*: status $status" >&2; exit 1; fi
}
no_failed_cell() { ! grep -q '"status":"failed"' "$1" || { grep '"status":"failed"' "$1" >&2; exit 1; }; }

echo "== variant"
run "$LAMINA" compare heart --variants-dir "$source/examples/variant" --variant one_tap "${small[@]}" --budget 0.1 --out variant
no_failed_cell variant/record.jsonl
holds variant/record.jsonl '"variant":"one_tap"'

echo "== effect"
run "$LAMINA" compare "$source/examples/effect/wax/candle.toml" --variants-dir "$source/examples/effect" "${small[@]}" --budget 0.1 --out effect
no_failed_cell effect/record.jsonl
holds effect/record.jsonl '"effect":"wax","variant":"no_wrap"'

echo "== gate"
mkdir tree base
cp -r "$source/variants" "$source/shaders" tree
cp -r "$source/variants" "$source/shaders" base
cd tree
"$source/examples/gate/gate.sh" ../base heart "${small[@]}" --backend vulkan --no-time >../said 2>&1 || { cat ../said >&2; exit 1; }
[ -f gate-out/junit.xml ]
sed -i 's/sum = ambient.rgb;/sum = 0.5 * ambient.rgb;/' shaders/common/surface.glsl   # another picture
status=0
"$source/examples/gate/gate.sh" ../base heart "${small[@]}" --backend vulkan --no-time >../said 2>&1 || status=$?
[ $status -eq 1 ] || { cat ../said >&2; echo "the gate lets a changed picture pass: $status" >&2; exit 1; }
cd ..

echo "== ci"
if /usr/bin/python3 -c 'import yaml' 2>/dev/null; then
  for event in push pull_request; do
    for system in github gitlab; do
      python3 "$source/examples/ci/steps.py" $system "$source/examples/ci/$system.yml" $event >steps.sh
      bash -n steps.sh   # try.sh runs them whole, in a clone that it builds
      holds steps.sh "lamina gate heart"
    done
  done
else
  echo "skipped: python3-yaml is not installed"
fi

echo "== cluster"
LAMINA_NO_SLURM=1 run "$source/examples/cluster/thickness.sh" 2 swept "${small[@]}" --variant vertex_normal --view front --fetches none --pictures none
no_failed_cell swept/record.jsonl
[ "$(grep -c '"kind":"cell"' swept/record.jsonl)" -eq 10 ] || { echo "the joined sweep has not 5 points of 2 variants" >&2; exit 1; }

echo "== read_record"
if /usr/bin/python3 -c 'import pandas' 2>/dev/null; then
  /usr/bin/python3 "$source/examples/read_record/read_record.py" effect >table
  holds table no_wrap
  /usr/bin/python3 "$source/examples/read_record/read_record.py" "$source/tests/data/records/compare_0.1.0.jsonl" >table
  holds table vertex_normal
else
  echo "skipped: python3-pandas is not installed"
fi
if command -v Rscript >/dev/null && Rscript -e 'library(jsonlite)' >/dev/null 2>&1; then
  Rscript "$source/examples/read_record/read_record.R" effect >table
  holds table no_wrap
else
  echo "skipped: r-cran-jsonlite is not installed"
fi
