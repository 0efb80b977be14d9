// SPDX-License-Identifier: Apache-2.0
// Moves the points of a flat mesh by the waves. The fragment stage gets both where a point is and where it lies without waves.
#include "effect.glsl"
#include "waves.glsl"

layout(location = 0) in vec3 position;
layout(location = 0) out vec3 out_position;  // world
layout(location = 1) out vec2 out_ground;    // x and z without waves
layout(location = 2) out vec3 out_normal;    // of the shape that the mesh has

void main() {
  vec3 still = (world_from_object * vec4(position, 1.0)).xyz;
  still.xz += grid_moved();
  float lost = 0.0;
  WavePoint point = wave_point(still.xz, grid_width(still.xz), lost);
  out_ground = still.xz;
  out_position = still + point.offset;
  out_normal = exact_normal(point);
  gl_Position = clip_from_world * vec4(out_position, 1.0);
}
