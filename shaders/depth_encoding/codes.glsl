// SPDX-License-Identifier: Apache-2.0
// Depths as whole numbers in three channels, so that sums of many keep their precision: NVIDIA SDK 9.5, "Fog Polygon Volumes" 3,
// 2004, after James, "Rendering Objects as Thick Volumes", in: ShaderX2, 2003. A channel has `bits` bits of the code; what is
// left of its 8 is room for a sum.
#ifndef DEPTH_ENCODING_CODES_GLSL
#define DEPTH_ENCODING_CODES_GLSL
#include "../common/random.glsl"

// 2^(3 bits), for bits from 1 to 8.
float code_scale(int bits) { return float(1 << (3 * bits)); }

// The whole part of depth * code_scale(bits), for a depth from 0 to 1; 1 and above have the greatest code.
uint code_of(float depth, int bits) {
  float greatest = code_scale(bits) - 1.0;
  return uint(clamp(floor(depth * code_scale(bits)), 0.0, greatest));
}

// High, middle and low channel.
uvec3 split_code(uint code, int bits) {
  uint mask = (1u << bits) - 1u;
  return uvec3(code >> (2 * bits), (code >> bits) & mask, code & mask);
}

// The number that sums of channels stand for.
int joined_code(ivec3 sums, int bits) { return (sums.x << (2 * bits)) + (sums.y << bits) + sums.z; }

// The code of a depth, dithered by one unit at random (0 to 1): the mean over all random numbers is half a unit below the depth,
// whatever the depth, so differences are right in the mean. The fourth channel takes a unit of the middle one away, where the
// low one would fall below 0; the middle one rises, to 2^bits even, where the low one would rise too far.
uvec4 dithered_code(float depth, float random, int bits) {
  uint code = code_of(depth, bits), greatest_low = (1u << bits) - 1u;
  uvec4 channels = uvec4(split_code(code, bits), 0u);
  float part = depth * code_scale(bits) - float(code);
  if (part >= 1.0) return channels;  // the greatest code
  if (random < 0.5 - part) {
    if (channels.z > 0u)
      --channels.z;
    else if (code > 0u)
      channels.z = greatest_low, channels.w = 1u;
  } else if (random < part - 0.5) {
    if (channels.z < greatest_low)
      ++channels.z;
    else
      channels.z = 0u, ++channels.y;
  }
  return channels;
}

// What sums of dithered channels stand for.
int joined_dithered_code(ivec4 sums, int bits) { return joined_code(sums.xyz, bits) - (sums.w << bits); }

#endif
