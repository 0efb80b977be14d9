// SPDX-License-Identifier: Apache-2.0
// One term of the thickness, for additive blending: of a box or an ellipsoid the whole length along the ray, in closed form, at its
// back faces alone; of any other hull one signed depth a face, as signed_sum.frag has it.
#include "hull.glsl"

layout(std430, binding = 5) readonly buffer HullShape {
  vec4 low;   // bounds in object space
  vec4 high;  // w = 0 any mesh, 1 a box, 2 an ellipsoid
};
layout(binding = 4) uniform sampler2D view_depth;  // of the nearest solid
layout(location = 1) in vec3 in_position;
layout(location = 2) flat in vec3 in_eye;
layout(location = 0) out float out_term;

// Where the ray enters and leaves, as multiples of the way from the eye to this face; x > y where it misses. The hull is the
// cube or sphere of half axes 1 around the origin.
vec2 crossed_box(vec3 eye, vec3 along) {
  vec3 a = (-1.0 - eye) / along, b = (1.0 - eye) / along;
  vec3 first = min(a, b), last = max(a, b);
  return vec2(max(max(first.x, first.y), first.z), min(min(last.x, last.y), last.z));
}
vec2 crossed_sphere(vec3 eye, vec3 along) {
  float squared = dot(along, along), closest = -dot(eye, along) / squared;
  vec3 beside = eye + closest * along;  // keeps its digits where the eye is far
  float inside = 1.0 - dot(beside, beside);
  float half_way = sqrt(max(inside, 0.0) / squared);
  return vec2(closest - half_way, closest + half_way);
}

void main() {
  float solid = texelFetch(view_depth, ivec2(gl_FragCoord.xy), 0).r;
  if (high.w == 0.0) {
    float depth = share * min(in_view_depth, solid);
    out_term = adds() ? depth : -depth;
    return;
  }
  if (gl_FrontFacing) discard;
  vec3 middle = 0.5 * (low.xyz + high.xyz), half_axes = 0.5 * (high.xyz - low.xyz);
  vec3 eye = (in_eye - middle) / half_axes, along = (in_position - in_eye) / half_axes;
  vec2 crossed = max(high.w == 1.0 ? crossed_box(eye, along) : crossed_sphere(eye, along), 0.0);
  // View depth grows evenly along the ray.
  vec2 depth = min(crossed * in_view_depth, vec2(solid));
  float length_in_depth = share * max(depth.y - depth.x, 0.0);
  out_term = volume == 1 ? -length_in_depth : length_in_depth;
}
