// SPDX-License-Identifier: Apache-2.0
// One sample of stochastic transparency: Enderton, Sintorn, Shirley and Luebke, "Stochastic Transparency", I3D 2010. A fragment
// is there with the probability of its opacity; the depth test leaves the nearest that is. Samples are averaged.
#define OBJECT_MEMBERS ivec4 object_place;
#include "../common/frame.glsl"
#include "../common/random.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "surface.glsl"

layout(binding = 5) uniform sampler2D depth;          // of what is opaque
layout(binding = 6) uniform sampler2D samples_before;
layout(location = 0) out vec4 out_samples;  // premultiplied: the share of samples that met a surface

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (gl_FragCoord.z > texelFetch(depth, pixel, 0).r) discard;
  vec4 layer = shaded_surface();
  // Other numbers for each sample, object and side, and for parts of an object of which one lies a twelfth behind another.
  uint part = uint(object_place.x) * 2u + (gl_FrontFacing ? 1u : 0u);
  uint slice = uint(max(512.0 - log2(gl_FragCoord.w) * 8.0, 0.0));
  float random = random_of(uvec3(pixel, uint(iteration.x) + 64u * part + (slice << 20u)));
  if (random >= layer.a) discard;
  out_samples = texelFetch(samples_before, pixel, 0) + vec4(layer.rgb, 1.0) / float(iteration.y);
}
