// SPDX-License-Identifier: Apache-2.0
// The geometry buffer of the nearest transparent surface, in the pixels that hold its light: normal, gloss, depth and whose it
// is. The albedo is 1: the material comes later.
#define OBJECT_MEMBERS ivec4 object_place;
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "pattern.glsl"
#include "surface.glsl"

layout(binding = 5) uniform sampler2D depth;  // of what is opaque
layout(location = 0) out vec4 out_normal;     // towards the eye; w: gloss
layout(location = 1) out vec2 out_place;      // x: the object's place, from 1; y: metres of view depth

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (!holds_light(pixel) || gl_FragCoord.z > texelFetch(depth, pixel, 0).r) discard;
  TransparentSurface surface = transparent_surface();
  if (surface.opacity == 0.0) discard;
  out_normal = vec4(surface.normal, gloss);
  out_place = vec2(float(object_place.x + 1), 1.0 / gl_FragCoord.w);
}
