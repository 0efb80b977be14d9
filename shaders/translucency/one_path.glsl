// SPDX-License-Identifier: Apache-2.0
// Thickness by one sample of the light's depth map: the straight path from where the light enters to the surface, in metres; 0
// outside the map.

// Where the map is read: a texel's width below the surface, so that a texel that just misses the object is not asked.
vec3 inner_place(Lit lit, vec3 normal) { return in_position - normal * texel_width(lit.map, in_position); }

// What a lit surface differs from its own texel by, at most: the texel's width times the slope. A lit side gets 0, not noise.
float lit_bias(Lit lit, float cosine) {
  float slope = sqrt(max(1.0 - cosine * cosine, 0.0)) / max(cosine, 0.1);
  return cosine > 0.0 ? texel_width(lit.map, in_position) * (1.0 + slope) : 0.0;
}

float one_path(int i, Lit lit, vec3 normal, vec2 offset) {
  ivec2 texel = ivec2(floor(map_place(lit.map, inner_place(lit, normal)) + offset));
  if (!in_map(texel)) return 0.0;
  float path = light_distance(light_position[i], in_position) - entry_map(lit.map, texel).w;
  return max(path - lit_bias(lit, dot(normal, lit.direction)), 0.0);
}
