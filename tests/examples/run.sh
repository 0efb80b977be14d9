#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs every example, small: run.sh PROGRAM SOURCE_FOLDER. What cannot run here is skipped, with the reason.
set -euo pipefail
export LAMINA=$1
source=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
small=(--size 48x48 --backend vulkan --truth-rays 0)
errors=(--view front --fetches all --pictures none)   # a sweep of one point: no timer is certified, which takes the longest
square=$source/tests/data/scenes/square.toml
holds() { grep -q -- "$2" "$1" || { echo "$1 lacks: $2" >&2; cat "$1" >&2; exit 1; }; }
run() { "$@" >said 2>&1 || { echo "$*: status $?" >&2; cat said >&2; exit 1; }; }
no_failed_cell() { ! grep -q '"status":"failed"' "$1" || { grep '"status":"failed"' "$1" >&2; exit 1; }; }

echo "== variant"
run "$LAMINA" sweep "$square" --set objects.square.thickness=0.4 --variants-dir "$source/examples/variant" --variant one_tap "${small[@]}" "${errors[@]}" --out variant
no_failed_cell variant/record.jsonl
holds variant/record.jsonl '"variant":"one_tap"'

echo "== effect and gate"
for tree in tree base; do   # of this effect and the plain surface alone, which leaves less to compile
  mkdir -p $tree/variants
  cp -r "$source/shaders" $tree
  cp -r "$source/variants/surface" "$source/variants/layered_material" "$source/variants/aperture_lighting" "$source/examples/effect/wax" $tree/variants
done
cp "$square" "$source/tests/data/scenes/square.gltf" .
sed -i '/^\[objects/,$d' square.toml
printf '[objects.square.wax]\nalbedo = [0.9, 0.75, 0.5]\n' >>square.toml
cd tree
"$source/examples/gate/gate.sh" ../base ../square.toml "${small[@]}" --no-time >../said 2>&1 || { cat ../said >&2; exit 1; }
[ -f gate-out/junit.xml ]
sed -i 's/sum = ambient.rgb;/sum = 0.5 * ambient.rgb;/' variants/wax/wax.frag   # another picture
status=0
"$source/examples/gate/gate.sh" ../base ../square.toml "${small[@]}" --no-time >../said 2>&1 || status=$?
[ $status -eq 1 ] || { cat ../said >&2; echo "the gate lets a changed picture pass: $status" >&2; exit 1; }
cd ..
holds tree/gate-out/record.jsonl '"effect":"wax","variant":"no_wrap"'
run "$LAMINA" plan "$source/examples/effect/wax/scenes/candle.toml" --variants-dir "$source/examples/effect"
holds said "wax: called for"

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
LAMINA_NO_SLURM=1 SCENE=$square run "$source/examples/cluster/thickness.sh" 2 swept "${small[@]}" --variant vertex_normal --view front --fetches none --pictures none
no_failed_cell swept/record.jsonl
[ "$(grep -c '"kind":"cell"' swept/record.jsonl)" -eq 10 ] || { echo "the joined sweep has not 5 points of 2 variants" >&2; exit 1; }

echo "== read_record"
if /usr/bin/python3 -c 'import pandas' 2>/dev/null; then
  /usr/bin/python3 "$source/examples/read_record/read_record.py" variant >table
  holds table one_tap
  /usr/bin/python3 "$source/examples/read_record/read_record.py" "$source/tests/data/records/compare_0.1.0.jsonl" >table
  holds table vertex_normal
else
  echo "skipped: python3-pandas is not installed"
fi
if command -v Rscript >/dev/null && Rscript -e 'library(jsonlite)' >/dev/null 2>&1; then
  Rscript "$source/examples/read_record/read_record.R" variant >table
  holds table one_tap
else
  echo "skipped: r-cran-jsonlite is not installed"
fi
