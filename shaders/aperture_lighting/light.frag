// SPDX-License-Identifier: Apache-2.0
// Oat and Sander, "Ambient Aperture Lighting" (in: Oat, "Efficient Shader Tricks That Will Impress Your Friends", GDC 2006, part 2).
// A spherical light is a cap. The area that it shares with the aperture lets its light in, times the cosine at the middle between the
// two. The rest of the aperture is filled by the sky. CAP_INTERSECTION is the function that finds the shared area; with ANTI_APERTURE
// the cap is what is blocked of the hemisphere. With LENS_COSINE the cosine is that over the shared area instead.
#include "../cap_intersection/cap_intersection.glsl"
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "../common/extra_fetches.glsl"
#include "apertures.glsl"

layout(binding = 4) uniform sampler2D albedo;
layout(location = 0) out vec4 out_color;

// A point light is a cap of this angular radius in radians: 20 seconds of arc.
const float least_radius = 1e-4;
const float hemisphere_area = 2.0 * pi;

struct LightCap {
  vec3 direction;  // unit, towards its centre
  float radius;    // angular
  vec3 irradiance; // at normal incidence, all of it seen
};

LightCap light_cap(int i, vec3 position) {
  LightCap cap;
  vec3 to_light = light_position[i].xyz - position * light_position[i].w;
  float distance = max(length(to_light), 1e-4), size = light_radiance[i].w;
  cap.direction = to_light / distance;
  bool is_point = light_position[i].w > 0.0;
  // A sphere's outline is a circle of the angular radius arc sine of radius / distance; from inside it is all around.
  float radius = is_point ? asin(min(size / distance, 1.0)) : size;
  cap.radius = clamp(radius, least_radius, 0.5 * pi);
  cap.irradiance = light_radiance[i].rgb * (is_point ? 1.0 / (distance * distance) : 1.0);
  return cap;
}

// The angle between unit vectors, in [0, pi]; small angles stay accurate, which an arc cosine would lose.
float angle_between(vec3 a, vec3 b) { return atan(length(cross(a, b)), dot(a, b)); }

// Lambert's cosine at the middle of two directions; where they are opposite there is none.
float middle_cosine(vec3 normal, vec3 a, vec3 b) { return max(dot(normal, unit_or(a + b, vec3(0))), 0.0); }

// The cosine integrated over what two caps share, over its area, and over that integral's share of a whole light's, which gives its
// irradiance at normal incidence. Both caps hold the smaller one's share of the line through their
// centres from max(-r, d - R) to r, r and R their radii, d apart: its middle lies r (1 - overlap) from the smaller one's centre. Over a
// whole cap above the horizon the cosine's mean is that at its centre times (1 + cos r) / 2: a smaller light's own factor cancels.
float lens_cosine(vec3 normal, vec4 aperture, LightCap light, float apart) {
  bool light_is_smaller = light.radius <= aperture.w;
  float r = max(min(light.radius, aperture.w), least_radius);
  vec3 from = light_is_smaller ? light.direction : aperture.xyz, to = light_is_smaller ? aperture.xyz : light.direction;
  float cosine = dot(from, to), shift = r * (1.0 - cap_overlap(light.radius, max(aperture.w, least_radius), apart));
  vec3 across = to - from * cosine;
  vec3 middle = from + across * (shift * inversesqrt(max(dot(across, across), 1e-12)));
  float whole = light_is_smaller ? 1.0 : (1.0 + cos(r)) / (1.0 + cos(light.radius));
  return max(dot(normal, middle), 0.0) * inversesqrt(dot(middle, middle)) * whole;
}

void main() {
  vec3 normal = unit_or(in_normal, vec3(0, 1, 0));
  vec4 apertures[APERTURES];
  read_apertures(in_uv, normal, apertures);
  vec3 lit = vec3(0);
  float unfilled;
#ifdef ANTI_APERTURE
  unfilled = hemisphere_area - cap_area(apertures[0].w);
#else
  unfilled = 0.0;
  for (int a = 0; a < APERTURES; ++a) unfilled += cap_area(apertures[a].w);
#endif
  for (int i = 0; i < light_count.x; ++i) {
    LightCap light = light_cap(i, in_position);
    float area = cap_area(light.radius);
#ifdef ANTI_APERTURE
    float open = cap_intersection(0.5 * pi, light.radius, angle_between(normal, light.direction));
    float blocked = cap_intersection(apertures[0].w, light.radius, angle_between(apertures[0].xyz, light.direction));
    float shared_area = max(open - blocked, 0.0);
    lit += light.irradiance * (shared_area / area * middle_cosine(normal, normal, light.direction));
    unfilled -= shared_area;
#else
    for (int a = 0; a < APERTURES; ++a) {
      float apart = angle_between(apertures[a].xyz, light.direction);
      float shared_area = cap_intersection(apertures[a].w, light.radius, apart);
#ifdef LENS_COSINE
      float cosine = lens_cosine(normal, apertures[a], light, apart);
#else
      float cosine = middle_cosine(normal, apertures[a].xyz, light.direction);
#endif
      lit += light.irradiance * (shared_area / area * cosine);
      unfilled -= shared_area;
    }
#endif
  }
  lit += ambient.rgb * (clamp(unfilled, 0.0, hemisphere_area) / hemisphere_area);
  out_color = vec4(texture(albedo, in_uv).rgb * lit, 1.0);
#ifdef LAMINA_EXTRA_FETCHES
  out_color += extra_fetches(albedo);
#endif
}
