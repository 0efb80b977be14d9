// SPDX-License-Identifier: Apache-2.0
// Runs FUNCTION_CALL, a call of a family's function with x[0] to x[FUNCTION_INPUTS - 1], over a list of points. A family's
// compute shader includes its functions and then this file. For timing the function is called many times. Each input depends
// formally on the result before, without changing by it, so that a compiler cannot leave out a call.
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Points { float points[]; };  // FUNCTION_INPUTS each
layout(std430, binding = 1) writeonly buffer Values { float values[]; };
layout(std140, binding = 2) uniform Work { ivec4 work; };  // points, calls for each

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= work.x) return;
  float x[FUNCTION_INPUTS];
  for (int k = 0; k < FUNCTION_INPUTS; ++k) x[k] = points[FUNCTION_INPUTS * i + k];
  float first = x[0], value = 0.0;
  for (int call = 0; call < work.y; ++call) {
    x[0] = first + value * 1e-30;
    value = FUNCTION_CALL;
  }
  values[i] = value;
}
