// SPDX-License-Identifier: Apache-2.0
// Twelve taps around a texel, spread over the profile's red by equal shares and the golden angle; each weighs, in each channel,
// what the profile has there. The narrowest Gaussian's light stays where it is.
#include "profile_numbers.glsl"

layout(binding = 4) uniform sampler2D light;
layout(binding = 5) uniform sampler2D stretch;
layout(location = 0) out vec4 out_light;

// All Gaussians but the narrowest, mm^-2 but for a factor that drops out.
vec3 rest_of_profile(float squared) {
  vec3 sum = vec3(0.0);
  for (int i = 1; i < 6; ++i) sum += profile_weight(i) * exp(-0.5 * squared / profile_variance(i)) / profile_variance(i);
  return sum;
}

void main() {
  vec2 size = vec2(textureSize(light, 0)), at = gl_FragCoord.xy / size;
  vec2 uv_a_mm = 1.0 / (max(texelFetch(stretch, ivec2(gl_FragCoord.xy), 0).xy, vec2(1e-4)) * size);
  vec3 middle = texture(light, at).rgb, sum = vec3(0.0), weights = vec3(0.0);
  float spread = 2.0 * sigma_4;  // Cauchy-like radii: closer in the middle, and a few far out
  for (int i = 0; i < 12; ++i) {
    float share = (float(i) + 0.5) / 12.0, angle = 2.39996323 * float(i);
    float squared = spread * spread * share * share / (1.0 - 0.92 * share);
    // The area that a tap stands for is the slope of its squared radius.
    float area = spread * spread * (2.0 * share - 0.92 * share * share) / ((1.0 - 0.92 * share) * (1.0 - 0.92 * share));
    vec3 weight = rest_of_profile(squared) * area;
    sum += weight * (texture(light, at + sqrt(squared) * vec2(cos(angle), sin(angle)) * uv_a_mm).rgb - middle);
    weights += weight;
  }
  out_light = vec4(middle + (1.0 - profile_weight(0)) * sum / max(weights, 1e-6), 1.0);
}
