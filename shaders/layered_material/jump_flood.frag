// SPDX-License-Identifier: Apache-2.0
// One step of jump flooding: every texel learns of a nearer chart texel from its eight neighbours at the step's distance, which
// halves from half the texture to 1. Source: Rong and Tan, "Jump Flooding in GPU with Applications to Voronoi Diagram and Distance
// Transform", I3D 2006, section 3. Texel centres in pixels; negative where no seed is known. The texture repeats, as its readers do.
#include "../common/frame.glsl"

layout(binding = 4) uniform sampler2D seeds_before;
layout(location = 0) out vec4 out_seed;

void main() {
  ivec2 size = textureSize(seeds_before, 0);
  int jump = 1 << (iteration.y - 1 - iteration.x);
  vec2 nearest = vec2(-1.0);
  float nearest_squared = 1e30;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      ivec2 there = (ivec2(gl_FragCoord.xy) + ivec2(x, y) * jump + size) % size;
      vec2 seed = texelFetch(seeds_before, there, 0).xy;
      vec2 apart = abs(seed - gl_FragCoord.xy);
      apart = min(apart, vec2(size) - apart);
      float squared = dot(apart, apart);
      if (seed.x >= 0.0 && squared < nearest_squared) {
        nearest = seed;
        nearest_squared = squared;
      }
    }
  out_seed = vec4(nearest, 0.0, 0.0);
}
