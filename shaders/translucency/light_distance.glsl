// SPDX-License-Identifier: Apache-2.0
// How far light has come at a point, in metres: along its direction for a directional light (from the plane through the origin),
// from its position for a point light. Linear, and 32-bit: neither a perspective depth nor a 16-bit one.
#ifndef LIGHT_DISTANCE_GLSL
#define LIGHT_DISTANCE_GLSL
float light_distance(vec4 light, vec3 position) {
  return light.w > 0.0 ? length(position - light.xyz) : -dot(position, light.xyz);
}
#endif
