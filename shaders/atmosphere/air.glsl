// SPDX-License-Identifier: Apache-2.0
// The air of a round planet: where a ray is in it, and what it scatters and absorbs there. Metres; colours are wavelengths.
// The planet's frame is the world's with y from sea level; its centre is at (0, -planet_radius, 0). Squares of distances from
// the centre lose all digits of altitude in binary32, so only their excess over planet_radius^2 is computed: q.q + 2 R q.y.
// Points below sea level count as at sea level.
//
// Three numbers for kinds of air: molecules, haze, ozone.

layout(std140, binding = 3) uniform Effect {
  float density, top, planet_radius, sea_level;
  float rayleigh_red, rayleigh_green, rayleigh_blue, rayleigh_height;
  float mie_amount, mie_red, mie_green, mie_blue, mie_albedo, mie_height, mie_g;
  float ozone_amount, ozone_red, ozone_green, ozone_blue, ozone_height, ozone_half_width;
  float sun_red, sun_green, sun_blue;
};

struct AirRay {
  vec3 origin, direction;  // planet's frame; unit
  float half_linear;       // of the excess along the ray: excess + t (2 half_linear + t)
  float excess;            // at the origin
};

AirRay air_ray(vec3 origin, vec3 direction) {
  return AirRay(origin, direction, dot(origin, direction) + planet_radius * direction.y,
                max(dot(origin, origin) + 2.0 * planet_radius * origin.y, 0.0));
}

vec3 point_on(AirRay ray, float t) { return ray.origin + t * ray.direction; }

float altitude_on(AirRay ray, float t) {
  float excess = max(ray.excess + t * (2.0 * ray.half_linear + t), 0.0);
  return excess / (sqrt(planet_radius * planet_radius + excess) + planet_radius);
}

bool meets_planet(AirRay ray) { return ray.half_linear < 0.0 && ray.half_linear * ray.half_linear >= ray.excess; }

// Where it does.
float planet_distance(AirRay ray) {
  return ray.excess / (sqrt(ray.half_linear * ray.half_linear - ray.excess) - ray.half_linear);
}

// From x to y metres along the ray there is air; 0 and 0 where there is none.
vec2 span_in_air(AirRay ray, float end) {
  float b = ray.half_linear, c = ray.excess - top * (2.0 * planet_radius + top), discriminant = b * b - c;
  if (discriminant < 0.0) return vec2(0.0);
  float root = sqrt(discriminant), near = b > 0.0 ? -b - root : c / (root - b), far = b > 0.0 ? -c / (b + root) : root - b;
  vec2 span = vec2(max(near, 0.0), min(far, end));
  return span.y > span.x ? span : vec2(0.0);
}

// Relative: 1 at sea level, or where ozone is densest.
vec3 densities(float altitude) {
  vec3 relative = vec3(exp(-altitude / rayleigh_height), 0.0, 0.0);
#ifdef HAZE
  relative.y = exp(-altitude / mie_height);
#endif
#ifdef OZONE
  relative.z = max(0.0, 1.0 - abs(altitude - ozone_height) / ozone_half_width);
#endif
  return relative;
}

vec3 rayleigh_scattering() { return density * vec3(rayleigh_red, rayleigh_green, rayleigh_blue); }
vec3 mie_extinction() { return density * mie_amount * vec3(mie_red, mie_green, mie_blue); }
vec3 sun_above_air() { return vec3(sun_red, sun_green, sun_blue); }

// 1/m of densities, or an optical depth of their integral.
vec3 extinction(vec3 kinds) {
  vec3 sum = kinds.x * rayleigh_scattering();
#ifdef HAZE
  sum += kinds.y * mie_extinction();
#endif
#ifdef OZONE
  sum += kinds.z * density * ozone_amount * vec3(ozone_red, ozone_green, ozone_blue);
#endif
  return sum;
}

// Unit, towards the first directional light; 0 where there is none, and then nothing is scattered.
vec3 direction_to_sun() {
  for (int i = 0; i < light_count.x; ++i)
    if (light_position[i].w == 0.0) return light_position[i].xyz;
  return vec3(0.0);
}
