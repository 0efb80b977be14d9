// SPDX-License-Identifier: Apache-2.0
// The water's mesh where its sunlight lands on a level CAUSTIC_DEPTH under the still surface: each point follows the sun's ray that it
// refracts. Drawn on the level as seen along the sunlight that a still surface refracts, around the scene's middle: 2 CAUSTIC_REACH wide.
#include "effect.glsl"
#include "waves.glsl"

layout(location = 0) in vec3 position;
layout(location = 0) out vec2 out_ground;  // where the light came in
layout(location = 1) out vec2 out_lands;   // less the way of a still surface's light
layout(location = 2) out float out_passes; // of the light, over what a still surface lets through

void main() {
  vec2 still = (world_from_object * vec4(position, 1.0)).xz + grid_moved();
  float lost = 0.0;
  WavePoint point = wave_point(still, grid_width(still), lost);
  vec3 normal = exact_normal(point), to_sun = light_position[0].w == 0.0 ? light_position[0].xyz : vec3(0, 1, 0);
  vec3 into = refract(-to_sun, normal, 1.0 / refraction_index), level = refract(-to_sun, vec3(0, 1, 0), 1.0 / refraction_index);
  // Light that comes in aside of the still surface's place runs on to the level from the height where it came in.
  vec2 entry = still + point.offset.xz;
  vec2 lands = entry + into.xz / max(-into.y, 0.2) * (CAUSTIC_DEPTH + point.offset.y) - level.xz / max(-level.y, 0.2) * CAUSTIC_DEPTH;
  // Of sunlight that passes a level, each piece of the surface catches what its shadow on it catches.
  vec2 shadow = entry + to_sun.xz / max(to_sun.y, 0.05) * -point.offset.y;
  out_ground = shadow, out_lands = lands;
  out_passes = dot(normal, to_sun) > 0.0 ? 1.0 : 0.0;
  gl_Position = vec4(lands / CAUSTIC_REACH, 0.5, 1.0);
}
