// SPDX-License-Identifier: Apache-2.0
// For the truth: where in the world each pixel's solid thing is.
layout(location = 0) in vec3 in_position;
layout(location = 0) out vec4 out_point;

void main() { out_point = vec4(in_position, 1.0); }
