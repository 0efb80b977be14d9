// SPDX-License-Identifier: Apache-2.0
// The uniform blocks that Lamina fills, by block name. A shader includes this file and takes what it needs; a block that it does
// not use costs nothing. Host side: harness/graph/uniforms.h; a test holds the two together by reflection.
// Texture bindings of a variant start at 4.

const int max_lights = 8;

layout(std140, binding = 0) uniform Frame {
  mat4 clip_from_world;
  vec4 eye_world;                    // xyz position; w = time in seconds
  vec4 ambient;                      // rgb irradiance from all around
  vec4 frame_size_px;                // width, height, 1/width, 1/height
  ivec4 light_count;                 // x
  vec4 light_position[max_lights];   // w = 1: a point light's position; w = 0: unit direction towards a directional light
  vec4 light_radiance[max_lights];   // rgb irradiance at normal incidence; a point light's at 1 m; w = the sphere's size: angular
                                     // radius of a directional light in radians, radius of a point light in metres
};

layout(std140, binding = 1) uniform Object {
  mat4 world_from_object;
  mat4 world_from_object_normal;     // inverse transpose, for normals
  vec4 layer;                        // x = thickness in texels of inner_albedo's base level; y = scattering scale
};

layout(std140, binding = 2) uniform Pass {
  ivec4 iteration;                   // x = which repetition of the pass this is, from 0; y = how many there are
};
