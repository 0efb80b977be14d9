// SPDX-License-Identifier: Apache-2.0
// The inverse transform along columns: a tile of water. sea_shape: height, movement along x, along z, and its change with z (or of that
// along z with x, which is the same). sea_slopes: of height along x and z, of movement along x with x, along z with z.
#include "fft_256.glsl"

layout(binding = 4) uniform sampler2D shape_rows;
layout(binding = 5) uniform sampler2D slope_rows;
layout(binding = 6, rgba32f) uniform writeonly image2D sea_shape;
layout(binding = 7, rgba32f) uniform writeonly image2D sea_slopes;

void main() {
  int column = int(gl_WorkGroupID.y);
  for (uint i = gl_LocalInvocationID.x; i < fft_side; i += 128u) {
    fft_first[i] = texelFetch(shape_rows, ivec2(column, i), 0);
    fft_second[i] = texelFetch(slope_rows, ivec2(column, i), 0);
  }
  fft_256();
  for (uint i = gl_LocalInvocationID.x; i < fft_side; i += 128u) {
    imageStore(sea_shape, ivec2(column, i), fft_first[i]);
    imageStore(sea_slopes, ivec2(column, i), fft_second[i]);
  }
}
