// SPDX-License-Identifier: Apache-2.0
// For the truth: which point of the surface each pixel shows, by where it lies without waves.
layout(location = 0) in vec3 in_position;
layout(location = 1) in vec2 in_ground;
layout(location = 0) out vec4 out_ground;

void main() { out_ground = vec4(in_ground, in_position.y, 1.0); }
