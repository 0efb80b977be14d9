// SPDX-License-Identifier: Apache-2.0
// The smaller cap's area, times the share of it that a table holds (harness/effects/cap_intersection/cap_table.h says what lies
// where) for radii up to pi / 2. Beyond, a cap is replaced by its complement: its shares with another cap and with the rest of
// the sphere add up to all of it.
#include "../common/precise_math.glsl"
#include "cap.glsl"

layout(binding = CAP_TABLE_BINDING) uniform sampler3D cap_table;  // linear filter, clamped

// pi - x, without the rounding of pi.
float supplement(float x) {
  precise float result = (2.0 * half_pi_high - x) + 2.0 * half_pi_low;
  return result;
}

float lut_cap(float r0, float r1, float d) {
  float rest = 0.0, turn = 1.0;
  if (r0 > half_pi_high) {
    rest = cap_area(r1);
    r0 = supplement(r0);
    d = supplement(d);
    turn = -1.0;
  }
  if (r1 > half_pi_high) {
    rest += turn * cap_area(r0);
    r1 = supplement(r1);
    d = supplement(d);
    turn = -turn;
  }
  float smaller = min(r0, r1), larger = max(r0, r1);
  float nodes = float(textureSize(cap_table, 0).x);
  vec3 place = vec3(cap_overlap(r0, r1, d), smaller / larger, larger / half_pi_high);
  float share = textureLod(cap_table, (place * (nodes - 1.0) + 0.5) / nodes, 0.0).r;
  return max(rest + turn * cap_area(smaller) * share, 0.0);
}
