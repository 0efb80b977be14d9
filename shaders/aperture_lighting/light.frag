// SPDX-License-Identifier: Apache-2.0
// Oat and Sander, "Ambient Aperture Lighting" (in: Oat, "Efficient Shader Tricks That Will Impress Your Friends", GDC 2006, part 2).
// A spherical light is a cap. The area that it shares with the aperture lets its light in, times the cosine at the middle between the
// two. The rest of the aperture is filled by the sky. CAP_INTERSECTION is the function that finds the shared area; with ANTI_APERTURE
// the cap is what is blocked of the hemisphere, with APERTURE_CHOICE there is one of either and a weight between them, with SOFT_APERTURE
// the cap's edge fades. With LENS_COSINE the cosine is that over the shared area instead.
#include "../cap_intersection/cap_intersection.glsl"
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "../common/extra_fetches.glsl"
#include "apertures.glsl"

#ifdef SOFT_APERTURE
layout(constant_id = 0) const float softness = 1.0;  // factor of the edge's width; 0: hard
#endif
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

// Of a light's area the part that an aperture lets in, 0 to 1, and that part's area.
struct Shared {
  float part, area;
};
Shared shared_with(vec4 aperture, LightCap light, float apart, float edge) {
  float area = cap_area(light.radius);
#ifdef SOFT_APERTURE
  // A light's disc of radius r, seen across an edge, fades over the variance r^2 / 4, a ramp of half width s over s^2 / 3: a hard edge
  // fades a disc of radius sqrt(r^2 + 4/3 s^2) as a soft one fades the light.
  float wide = min(sqrt(light.radius * light.radius + 4.0 / 3.0 * edge * edge), 0.5 * pi);
  float part = cap_intersection(aperture.w, wide, apart) / cap_area(wide);
  return Shared(part, part * area);
#else
  float shared_area = cap_intersection(aperture.w, light.radius, apart);
  return Shared(shared_area / area, shared_area);
#endif
}

// What of a light is open where a cap is blocked.
Shared shared_beside(vec4 blocked_cap, vec3 normal, LightCap light) {
  float area = cap_area(light.radius);
  float open = cap_intersection(0.5 * pi, light.radius, angle_between(normal, light.direction));
  float blocked = cap_intersection(blocked_cap.w, light.radius, angle_between(blocked_cap.xyz, light.direction));
  float shared_area = max(open - blocked, 0.0);
  return Shared(shared_area / area, shared_area);
}

// The cosine with which an aperture's light counts. The hemisphere is one too.
float shared_cosine(vec3 normal, vec4 aperture, LightCap light, float apart) {
#ifdef LENS_COSINE
  return lens_cosine(normal, aperture, light, apart);
#else
  return middle_cosine(normal, aperture.xyz, light.direction);
#endif
}

#ifdef ANTI_APERTURE
const int open_apertures = 0;
#elif defined(APERTURE_CHOICE)
const int open_apertures = 1;
#else
const int open_apertures = APERTURES;
#endif

void main() {
  vec3 normal = unit_or(in_normal, vec3(0, 1, 0));
  vec4 apertures[APERTURES];
  read_apertures(in_uv, normal, apertures);
  float edge = 0.0;
#ifdef SOFT_APERTURE
  edge = softness * edge_angle(kept_aperture(0, in_uv));
#endif
#ifdef APERTURE_CHOICE
  float of_blocked = blocked_weight(kept_aperture(1, in_uv));
#else
  const float of_blocked = 1.0;
#endif
  vec3 lit = vec3(0);
  float unfilled = 0.0;
#ifdef ANTI_APERTURE
  unfilled = hemisphere_area - cap_area(apertures[0].w);
#elif defined(APERTURE_CHOICE)
  unfilled = mix(cap_area(apertures[0].w), hemisphere_area - cap_area(apertures[1].w), of_blocked);
#else
  for (int a = 0; a < APERTURES; ++a) unfilled += cap_area(apertures[a].w);
#endif
  for (int i = 0; i < light_count.x; ++i) {
    LightCap light = light_cap(i, in_position);
    for (int a = 0; a < open_apertures; ++a) {
      float apart = angle_between(apertures[a].xyz, light.direction);
      Shared shared_part = shared_with(apertures[a], light, apart, edge);
      float cosine = shared_cosine(normal, apertures[a], light, apart);
#ifdef APERTURE_CHOICE
      cosine *= 1.0 - of_blocked;
      shared_part.area *= 1.0 - of_blocked;
#endif
      lit += light.irradiance * (shared_part.part * cosine);
      unfilled -= shared_part.area;
    }
#if defined(ANTI_APERTURE) || defined(APERTURE_CHOICE)
    Shared beside = shared_beside(apertures[APERTURES - 1], normal, light);
    float above = angle_between(normal, light.direction);
    lit += light.irradiance * (of_blocked * beside.part * shared_cosine(normal, vec4(normal, 0.5 * pi), light, above));
    unfilled -= of_blocked * beside.area;
#endif
  }
  lit += ambient.rgb * (clamp(unfilled, 0.0, hemisphere_area) / hemisphere_area);
  out_color = vec4(texture(albedo, in_uv).rgb * lit, 1.0);
#ifdef LAMINA_EXTRA_FETCHES
  out_color += extra_fetches(albedo);
#endif
}
