// SPDX-License-Identifier: Apache-2.0
// Green, "Real-Time Approximations to Subsurface Scattering", GPU Gems, 2004, chapter 16: light wrapped by 0.2, and red where
// it ends. The listing's smoothstep with falling edges is undefined in GLSL: 1 - smoothstep is meant.
vec3 red_wrap(SkinPoint point, vec3 to_light, float lit) {
  float wrapped = (dot(point.normal, to_light) + 0.2) / 1.2;
  float edge = smoothstep(0.0, 0.3, wrapped) * (1.0 - smoothstep(0.3, 0.6, wrapped));
  return point.albedo * (lit * (max(wrapped, 0.0) + vec3(0.15, 0.0, 0.0) * edge));
}
