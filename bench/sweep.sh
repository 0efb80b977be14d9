#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# What a sweep adds to what it measures. Takes the program and a scratch folder.
#   1. 33 thicknesses of the heart, 3 variants, 2 backends, errors only, 512x512: the wall time of each backend over the sum of
#      device, read-back and metric time, as the program prints it.
#   2. For a scene whose points are quick: the CPU time of one more point after 10 points and after 155, and the maximum memory of
#      10 and 300 points. Start-up costs the same each time and cancels in a difference. The median of three runs counts.
set -eu
program=$1 folder=$2
rm -rf "$folder/heart"
"$program" sweep heart --set objects.heart.thickness=0:32:1 --size 512x512 --fetches none --pictures none --out "$folder/heart" |
  grep 'times device'

times=$folder/times
rm -f "$times"
for run in 1 2 3; do
  for points in 10 155 300; do
    rm -rf "$folder/points"
    LP_NUM_THREADS=0 /usr/bin/time -f "$points %U %S %M" -a -o "$times" "$program" sweep open_plane \
      --set "lights.sun.intensity=1:$points:1" --view above --size 128x128 --truth-rays 0 --backend vulkan --fetches none \
      --pictures none --out "$folder/points" >/dev/null
  done
done
# Milliseconds of CPU for a point between two lengths of sweep, of which the shorter was run first; the middle of the runs.
a_point() {
  awk -v from="$1" -v to="$2" '$1 == from { before = $2 + $3 } $1 == to { print 1000 * ($2 + $3 - before) / (to - from) }' \
    "$times" | sort -g | sed -n 2p
}
most_mib() { awk -v points="$1" '$1 == points && $4 > most { most = $4 } END { printf "%.1f", most / 1024 }' "$times"; }
awk -v early="$(a_point 10 155)" -v late="$(a_point 155 300)" 'BEGIN {
  printf "a point costs %.2f ms of CPU after the 10th, %.2f ms after the 155th: %.3f times as much\n", early, late, late / early }'
echo "10 points take at most $(most_mib 10) MiB, 300 points $(most_mib 300) MiB"
