// SPDX-License-Identifier: Apache-2.0
// The surface point that a fragment shades, and diffuse light on it. World space, linear light.

struct SurfacePoint {
  vec3 position;
  vec3 normal;         // unit, interpolated from the vertices
  mat3 world_from_tangent;  // columns dP/du, dP/dv (v down the image), normal; orthonormal
  vec2 uv;
};

// The frame of an interpolated normal and tangent, made orthonormal again (Gram-Schmidt). A tangent that vanished in interpolation
// leaves some frame rather than NaN.
mat3 tangent_frame(vec3 normal, vec4 tangent) {
  vec3 along = tangent.xyz - normal * dot(normal, tangent.xyz);
  if (dot(along, along) < 1e-12) along = abs(normal.x) < 0.9 ? cross(normal, vec3(1, 0, 0)) : cross(normal, vec3(0, 1, 0));
  along = normalize(along);
  return mat3(along, cross(normal, along) * (tangent.w < 0.0 ? -1.0 : 1.0), normal);
}

// A tangent-space normal from a normal map's texel, n = 2 t - 1; a texel without direction is flat.
vec3 decode_normal(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  float squared = dot(n, n);
  return squared > 1e-6 ? n * inversesqrt(squared) : vec3(0, 0, 1);
}

// Lambert's N.L over all lights, and the ambient irradiance: what an albedo is multiplied by (the BRDF's 1/pi and the light's pi
// cancel, as in the chapter's N.L).
vec3 diffuse_light(vec3 normal, vec3 position) {
  vec3 sum = ambient.rgb;
  for (int i = 0; i < light_count.x; ++i) {
    vec3 to_light = light_position[i].xyz - position * light_position[i].w;
    float squared = max(dot(to_light, to_light), 1e-8);
    float falloff = light_position[i].w > 0.0 ? 1.0 / squared : 1.0;
    sum += light_radiance[i].rgb * (max(dot(normal, to_light), 0.0) * inversesqrt(squared) * falloff);
  }
  return sum;
}
