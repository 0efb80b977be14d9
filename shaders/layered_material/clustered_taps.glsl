// SPDX-License-Identifier: Apache-2.0
// The 13 taps of poisson_disc.glsl in seven clusters of neighbours (Ward's, then k-means): five of two or three, and two lone taps. A cluster lies
// at its middle and reaches 0.31 r around it at most, where the whole disc reaches r.
// Needs poisson_disc.glsl: tap i of disc_taps, and -1 for the centre.

const int clusters = 7, blurred_clusters = 5;
const int cluster_first[8] = int[8](0, 2, 5, 7, 9, 11, 12, 13);
const int cluster_taps[13] = int[13](-1, 8, 0, 10, 11, 2, 3, 5, 7, 6, 9, 1, 4);

vec2 cluster_tap(int i) { return cluster_taps[i] < 0 ? vec2(0.0) : disc_taps[cluster_taps[i]]; }
float cluster_weight(int cluster) { return float(cluster_first[cluster + 1] - cluster_first[cluster]); }
vec2 cluster_middle(int cluster) {
  vec2 sum = vec2(0.0);
  for (int i = cluster_first[cluster]; i < cluster_first[cluster + 1]; ++i) sum += cluster_tap(i);
  return sum / cluster_weight(cluster);
}
