// SPDX-License-Identifier: Apache-2.0
// Blinn and Phong's light from all lights (Blinn, "Models of Light Reflection for Computer Synthesized Pictures", SIGGRAPH
// 1977). In units where a white diffuse surface that faces a light of irradiance 1 shows 1.

struct Arriving {
  vec3 direction;  // unit, towards the light
  vec3 light;
};

Arriving arriving(int i, vec3 position) {
  vec3 to_light = light_position[i].xyz - position * light_position[i].w;
  float squared = max(dot(to_light, to_light), 1e-8);
  return Arriving(to_light * inversesqrt(squared), light_radiance[i].rgb * (light_position[i].w > 0.0 ? 1.0 / squared : 1.0));
}

vec3 blinn_phong(vec3 position, vec3 normal, vec3 to_eye, vec3 albedo, float power, float strength) {
  vec3 sum = albedo * ambient.rgb;
  for (int i = 0; i < light_count.x; ++i) {
    Arriving from = arriving(i, position);
    float cosine = max(dot(normal, from.direction), 0.0);
    vec3 half_way = normalize(from.direction + to_eye + vec3(0.0, 1e-6, 0.0));
    float highlight = strength * (power + 2.0) * pow(max(dot(normal, half_way), 0.0), power);
    sum += from.light * cosine * (albedo + highlight);
  }
  return sum;
}
