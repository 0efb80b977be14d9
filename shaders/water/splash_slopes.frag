// SPDX-License-Identifier: Apache-2.0
// Slopes of the waves that objects throw back, along x and z, by differences; none in objects.
#include "../common/frame.glsl"
layout(std140, binding = 3) uniform Effect { float splash_size; };
layout(binding = 4) uniform sampler2D splash_waves;
layout(binding = 5) uniform sampler2D splash_solid;
layout(location = 0) out vec4 out_slopes;

float height_at(ivec2 at) { return texelFetch(splash_waves, clamp(at, ivec2(0), textureSize(splash_waves, 0) - 1), 0).r; }

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float solid = texelFetch(splash_solid, at, 0).r, twice_m = 2.0 * splash_size / float(textureSize(splash_waves, 0).x);
  vec2 slopes = vec2(height_at(at + ivec2(1, 0)) - height_at(at - ivec2(1, 0)),
                     height_at(at + ivec2(0, 1)) - height_at(at - ivec2(0, 1))) / twice_m;
  out_slopes = vec4(solid > 0.5 ? vec2(0.0) : slopes, 0.0, 1.0);
}
