// SPDX-License-Identifier: Apache-2.0
// GLSL's refract() of a ray in a plane. Beyond the critical angle it is the zero vector.
float builtin_refraction(float c, float n) {
  vec3 along = vec3(sqrt(max(1.0 - c * c, 0.0)), -c, 0.0);
  return -refract(along, vec3(0.0, 1.0, 0.0), 1.0 / n).y;
}
