// SPDX-License-Identifier: Apache-2.0
// L = L0 F_ex + L_in of what was interpolated between vertices: of solid things where there are any, else of the sky's grid.
#include "common/frame.glsl"
layout(binding = 4) uniform sampler2D frame;
layout(binding = 5) uniform sampler2D transmittance;
layout(binding = 6) uniform sampler2D light;
layout(binding = 7) uniform sampler2D sky_transmittance;
layout(binding = 8) uniform sampler2D sky_light;
layout(location = 0) out vec4 out_color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 behind = texelFetch(frame, pixel, 0), air = texelFetch(light, pixel, 0);
  vec3 passed = texelFetch(transmittance, pixel, 0).rgb;
  if (air.a == 0.0) {
    vec2 place = (gl_FragCoord.xy * frame_size_px.zw * float(GRID_SIDE - 1) + 0.5) / float(GRID_SIDE);
    air = texture(sky_light, place);
    passed = texture(sky_transmittance, place).rgb;
  }
  out_color = vec4(behind.rgb * passed + air.rgb, behind.a);
}
