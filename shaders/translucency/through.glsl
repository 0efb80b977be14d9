// SPDX-License-Identifier: Apache-2.0
// The frame of variants that multiply the surface's colour by one factor a light. A variant defines, before it includes this,
//   vec3 through(int i, Lit lit, vec3 normal, float cosine)
// for light i, both on the side that it shines on and through the object from behind.
void main() {
  vec3 normal = unit_normal();
  vec3 light = ambient.rgb;
  for (int i = 0; i < light_count.x; ++i) {
    Lit lit = light_at(i, in_position);
    light += lit.irradiance * through(i, lit, normal, dot(normal, lit.direction));
  }
  vec3 albedo = texture(translucent_albedo, in_uv).rgb;
  out_color = vec4(diffuse_reflectance(albedo, refraction_index) * light, 1.0);
}
