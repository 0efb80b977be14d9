// SPDX-License-Identifier: Apache-2.0
// Single scattering along the eye's refracted ray, in exponential steps, lit through the light's depth map: Green, "Real-Time
// Animated Translucency", GDC 2004, and "Real-Time Approximations to Subsurface Scattering", GPU Gems, 2004, chapter 16; after
// Hery. The map holds one entry a texel, so a hole counts as filled. Light scattered more often is diffusion through a slab.
#include "medium.glsl"
#include "light_maps.glsl"
LIGHT_MAPS(leaving, 16)  // x = how far the light has come where it leaves, 0 where nothing is

layout(constant_id = 0) const int steps = 8;
layout(constant_id = 1) const int samples = 4;
layout(constant_id = 2) const float sample_radius = 1.5;  // texels
const float inset = 0.01;  // texels below the surface, where the map is read
const int chord_halvings = 14;
const float rounded = 1e-6;  // of places: what single precision leaves of a difference of two that are equal

// The light's path to a point as if the surface were flat where it enters: the straight path s, and what refraction makes of
// it (Jensen and others 2001): longer or shorter, and more or less of it on the same area.
struct Entry {
  float path;   // m
  float share;  // of the irradiance at normal incidence
};

// How much farther the light comes on the line through a point than at a texel's middle, on the plane through what is drawn there.
// Without it lit slopes would get paths of up to a texel at random, and samples beside them paths of their slope.
float slope_in_texel(Lit lit, vec3 position, vec2 from_middle, vec3 entry_normal, float cosine) {
  mat4 m = casting_clip_from_world[lit.map];
  vec3 right = normalize(vec3(m[0].x, m[1].x, m[2].x)), down = normalize(vec3(m[0].y, m[1].y, m[2].y));
  return dot(entry_normal, right * from_middle.x + down * from_middle.y) / max(cosine, 0.1) * texel_width(lit.map, position);
}

// `run` metres along the eye's ray in the object, which starts at the surface. The map is read just below the surface, so that a texel
// that just misses the object is not asked.
Entry entry_at(Lit lit, vec4 light, vec3 along, float run, vec2 offset, vec3 normal) {
  float width = texel_width(lit.map, in_position);
  vec3 position = in_position + along * run;
  ivec2 texel = ivec2(floor(map_place(lit.map, position - normal * (inset * width)) + offset));
  vec4 entry = in_map(texel) ? entry_map(lit.map, texel) : vec4(0.0, 0.0, 0.0, 1e30);
  bool covered = entry.w < 1e29 && dot(entry.xyz, entry.xyz) > 0.0;
  float cosine = max(dot(covered ? entry.xyz : normal, lit.direction), 0.0);
  if (cosine <= 0.0) return Entry(0.0, 0.0);
  float spread = cosine / max(refracted_cosine(cosine, refraction_index), min_cosine);
  float straight = 0.0;
  if (covered) {
    // In a dense medium a run is shorter than the last digit of a place: then the plane says how the path grows along the ray.
    bool is_short = run < width;
    vec3 from = is_short ? in_position : position;
    float come = light_distance(light, from);
    straight = come - entry.w - slope_in_texel(lit, from, map_place(lit.map, from) - vec2(texel) - 0.5, entry.xyz, cosine);
    if (is_short) {
      if (abs(straight) * max(cosine, 0.1) < rounded * (abs(come) + width * float(entry_side()))) straight = 0.0;
      straight -= run * dot(entry.xyz, along) / max(cosine, 0.1);
    }
  }
  return Entry(max(straight, 0.0) * spread, (1.0 - fresnel(cosine, refraction_index)) * spread);
}

bool is_inside(int light_index, int map, vec3 position) {
  ivec2 texel = ivec2(floor(map_place(map, position)));
  if (!in_map(texel)) return false;
  float come = light_distance(light_position[light_index], position);
  return come >= entry_map(map, texel).w && come <= leaving_map(map, texel).x;
}

// How far the eye's ray runs inside, up to `most`: where the map says that it leaves, for an object without holes.
float chord(int light_index, int map, vec3 from, vec3 along, float most) {
  if (most < texel_width(map, from)) return most;  // which the map does not resolve
  if (is_inside(light_index, map, from + along * most)) return most;
  float inside = 0.0, outside = most;
  for (int i = 0; i < chord_halvings; ++i) {
    float middle = 0.5 * (inside + outside);
    if (is_inside(light_index, map, from + along * middle)) inside = middle;
    else outside = middle;
  }
  return 0.5 * (inside + outside);
}

void main() {
  vec3 normal = unit_normal(), sigma = extinction(), albedo = texture(translucent_albedo, in_uv).rgb;
  vec3 to_eye = normalize(eye_world.xyz - in_position);
  float eye_cosine = max(dot(normal, to_eye), min_cosine);
  vec3 along = refract(-to_eye, normal, 1.0 / refraction_index);
  float seen = (1.0 - fresnel(eye_cosine, refraction_index)) / (refraction_index * refraction_index);
  vec3 reflectance = diffuse_reflectance(albedo, refraction_index);
  vec3 multiple = multiple_scattering * max(reflectance - single_reflectance(albedo, refraction_index), 0.0);
  vec3 color = reflectance * ambient.rgb;
  for (int i = 0; i < light_count.x; ++i) {
    Lit lit = light_at(i, in_position);
    float cosine = dot(normal, lit.direction);
    if (lit.map < 0) {
      color += reflectance * lit.irradiance * max(cosine, 0.0);
      continue;
    }
    vec3 inner = in_position - normal * (inset * texel_width(lit.map, in_position));
    vec3 most = 8.0 / max(sigma, 1e-9);
    float run = chord(i, lit.map, inner, along, max(most.r, max(most.g, most.b)));
    vec3 once = vec3(0.0), slab = vec3(0.0);
    for (int channel = 0; channel < 3; ++channel) {
      float covered = 1.0 - exp(-sigma[channel] * run), sum = 0.0;
      for (int step = 0; step < steps; ++step) {
        float u = (float(step) + 0.5) / float(steps) * covered;
        float depth = -log(1.0 - u) / max(sigma[channel], 1e-9);
        for (int sample_index = 0; sample_index < samples; ++sample_index) {
          vec2 offset = sample_radius * disc_place(sample_index, samples);
          Entry entry = entry_at(lit, light_position[i], along, depth, offset, normal);
          sum += entry.share * exp(-sigma[channel] * entry.path);
        }
      }
      once[channel] = covered * sum / float(steps * samples);
    }
    for (int sample_index = 0; sample_index < samples; ++sample_index) {
      Entry entry = entry_at(lit, light_position[i], along, 0.0, sample_radius * disc_place(sample_index, samples), normal);
      slab += slab_transmittance(sigma * entry.path, reflectance) / float(samples);
    }
    // A Lambert albedo is pi times a radiance, and isotropic scattering has the density 1 / 4 pi.
    color += lit.irradiance * (0.25 * seen * albedo * once + multiple * slab * both_sides(cosine));
  }
  out_color = vec4(color, 1.0);
}
