// SPDX-License-Identifier: Apache-2.0
// Light from 0 to 6 in four bytes: a colour and a factor that all channels share, rounded up so that no channel is above 1.
#ifndef RGBM8_GLSL
#define RGBM8_GLSL

const float rgbm_range = 6.0;

vec4 rgbm_encoded(vec3 light) {
  float largest = clamp(max(max(light.r, light.g), light.b), 1e-6, rgbm_range), m = ceil(largest / rgbm_range * 255.0 - 1e-4) / 255.0;
  return vec4(min(light / (m * rgbm_range), 1.0), m);
}
vec3 rgbm_decoded(vec4 texel) { return texel.rgb * (texel.a * rgbm_range); }
#ifdef RGBM8
vec4 bytes_of(vec4 v) { return floor(clamp(v, 0.0, 1.0) * 255.0 + 0.5) / 255.0; }
float rgbm_linear(float light) { return rgbm_decoded(bytes_of(rgbm_encoded(vec3(light)))).r; }
// The root is stored, which is finer in the dark.
float rgbm_root(float light) {
  float root = sqrt(max(light, 0.0) / rgbm_range) * rgbm_range;
  float kept = rgbm_decoded(bytes_of(rgbm_encoded(vec3(root)))).r / rgbm_range;
  return kept * kept * rgbm_range;
}

// By the function that RGBM8 names.
float rgbm8(float light) { return RGBM8(light); }
#endif
#endif
