// SPDX-License-Identifier: Apache-2.0
// For fragment shaders that draw a light's maps: which light this is, from the view alone. A parallel view is a directional light.
#define FRAME_MEMBERS mat4 view_from_world; mat4 clip_from_view;
#include "../common/frame.glsl"
#include "light_distance.glsl"

vec4 this_light() {
  if (clip_from_view[3][3] == 0.0) return vec4(eye_world.xyz, 1.0);
  return vec4(normalize(vec3(view_from_world[0].z, view_from_world[1].z, view_from_world[2].z)), 0.0);
}
