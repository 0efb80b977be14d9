// SPDX-License-Identifier: Apache-2.0
// Sunlight that air scatters once into a ray, offline in double precision: the truth of the effect `atmosphere`.
//
//   L = integral over the ray of T(eye, x) T(x, sun) [rayleigh(x) p_R + albedo mie(x) p_M] dx
//
// after Nishita, Sirai, Tadamura and Nakamae, "Display of the Earth Taking into Account Atmospheric Scattering", SIGGRAPH 1993,
// section 3, with the phase function of Henyey and Greenstein, "Diffuse Radiation in the Galaxy", 1941, for haze.
#pragma once

#include "harness/effects/atmosphere/air.h"

namespace lamina {

struct Scattered {
  glm::dvec3 transmittance{1};  // of the whole ray
  glm::dvec3 radiance{0};       // of the air, for an irradiance of 1 above the air on a plane that faces the sun
};

// Along the ray up to the planet, the top of the air, or `end_m` metres where that is nearer; the planet stops a ray only where
// `planet_stops` says so. Within 1e-4 of the integral, relative (above 1e-9), with the sun from the zenith to 8 degrees below
// the horizon.
Scattered single_scattering(const Air& air, const AirRay& ray, double end_m, bool planet_stops, glm::dvec3 to_sun);

}  // namespace lamina
