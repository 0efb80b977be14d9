// SPDX-License-Identifier: Apache-2.0
// Sunlight that is scattered once into a ray: after Nishita, Sirai, Tadamura and Nakamae, "Display of the Earth Taking into
// Account Atmospheric Scattering", SIGGRAPH 1993. Steps grow as the square of their number; within each, air and sunlight are
// those at its middle, and then the integral is exact (Hillaire, "Physically Based and Unified Volumetric Rendering in
// Frostbite", SIGGRAPH 2015 course).
#include "../mean_transmittance/mean_transmittance.glsl"

struct Scattered {
  vec3 transmittance;  // of the whole ray
  vec3 light;          // in the unit of pictures: times pi, as a white surface shows its irradiance
};

vec3 mean_along(vec3 depth) { return vec3(stable_mean(depth.r), stable_mean(depth.g), stable_mean(depth.b)); }

Scattered march(AirRay ray, vec2 span, int steps, vec3 to_sun) {
  float cosine = dot(ray.direction, to_sun);
  vec3 from_molecules = rayleigh_phase(cosine) * rayleigh_scattering();
#ifdef HAZE
  vec3 from_haze = haze_phase(cosine, mie_g) * mie_albedo * mie_extinction();
#endif
  float length = span.y - span.x;
  Scattered all = Scattered(vec3(1.0), vec3(0.0));
  for (int i = 0; i < steps; ++i) {
    // The substitution t = length root^2, whose steps are even: the middle is that of the root.
    float root = (float(i) + 0.5) / float(steps), middle = span.x + length * root * root;
    float size = 2.0 * length * root / float(steps);
    vec3 kinds = densities(altitude_on(ray, middle)), depth = extinction(kinds) * size;
    vec3 scattering = kinds.x * from_molecules;
#ifdef HAZE
    scattering += kinds.y * from_haze;
#endif
    all.light += all.transmittance * scattering * size * mean_along(depth) * sun_transmittance(point_on(ray, middle), to_sun);
    all.transmittance *= exp(-depth);
  }
  all.light *= 3.14159265 * sun_above_air();
  return all;
}
