// SPDX-License-Identifier: Apache-2.0
// Light of what lies under water: it has come down through the water, and goes up to the surface through it. CAUSTICS: the sun's
// part is gathered by waves.
#include "water_extinction/water_extinction.glsl"
#if defined(CAUSTICS) && defined(CAUSTIC_REACH)
layout(binding = 9) uniform sampler2D caustic_map;

// Of the waves themselves, gathered on one level. Over and under it light is gathered less and more: its contrast is scaled.
float caustic_light(vec3 position, float width_m) {
  vec3 sun = sun_in_water();
  float depth = max(height - position.y, 0.0), texel_m = 2.0 * CAUSTIC_REACH / float(textureSize(caustic_map, 0).x);
  float level = log2(max(width_m / texel_m, 1.0));
  vec2 place = (position.xz + sun.xz / sun.y * depth) / (2.0 * CAUSTIC_REACH) + 0.5;
  vec2 inside = clamp(min(place, 1.0 - place) / 0.05, 0.0, 1.0);
  float light = textureLod(caustic_map, place, level).r;
  return mix(1.0, light, min(caustics, 1.0) * inside.x * inside.y * min(depth / CAUSTIC_DEPTH, 1.0));
}
#elif defined(CAUSTICS)
layout(binding = 9) uniform sampler2D caustic_table;

// 1 in the mean: the lesser of two patterns that drift, found where the refracted sunlight came through the still surface. A
// pattern blurs with what a look sees of the bottom.
float caustic_light(vec3 position, float width_m) {
  vec3 sun = sun_in_water();
  float depth = max(height - position.y, 0.0);
  vec2 entry = (position.xz + sun.xz / sun.y * depth) / caustic_size;
  float time = eye_world.w, level = log2(max(width_m / caustic_size * 256.0, 1.0));
  vec2 one = textureLod(caustic_table, entry + vec2(0.031, 0.017) * time, level).rg,
       other = textureLod(caustic_table, vec2(-entry.y, entry.x) * 0.83 + vec2(-0.023, 0.029) * time, level).rg;
  // Waves have to run some way before they gather light; and the mean of the lesser, which the table knows, is under 1.
  return mix(1.0, min(one.r, other.r) / one.g, min(caustics, 4.0) * smoothstep(0.0, 0.3, depth));
}
#endif

// Light of what is met, before the water takes of it on the way to the eye and from sun and sky: the sun's part, as waves gather it,
// and the rest.
struct MetLight {
  vec3 sun, rest;
};
MetLight met_light(Behind found, vec3 color, float gathered) {
  return MetLight(color * found.sun_share * gathered, color * (1.0 - found.sun_share));
}

float gathered_at(vec3 position, float width_m) {
#ifdef CAUSTICS
  return max(caustic_light(position, width_m), 0.0);
#else
  return 1.0;
#endif
}

// A pattern is blurred by its levels as a box that is wider than their texels by the root of 3.
const float level_width = 0.57735;

#ifdef BLUR_LEVELS
MetLight met_over_pixel(Behind found, vec2 red, vec2 blue, float pixel_m, float level) {
  return met_light(found, colours_below(found.layer, found.place, red, blue, level), gathered_at(found.position, level_width * pixel_m));
}
#else
// Over what a pixel of the frame shows of it. `red`, `blue`: how far from green's place these are seen.
MetLight met_over_pixel(Behind found, vec2 red, vec2 blue, float pixel_m) {
  Looks looks = looks_below(found);
  bool is_mixed = is_mixed_at(found.layer, found.place);
  vec2 place = is_mixed ? texel_middle(found.place) : found.place;
  if (is_mixed) looks = one_look(looks.texel);
  vec3 right_m = dFdx(found.position), down_m = dFdy(found.position);
  bool is_one = !is_seen_on(found);
  // Each look sees a quarter of the pixel, or of its longer side.
  float right_far = length(right_m.xz), down_far = length(down_m.xz), area = abs(right_m.x * down_m.z - right_m.z * down_m.x);
  float width_m = is_one ? pixel_m : max(0.5 * sqrt(area), 0.125 * max(right_far, down_far));
  right_m = is_one ? vec3(0.0) : right_m, down_m = is_one ? vec3(0.0) : down_m;
  vec3 sum = vec3(0.0), sunlit = vec3(0.0);
  float gathered = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec3 color = colours_below(found.layer, place + look_at(looks, i), red, blue, 0.0);
    float here = gathered_at(found.position + looks_at[i].x * right_m + looks_at[i].y * down_m, level_width * width_m);
    sum += 0.25 * color, sunlit += 0.25 * here * color, gathered += 0.25 * here;
  }
  vec3 sharper = vec3(0.0);
  for (int axis = 0; axis < 2; ++axis) {
    vec2 beside = axis == 0 ? vec2(looks.texel.x, 0.0) : vec2(0.0, looks.texel.y);
    sharper += looks.sharpened[axis] * (2.0 * sum - colours_below(found.layer, place - beside, red, blue, 0.0) -
                                        colours_below(found.layer, place + beside, red, blue, 0.0));
  }
  return MetLight(max(sunlit + gathered * sharper, vec3(0.0)) * found.sun_share, max(sum + sharper, vec3(0.0)) * (1.0 - found.sun_share));
}
#endif

// What of it comes up through the surface: it has come down through the water, and goes up through it.
vec3 bottom_light(MetLight met, Behind found, float way_m) {
  float depth = max(height - found.position.y, 0.0);
  vec3 c = extinction(), left;
  for (int i = 0; i < 3; ++i)
    left[i] = met.sun[i] * along_both_ways(c[i], depth, way_m, sun_in_water().y) +
              met.rest[i] * along_both_ways(c[i], depth, way_m, sky_cosine);
  return left;
}
