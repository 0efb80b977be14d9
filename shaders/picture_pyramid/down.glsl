// SPDX-License-Identifier: Apache-2.0
// One level of the pyramid from the level above it, `pyramid`, read linearly; and the nearest depth below each texel.
layout(binding = 4) uniform sampler2D pyramid;
layout(binding = 5) uniform sampler2D nearest;
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_nearest;

// The point between the four texels that become this one, and a texel's size.
vec2 texel_size() { return 1.0 / vec2(textureSize(pyramid, 0)); }
vec2 middle() { return 2.0 * gl_FragCoord.xy * texel_size(); }

// Of the four texels and of as many around them as the colours reach.
void keep_nearest(int reach) {
  ivec2 first = 2 * ivec2(gl_FragCoord.xy), last = textureSize(nearest, 0) - 1;
  float least = 1e30;
  for (int y = -reach; y < 2 + reach; ++y)
    for (int x = -reach; x < 2 + reach; ++x)
      least = min(least, texelFetch(nearest, clamp(first + ivec2(x, y), ivec2(0), last), 0).r);
  out_nearest = least;
}
