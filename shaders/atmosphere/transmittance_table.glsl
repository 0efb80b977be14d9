// SPDX-License-Identifier: Apache-2.0
// The share of sunlight that reaches a point, from a table over altitude and the sun's height: Bruneton and Neyret, "Precomputed
// Atmospheric Scattering", EGSR 2008, in the later parametrization of Bruneton's published implementation (2017): across, the
// distance to the top of the air between the least and the greatest there; down, the distance to the horizon over its greatest.
// Texel centres are nodes, those of the edges at both ends of the range.

// Distance from sea level along the tangent to the top of the air, squared.
float greatest_excess() { return top * (2.0 * planet_radius + top); }

#ifdef TRANSMITTANCE_TABLE_BINDING
layout(binding = TRANSMITTANCE_TABLE_BINDING) uniform sampler2D transmittance_table;

vec3 sun_transmittance(vec3 point, vec3 to_sun) {
  AirRay ray = air_ray(point, to_sun);
  if (meets_planet(ray)) return vec3(0.0);
  float horizon = sqrt(min(ray.excess, greatest_excess())), furthest = sqrt(greatest_excess());
  float least = top - altitude_on(ray, 0.0), distance = span_in_air(ray, 1e30).y;
  vec2 place = vec2((distance - least) / (horizon + furthest - least), horizon / furthest);
  vec2 size = vec2(textureSize(transmittance_table, 0));
  return texture(transmittance_table, (clamp(place, 0.0, 1.0) * (size - 1.0) + 0.5) / size).rgb;
}
#endif
