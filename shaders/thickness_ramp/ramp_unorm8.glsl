// SPDX-License-Identifier: Apache-2.0
// A ramp of 256 texels up to x = 8, of 8-bit texels: a linear filter may round to 8 bits.
layout(binding = RAMP_TABLE_UNORM8_BINDING) uniform sampler2D ramp_table_unorm8;  // linear filter, clamped

float ramp_unorm8(float x) {
  return textureLod(ramp_table_unorm8, vec2((min(x / 8.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5), 0.0).r;
}
