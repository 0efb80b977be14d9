// SPDX-License-Identifier: Apache-2.0
// The uniform blocks Frame, Object and Pass. Lamina fills uniform blocks by the names of their members, in whatever order and at
// whatever binding a shader declares them; a block that a shader does not use costs nothing. This file declares the members that
// most shaders want. FRAME_MEMBERS, defined before it is included, adds others to Frame:
//
//   mat4 world_from_clip, view_from_world, clip_from_view;
//   vec4 background;                      // rgb, linear
//   ivec4 light_casts[max_lights];        // x = the light's place among those that cast, or -1
//   mat4 casting_clip_from_world[max_lights];  // of the lights that cast, in order: the view that their targets are drawn from
//   mat4 mirror_clip_from_world;          // of an effect with a mirror
//
// The block Effect has the numbers and words that the effect declares, by name: float for a number, int for a word (its place
// among the declared ones). Texture bindings of a variant start at 4.

const int max_lights = 8;

layout(std140, binding = 0) uniform Frame {
  mat4 clip_from_world;
  vec4 eye_world;                    // xyz position; w = time in seconds
  vec4 ambient;                      // rgb irradiance from all around
  vec4 frame_size_px;                // width, height, 1/width, 1/height
  ivec4 light_count;                 // x; y = how many of them cast
  vec4 light_position[max_lights];   // w = 1: a point light's position; w = 0: unit direction towards a directional light
  vec4 light_radiance[max_lights];   // rgb irradiance at normal incidence; a point light's at 1 m; w = the sphere's size: angular
                                     // radius of a directional light in radians, radius of a point light in metres
#ifdef FRAME_MEMBERS
  FRAME_MEMBERS
#endif
};

layout(std140, binding = 1) uniform Object {
  mat4 world_from_object;
  mat4 world_from_object_normal;     // inverse transpose, for normals
#ifdef OBJECT_MEMBERS
  OBJECT_MEMBERS                     // ivec4 object_place: x = the object's place among the scene's, y = how many there are
#endif
};

layout(std140, binding = 2) uniform Pass {
  ivec4 iteration;                   // x = which repetition of the pass this is, from 0; y = how many there are
};
