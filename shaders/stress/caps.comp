// SPDX-License-Identifier: Apache-2.0
// CAP_INTERSECTION, a function of shaders/cap_intersection, over a list of inputs. For timing it is called again and again, each
// time with an input that the last result has touched without changing it, so that no call can be left out.
#include "../cap_intersection/cap_intersection.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Inputs { vec4 inputs[]; };  // r0, r1, d
layout(std430, binding = 1) writeonly buffer Areas { float areas[]; };
layout(std140, binding = 2) uniform Work { ivec4 work; };  // inputs, calls for each

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= work.x) return;
  vec3 cap = inputs[i].xyz;
  float area = 0.0;
  for (int call = 0; call < work.y; ++call) area = cap_intersection(cap.x + area * 1e-30, cap.y, cap.z);
  areas[i] = area;
}
