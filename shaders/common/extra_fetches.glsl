// SPDX-License-Identifier: Apache-2.0
// A known amount of extra work, by which `lamina gate --calibrate` makes a pass slower. A fragment shader that can be made slower
// adds extra_fetches() to its output where LAMINA_EXTRA_FETCHES is defined, and has not a line more where it is not.

#ifdef LAMINA_EXTRA_FETCHES
// LAMINA_EXTRA_FETCHES single texels: unfiltered, since one filtered tap can be more than is wanted; in every pixel, since a
// software rasterizer runs both sides of a branch. Returns 0, which no compiler knows.
vec4 extra_fetches(sampler2D source) {
  ivec2 at = ivec2(gl_FragCoord.xy), last = min(textureSize(source, 0) - 1, ivec2(7));  // few, so that they stay in caches
  vec4 sum = vec4(0.0);
  for (int i = 0; i < LAMINA_EXTRA_FETCHES; ++i) sum += texelFetch(source, (at * (2 * i + 1)) & last, 0);
  return sum.x < -1.0 ? sum : vec4(0.0);
}
#endif
