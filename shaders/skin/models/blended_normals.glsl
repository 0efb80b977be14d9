// SPDX-License-Identifier: Apache-2.0
// Clement's blended normals: N.L of the vertex normal and of the mapped one, mixed differently for red and for the rest. As
// printed, an intensity of 0 leaves the vertex normal and red has the most bump; the text means the opposite, which is the
// mended form (Penner's is the same).
vec3 blended_cosines(float vertex, float bump, vec2 intensity) {
  float red = mix(bump, vertex, intensity.x), rest = min(red, mix(bump, vertex, intensity.y));
  return clamp(vec3(red, rest, rest), 0.0, 1.0);
}
vec3 blended_normals(SkinPoint point, vec3 to_light, float lit) {
  return point.albedo * lit *
         blended_cosines(dot(point.smooth_normal, to_light), dot(point.normal, to_light), diffusion * vec2(0.6, 0.4));
}
vec3 blended_normals_printed(SkinPoint point, vec3 to_light, float lit) {
  return point.albedo * lit *
         blended_cosines(dot(point.normal, to_light), dot(point.smooth_normal, to_light), diffusion * vec2(0.6, 0.4));
}
