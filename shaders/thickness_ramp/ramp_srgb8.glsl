// SPDX-License-Identifier: Apache-2.0
// A ramp of 256 texels up to x = 8, of sRGB texels, as painted ramps come: 8 bits, but finer where it is dark.
layout(binding = RAMP_TABLE_SRGB8_BINDING) uniform sampler2D ramp_table_srgb8;  // linear filter, clamped

float ramp_srgb8(float x) {
  return textureLod(ramp_table_srgb8, vec2((min(x / 8.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5), 0.0).r;
}
