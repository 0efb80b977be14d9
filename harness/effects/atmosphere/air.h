// SPDX-License-Identifier: Apache-2.0
// The air of a round planet, offline in double precision: how much of each kind of it a ray passes, and which share of the
// light it lets through. Metres; colours are the three wavelengths of red, green and blue.
//
// Kinds of air, in this order wherever three numbers stand for them: molecules (Rayleigh; density exp(-h / height)), haze (Mie;
// the same with a height of its own), and ozone (a tent: 1 at its height, 0 at half a width above and below). Densities are
// relative: 1 at sea level, or at the top of the tent.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace lamina {

struct EffectValues;

struct Air {
  double planet_radius_m = 6360e3, top_m = 100e3;     // top: altitude above which there is none
  glm::dvec3 rayleigh{5.802e-6, 13.558e-6, 33.1e-6};  // scattering at sea level, 1/m; nothing is absorbed
  double rayleigh_height_m = 8000;
  glm::dvec3 mie{4.44e-6};  // extinction at sea level, 1/m
  double mie_albedo = 0.9;  // the share of it that is scattered
  double mie_height_m = 1200;
  double mie_g = 0.8;                             // mean cosine of the angle by which haze scatters
  glm::dvec3 ozone{0.65e-6, 1.881e-6, 0.085e-6};  // absorption, 1/m
  double ozone_height_m = 25e3, ozone_half_width_m = 15e3;
};

// From the scene's numbers for the effect; all that variants/atmosphere/effect.toml declares must be there.
Air air_of(const EffectValues& values);

// A ray in the planet's frame: y up, the origin at sea level. Points below sea level count as at sea level.
struct AirRay {
  glm::dvec3 origin, direction;  // unit
};

double altitude_m(const Air& air, glm::dvec3 point);
glm::dvec3 densities(const Air& air, double altitude_m);

// From where to where along the ray there is air. The ray ends at the planet, or at `end_m`.
struct Span {
  double from_m = 0, to_m = 0;
};
Span span_in_air(const Air& air, const AirRay& ray, double end_m);
bool meets_planet(const Air& air, const AirRay& ray);

// Where along the ray its altitude passes a level at which densities bend or have fallen by a few times, and where it is
// nearest to the planet: between two of them, densities are smooth. Sorted, from span.from_m to span.to_m.
std::vector<double> smooth_pieces(const Air& air, const AirRay& ray, Span span, std::vector<double> also = {});

// The integral of the densities, in metres, from one distance to another between which they are smooth.
glm::dvec3 column_between(const Air& air, const AirRay& ray, double from_m, double to_m);
// The same over a whole span.
glm::dvec3 column(const Air& air, const AirRay& ray, Span span);

// exp(-optical depth) by wavelength.
glm::dvec3 transmittance(const Air& air, glm::dvec3 column);
// Of sunlight from above the air: 0 where the planet is in the way.
glm::dvec3 sun_transmittance(const Air& air, glm::dvec3 point, glm::dvec3 to_sun);

}  // namespace lamina
