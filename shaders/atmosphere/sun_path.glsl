// SPDX-License-Identifier: Apache-2.0
// The share of sunlight that reaches a point through the air, by Gauss's rule of eight points over the square root of the
// distance: air is densest at the near end. Abscissae and weights: Abramowitz and Stegun, "Handbook of Mathematical Functions",
// 1964, table 25.4.

const float gauss_points[4] = float[](0.183434642495650, 0.525532409916329, 0.796666477413627, 0.960289856497536);
const float gauss_weights[4] = float[](0.362683783378362, 0.313706645877887, 0.222381034453374, 0.101228536290376);

// Of ozone, whose tent Gauss's rule over the whole path does not see well: two points between each two of the spheres where the
// tent begins, is highest and ends.
float ozone_between(AirRay ray, float begin, float end) {
  float size = end - begin, middle = 0.5 * (begin + end), offset = 0.288675135 * size;
  return size > 0.0 ? 0.5 * size * (densities(altitude_on(ray, middle - offset)).z + densities(altitude_on(ray, middle + offset)).z) : 0.0;
}

float ozone_column(AirRay ray) {
  float column = 0.0, nearest = -ray.half_linear;
  vec3 altitudes = ozone_height + ozone_half_width * vec3(-1.0, 0.0, 1.0);
  vec3 away = sqrt(max(nearest * nearest - ray.excess + altitudes * (2.0 * planet_radius + altitudes), 0.0));
  column += ozone_between(ray, max(nearest + away.x, 0.0), max(nearest + away.y, 0.0));
  column += ozone_between(ray, max(nearest + away.y, 0.0), max(nearest + away.z, 0.0));
  if (nearest > 0.0) {  // the path dips first
    column += ozone_between(ray, max(nearest - away.z, 0.0), max(nearest - away.y, 0.0));
    column += ozone_between(ray, max(nearest - away.y, 0.0), max(nearest - away.x, 0.0));
  }
  return column;
}

// Along a ray that the planet does not stop.
vec3 transmittance_of_path(AirRay ray) {
  vec2 span = span_in_air(ray, 1e30);
  float length = span.y - span.x;
  vec3 column = vec3(0.0);
  for (int i = 0; i < 8; ++i) {
    float root = 0.5 + 0.5 * (i < 4 ? -gauss_points[i] : gauss_points[i - 4]);
    // dt = 2 root d(root), and the rule's interval is 2 long.
    column.xy += gauss_weights[i & 3] * root * densities(altitude_on(ray, span.x + length * root * root)).xy;
  }
  column *= length;
#ifdef OZONE
  column.z = ozone_column(ray);
#endif
  return exp(-extinction(column));
}

vec3 sun_transmittance(vec3 point, vec3 to_sun) {
  AirRay ray = air_ray(point, to_sun);
  return meets_planet(ray) ? vec3(0.0) : transmittance_of_path(ray);
}
