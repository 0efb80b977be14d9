// SPDX-License-Identifier: Apache-2.0
// Screen-space diffusion reads light around a pixel from the light buffer. Offsets are in millimetres on the surface: they
// shrink with distance, and where the surface is slanted, by derivatives of its depth. Taps that show no skin, or skin at
// another depth, do not count.
#include "../common/random.glsl"

layout(binding = 9) uniform sampler2D light_buffer;  // rgb times alpha; alpha 1 on skin
layout(binding = 12) uniform sampler2D depth_buffer;  // metres

struct ScreenPlace {
  vec2 pixel;         // of the middle
  float depth_m;
  vec2 pixels_a_mm;   // along x and y
};

ScreenPlace screen_place() {
  float depth_m = 1.0 / gl_FragCoord.w, scale = abs(clip_from_view[1][1]) * frame_size_px.y / (2000.0 * depth_m);
  // Derivatives jump at silhouettes, where a quad holds other surfaces: no more than a slant of 76 degrees.
  vec2 slant = min(abs(1000.0 * vec2(dFdx(depth_m), dFdy(depth_m))) * scale, vec2(4.0));
  return ScreenPlace(gl_FragCoord.xy, depth_m, scale * inversesqrt(1.0 + slant * slant));
}

// Light at an offset, times 1 where it counts, and that 1 in alpha.
vec4 light_tap(ScreenPlace place, vec2 off_mm, float level) {
  vec2 at = (place.pixel + off_mm * place.pixels_a_mm) * frame_size_px.zw;
  float apart_mm = 1000.0 * abs(textureLod(depth_buffer, at, 0.0).r - place.depth_m), beside_mm = length(off_mm);
  float near = apart_mm < 1.0 + 4.0 * beside_mm && at == clamp(at, vec2(0.0), vec2(1.0)) ? 1.0 : 0.0;
  return textureLod(light_buffer, at, level) * near;
}
