#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# What a sweep adds to what it measures. Takes the program and a scratch folder.
#   1. 33 thicknesses of the heart, 3 variants, 2 backends, errors only, 512x512: the wall time of each backend over the sum of
#      device, read-back and metric time, as the program prints it.
#   2. 10 points against 300: CPU seconds a cell and the most memory, of a scene whose cells are quick.
set -eu
program=$1 folder=$2
rm -rf "$folder/heart"
"$program" sweep heart --set objects.heart.thickness=0:32:1 --size 512x512 --fetches none --pictures none --out "$folder/heart" |
  grep 'times device'

for points in 10 300; do
  rm -rf "$folder/points"
  /usr/bin/time -f '%U %S %M' -o "$folder/time" "$program" sweep open_plane --set "lights.sun.intensity=1:$points:1" --view above \
    --size 128x128 --truth-rays 0 --backend vulkan --fetches none --pictures none --out "$folder/points" >"$folder/said"
  sed -E 's/.*: ([0-9]+) cells of .* in ([0-9.]+) s.*/\1 \2/;t;d' "$folder/said" | while read -r cells seconds; do
    read -r user system kilobytes <"$folder/time"
    awk -v p="$points" -v c="$cells" -v s="$seconds" -v u="$user" -v k="$system" -v m="$kilobytes" 'BEGIN {
      printf "%d points: %.2f ms a cell, %.2f ms of CPU a cell with the start, at most %.1f MiB\n", p, 1000 * s / c, 1000 * (u + k) / c, m / 1024 }'
  done
done
