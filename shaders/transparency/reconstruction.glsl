// SPDX-License-Identifier: Apache-2.0
// A checkerboard's missing value from its neighbours: the four ends of a cross, and the eight cells a knight's move away, which
// all lie on the other colour. `taken`: 1 for neighbours that are of use, 0 for others; what comes out of it is their sum.

struct CrossValues {
  vec4 value[4];   // above, below, left, right
  float taken[4];
};

float luminance_of(vec4 value) { return dot(value.rgb, vec3(0.2126, 0.7152, 0.0722)) + value.a; }

// The mean of those taken.
vec4 mean_of_four(CrossValues ends, out float taken) {
  vec4 sum = vec4(0.0);
  taken = 0.0;
  for (int i = 0; i < 4; ++i) sum += ends.value[i] * ends.taken[i], taken += ends.taken[i];
  return taken > 0.0 ? sum / taken : vec4(0.0);
}

// The pair, above and below or left and right, whose values differ less; both where they differ alike. Edges along an axis are
// then exact. Where no pair is whole, the mean.
vec4 directed_pairs(CrossValues ends, out float taken) {
  vec4 mean = mean_of_four(ends, taken);
  float across[2], whole[2];
  for (int i = 0; i < 2; ++i) {
    across[i] = abs(luminance_of(ends.value[2 * i]) - luminance_of(ends.value[2 * i + 1]));
    whole[i] = min(ends.taken[2 * i], ends.taken[2 * i + 1]) > 0.5 ? 1.0 : 0.0;
  }
  vec4 vertical = 0.5 * (ends.value[0] + ends.value[1]), horizontal = 0.5 * (ends.value[2] + ends.value[3]);
  if (whole[0] * whole[1] > 0.0) return across[0] < across[1] ? vertical : across[1] < across[0] ? horizontal : mean;
  return whole[0] > 0.0 ? vertical : whole[1] > 0.0 ? horizontal : mean;
}

const float knight_share = 0.03;

// Twelve taps: (1 + 8 a) / 4 of each end and -a of each cell a knight's move away, a = 0.03, where all are taken.
vec4 twelve_taps(CrossValues ends, vec4 knights_sum, bool all_taken, out float taken) {
  vec4 mean = mean_of_four(ends, taken);
  return all_taken ? (1.0 + 8.0 * knight_share) * mean - knight_share * knights_sum : mean;
}
