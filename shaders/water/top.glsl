// SPDX-License-Identifier: Apache-2.0
// What lies on the surface: the sun's highlight, and foam.

#ifdef SPECULAR
// The sun in the reflected ray, as seen by three lobes of one, two and four widths, each with all of its light. The widths hold the
// sun's own size, and the slopes that the normal does not show (a slope turns the ray by twice as much).
vec3 glitter(vec3 along, float lost) {
  if (!is_sunlit()) return vec3(0.0);
  float off = acos(clamp(dot(along, light_position[0].xyz), -1.0, 1.0)), size = light_radiance[0].w;
  float variance = pow(radians(specular_width), 2.0) + 0.25 * size * size + 4.0 * lost, sum = 0.0;
  for (int lobe = 0; lobe < 3; ++lobe) {
    sum += exp(-0.5 * off * off / variance) / variance;
    variance *= 4.0;
  }
  return specular * light_radiance[0].rgb * (sum / 6.0);  // pi / (2 pi variance), a third each
}
#endif

#ifdef FOAM
layout(binding = 11) uniform sampler2D foam_table;

// By height of crests, by depth under the surface, and by the way to what is behind; the last by the straight way, no longer than
// the refracted one, so that what stands in front leaves no rim.
float foam_cover(vec3 position, Behind straight, float way_m) {
  float crest = foam_height > 0.0 ? smoothstep(foam_height, 2.0 * foam_height, position.y - height) : 0.0;
  float straight_m = min(distance(straight.position, position), way_m), depth = max(position.y - straight.position.y, 0.0);
  float shore = foam_depth > 0.0 ? max(1.0 - smoothstep(0.0, foam_depth, depth), 1.0 - smoothstep(0.0, foam_depth, straight_m)) : 0.0;
  float thick = foam * max(crest, shore);
  float bubbles = texture(foam_table, position.xz / foam_size + vec2(0.02, 0.013) * eye_world.w).r;
  return min(4.0 * thick, 1.0) * smoothstep(-0.15, 0.15, thick - bubbles);
}
vec3 foam_light(vec3 normal, vec3 position) { return 0.85 * diffuse_light(normal, position); }
#endif
