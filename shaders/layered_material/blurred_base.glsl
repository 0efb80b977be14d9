// SPDX-License-Identifier: Apache-2.0
// The inner layer's disc from maps that were blurred once (blurred_base.frag): the 13 taps at four radii, mixed by the ray's length, and
// beyond the last one widened by the mip level whose variance is what is lacking. The 13 taps make displaced copies rather than a
// blur, so that two radii must lie close for their mixture to look like what lies between.
// Needs footprints.glsl.

const vec4 blurred_at = vec4(BLURRED_AT);  // radii of the maps, in thicknesses; the first is 1
layout(binding = 8) uniform sampler2D base_0;
layout(binding = 9) uniform sampler2D base_1;
layout(binding = 10) uniform sampler2D base_2;
layout(binding = 11) uniform sampler2D base_3;

// stretch: the ray's length between the layers over their distance, 1 to 32. radius: the thickness in texture coordinates.
vec4 blurred_base(vec2 center, vec2 radius, float stretch, Footprint footprint) {
  vec3 along = clamp((vec3(stretch) - blurred_at.xyz) / (blurred_at.yzw - blurred_at.xyz), 0.0, 1.0);
  float beyond = max(stretch - blurred_at.w, 0.0);
  vec2 lacking = sqrt(beyond * (stretch + blurred_at.w)) * radius;  // squares of radii add as variances do
  vec4 base = mix(fetch_of(base_0, center, footprint), fetch_of(base_1, center, footprint), along.x);
  base = mix(base, fetch_of(base_2, center, footprint), along.y);
  vec2 last = center + vec2(0.0281, -0.0966) * beyond * radius;
  return mix(base, fetch_of(base_3, last, widened(base_3, lacking, 1.128, footprint)), along.z);
}
