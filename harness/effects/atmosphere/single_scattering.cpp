// SPDX-License-Identifier: Apache-2.0
// Gauss-Legendre quadrature, piece by piece: pieces end where densities bend and at the edge of the planet's shadow, so each
// integrand is smooth.
#include "harness/effects/atmosphere/single_scattering.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

namespace lamina {
namespace {

using std::numbers::pi;

// Where the ray crosses the cylinders behind the planet in which sunlight has come nearer to it than some altitudes:
// |x|^2 - (x . sun)^2 = (R + altitude)^2, x from the centre. At altitude 0 the shadow begins; the others part it from full
// light.
std::vector<double> shadow_edges(const Air& air, const AirRay& ray, glm::dvec3 to_sun) {
  const glm::dvec3 o = ray.origin, d = ray.direction, s = to_sun;
  const double radius = air.planet_radius_m, along = glm::dot(o, s) + radius * s.y, turn = glm::dot(d, s);
  const double a = 1 - turn * turn, b = glm::dot(o, d) + radius * d.y - along * turn;
  std::vector<double> edges;
  for (const double heights : {0.0, 0.1, 0.3, 0.6, 1.0, 1.5, 2.2, 3.2, 5.0}) {
    const double altitude = heights * air.rayleigh_height_m;
    const double c = glm::dot(o, o) + 2 * radius * o.y - along * along - altitude * (2 * radius + altitude);
    const double discriminant = b * b - a * c;
    if (!(a > 0) || !(discriminant >= 0)) continue;
    for (const double side : {-1, 1}) {
      const double t = (-b + side * std::sqrt(discriminant)) / a;
      if (along + t * turn < 0) edges.push_back(t);
    }
  }
  return edges;
}

// Each piece in equal parts, so that none takes more than a few times its light from a ray.
std::vector<double> parted(const Air& air, const AirRay& ray, const std::vector<double>& pieces) {
  std::vector<double> parts = {pieces.front()};
  for (size_t i = 1; i < pieces.size(); ++i) {
    const glm::dvec3 passes = transmittance(air, column_between(air, ray, pieces[i - 1], pieces[i]));
    const double depth = -std::log(std::max(std::min({passes.r, passes.g, passes.b}), 1e-300));
    const int count = 1 + static_cast<int>(depth / 1.5);
    for (int k = 1; k <= count; ++k) parts.push_back(pieces[i - 1] + (pieces[i] - pieces[i - 1]) * k / count);
  }
  return parts;
}

double rayleigh(double cosine) { return 3 / (16 * pi) * (1 + cosine * cosine); }

double henyey_greenstein(double g, double cosine) {
  // 1 + g^2 - 2 g cosine, by the angle's distance from the peak, ahead or behind.
  const double base = (1 - std::abs(g)) * (1 - std::abs(g)) + 2 * std::abs(g) * (1 - (g < 0 ? -cosine : cosine));
  return (1 - g) * (1 + g) / (4 * pi * base * std::sqrt(base));
}

}  // namespace

Scattered single_scattering(const Air& air, const AirRay& ray, double end_m, bool planet_stops, glm::dvec3 to_sun) {
  double end = end_m;
  if (planet_stops && meets_planet(air, ray)) {
    const double b = glm::dot(ray.origin, ray.direction) + air.planet_radius_m * ray.direction.y;
    const double c = std::max(glm::dot(ray.origin, ray.origin) + 2 * air.planet_radius_m * ray.origin.y, 0.0);
    end = std::min(end, c / (std::sqrt(b * b - c) - b));
  }
  const Span span = span_in_air(air, ray, end);
  const double cosine = glm::dot(ray.direction, to_sun);
  const glm::dvec3 from_molecules = rayleigh(cosine) * air.rayleigh;
  const glm::dvec3 from_haze = henyey_greenstein(air.mie_g, cosine) * air.mie_albedo * air.mie;
  using Rule = boost::math::quadrature::gauss<double, 6>;
  const std::vector<double> pieces = parted(air, ray, smooth_pieces(air, ray, span, shadow_edges(air, ray, to_sun)));
  Scattered all;
  glm::dvec3 passed(0);  // the column up to the piece
  for (size_t i = 1; i < pieces.size(); ++i) {
    const double from = pieces[i - 1], middle = (from + pieces[i]) / 2, half = (pieces[i] - from) / 2;
    for (size_t k = 0; k < Rule::weights().size(); ++k)
      for (const double side : {-1, 1}) {
        const double t = middle + side * half * Rule::abscissa()[k];
        const glm::dvec3 point = ray.origin + t * ray.direction, density = densities(air, altitude_m(air, point));
        const glm::dvec3 seen = transmittance(air, passed + column_between(air, ray, from, t));
        all.radiance += half * Rule::weights()[k] * seen * sun_transmittance(air, point, to_sun) *
                        (density.x * from_molecules + density.y * from_haze);
      }
    passed += column_between(air, ray, from, pieces[i]);
  }
  all.transmittance = transmittance(air, passed);
  return all;
}

}  // namespace lamina
