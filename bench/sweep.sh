#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# What a sweep adds to what it measures. Takes the program and a scratch folder.
#   1. 33 thicknesses of the heart, 3 variants, 2 backends, errors only, 512x512: the wall time of each backend over the sum of
#      device, read-back and metric time, as the program prints it.
#   2. Of a scene whose points are quick, what one more point costs after 10 points and after 155, in CPU seconds, and the most
#      memory of 10 and 300 points. Starting costs the same each time and is in no difference; the middle of three runs counts.
set -eu
program=$1 folder=$2
rm -rf "$folder/heart"
"$program" sweep heart --set objects.heart.thickness=0:32:1 --size 512x512 --fetches none --pictures none --out "$folder/heart" |
  grep 'times device'

for run in 1 2 3; do
  for points in 10 155 300; do
    rm -rf "$folder/points"
    LP_NUM_THREADS=0 /usr/bin/time -f "$run $points %U %S %M" -a -o "$folder/times.$$" "$program" sweep open_plane \
      --set "lights.sun.intensity=1:$points:1" --view above --size 128x128 --truth-rays 0 --backend vulkan --fetches none \
      --pictures none --out "$folder/points" >/dev/null
  done
done
awk '{ cpu[$1, $2] = $3 + $4; if ($5 > most[$2]) most[$2] = $5 }
  function middle(from, to,    run, i, other, all) {
    for (run = 1; run <= 3; ++run) all[run] = 1000 * (cpu[run, to] - cpu[run, from]) / (to - from)
    for (run = 1; run <= 3; ++run)
      for (i = 1; i < run; ++i) if (all[run] < all[i]) { other = all[run]; all[run] = all[i]; all[i] = other }
    return all[2]
  }
  END {
    early = middle(10, 155); late = middle(155, 300)
    printf "a point costs %.2f ms of CPU after the 10th, %.2f ms after the 155th: %.3f times as much\n", early, late, late / early
    printf "10 points take at most %.1f MiB, 300 points %.1f MiB\n", most[10] / 1024, most[300] / 1024
  }' "$folder/times.$$"
rm -f "$folder/times.$$"
