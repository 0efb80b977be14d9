// SPDX-License-Identifier: Apache-2.0
// Light of what lies under water: it has come down through the water, and goes up to the surface through it. CAUSTICS: the sun's
// part is gathered by waves.
#if defined(CAUSTICS) && defined(CAUSTIC_REACH)
layout(binding = 9) uniform sampler2D caustic_map;

// Of the waves themselves, gathered on one level. Over and under it light is gathered less and more: its contrast is scaled.
float caustic_light(vec3 position, float pixel_m) {
  vec3 sun = sun_in_water();
  float depth = max(height - position.y, 0.0), texel_m = 2.0 * CAUSTIC_REACH / float(textureSize(caustic_map, 0).x);
  float level = log2(max(pixel_m / texel_m, 1.0));
  vec2 place = (position.xz + sun.xz / sun.y * depth) / (2.0 * CAUSTIC_REACH) + 0.5;
  vec2 inside = clamp(min(place, 1.0 - place) / 0.05, 0.0, 1.0);
  float light = textureLod(caustic_map, place, level).r;
  return mix(1.0, light, min(caustics, 1.0) * inside.x * inside.y * min(depth / CAUSTIC_DEPTH, 1.0));
}
#elif defined(CAUSTICS)
layout(binding = 9) uniform sampler2D caustic_table;

// 1 in the mean: the lesser of two patterns that drift, found where the refracted sunlight came through the still surface. A
// pattern blurs with the size of a pixel on the bottom.
float caustic_light(vec3 position, float pixel_m) {
  vec3 sun = sun_in_water();
  float depth = max(height - position.y, 0.0);
  vec2 entry = (position.xz + sun.xz / sun.y * depth) / caustic_size;
  float time = eye_world.w, level = log2(max(pixel_m / caustic_size * 256.0, 1.0));
  float pattern = min(textureLod(caustic_table, entry + vec2(0.031, 0.017) * time, level).r,
                      textureLod(caustic_table, vec2(-entry.y, entry.x) * 0.83 + vec2(-0.023, 0.029) * time, level).r);
  // Waves have to run some way before they gather light; and the mean of the lesser is under 1.
  return mix(1.0, pattern * CAUSTIC_SCALE, min(caustics, 4.0) * smoothstep(0.0, 0.3, depth));
}
#endif

vec3 bottom_light(vec3 color, Behind found, float way_m, float pixel_m) {
  float depth = max(height - found.position.y, 0.0);
  vec3 sun_share = found.sun_share;
  vec3 c = extinction();
#ifdef CAUSTICS
  float gathered = max(caustic_light(found.position, pixel_m), 0.0);
#else
  const float gathered = 1.0;
#endif
  vec3 sun = sun_share * gathered * exp(-c * (depth / sun_in_water().y)), rest = (1.0 - sun_share) * exp(-c * (depth / sky_cosine));
  return color * (sun + rest) * exp(-c * way_m);
}
