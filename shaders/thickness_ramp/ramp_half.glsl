// SPDX-License-Identifier: Apache-2.0
// A ramp of 256 texels up to x = 8, of half floats.
layout(binding = RAMP_TABLE_HALF_BINDING) uniform sampler2D ramp_table_half;  // linear filter, clamped

float ramp_half(float x) {
  return textureLod(ramp_table_half, vec2((min(x / 8.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5), 0.0).r;
}
