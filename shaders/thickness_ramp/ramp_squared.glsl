// SPDX-License-Identifier: Apache-2.0
// A ramp of 256 half floats up to x = 8, read at the square root, so that it has more texels where it is steep.
layout(binding = RAMP_TABLE_SQUARED_BINDING) uniform sampler2D ramp_table_squared;  // linear filter, clamped

float ramp_squared(float x) {
  return textureLod(ramp_table_squared, vec2((min(sqrt(max(x, 0.0) / 8.0), 1.0) * 255.0 + 0.5) / 256.0, 0.5), 0.0).r;
}
