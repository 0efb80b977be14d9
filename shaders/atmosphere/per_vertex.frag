// SPDX-License-Identifier: Apache-2.0
// What per_vertex.vert computed, interpolated. Alpha tells solid things from the sky.
layout(location = 0) in vec3 in_transmittance;
layout(location = 1) in vec3 in_light;
layout(location = 0) out vec4 out_transmittance;
layout(location = 1) out vec4 out_light;

void main() {
  out_transmittance = vec4(in_transmittance, 1.0);
  out_light = vec4(in_light, 1.0);
}
