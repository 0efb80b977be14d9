// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/atmosphere/air.h"

#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "harness/scene/effect_values.h"

namespace lamina {
namespace {

// |c + origin + t direction|^2 - R^2, with the planet's centre at -R y; the large squares never appear.
struct Squares {
  double half_linear, constant;
  Squares(const Air& air, const AirRay& ray)
      : half_linear(glm::dot(ray.origin, ray.direction) + air.planet_radius_m * ray.direction.y),
        constant(std::max(glm::dot(ray.origin, ray.origin) + 2 * air.planet_radius_m * ray.origin.y, 0.0)) {}
  double at(double t) const { return constant + t * (2 * half_linear + t); }
};

// Distances at which the ray crosses the sphere of this altitude; none or two, the lesser first.
std::vector<double> crossings(const Air& air, const Squares& ray, double altitude) {
  const double c = ray.constant - altitude * (2 * air.planet_radius_m + altitude), b = ray.half_linear;
  const double discriminant = b * b - c;
  if (!(discriminant >= 0)) return {};
  const double root = std::sqrt(discriminant);
  if (b > 0) return {-b - root, -c / (b + root)};
  return root - b > 0 ? std::vector{c / (root - b), root - b} : std::vector{0.0, 0.0};
}

double altitude_from_squares(const Air& air, double squares) {
  const double above = std::max(squares, 0.0), radius = air.planet_radius_m;
  return above / (std::sqrt(radius * radius + above) + radius);
}

std::vector<double> levels(const Air& air) {
  std::vector<double> levels;
  for (const double heights : {0.8, 2.2, 5.0}) levels.push_back(heights * air.mie_height_m);
  for (const double heights : {0.6, 1.5, 3.0, 6.0}) levels.push_back(heights * air.rayleigh_height_m);
  for (const double side : {-1, 0, 1}) levels.push_back(air.ozone_height_m + side * air.ozone_half_width_m);
  return levels;
}

}  // namespace

Air air_of(const EffectValues& values) {
  const auto number = [&](const char* name) { return values.numbers.find(name)->second; };
  const auto colour = [&](const std::string& name) {
    return glm::dvec3(number((name + "_red").c_str()), number((name + "_green").c_str()), number((name + "_blue").c_str()));
  };
  Air air;
  const double density = number("density");
  air.planet_radius_m = number("planet_radius"), air.top_m = number("top");
  air.rayleigh = density * colour("rayleigh"), air.rayleigh_height_m = number("rayleigh_height");
  air.mie = density * number("mie_amount") * colour("mie"), air.mie_albedo = number("mie_albedo");
  air.mie_height_m = number("mie_height"), air.mie_g = number("mie_g");
  air.ozone = density * number("ozone_amount") * colour("ozone");
  air.ozone_height_m = number("ozone_height"), air.ozone_half_width_m = number("ozone_half_width");
  return air;
}

double altitude_m(const Air& air, glm::dvec3 point) {
  return altitude_from_squares(air, glm::dot(point, point) + 2 * air.planet_radius_m * point.y);
}

glm::dvec3 densities(const Air& air, double altitude) {
  return {std::exp(-altitude / air.rayleigh_height_m), std::exp(-altitude / air.mie_height_m),
          std::max(0.0, 1 - std::abs(altitude - air.ozone_height_m) / air.ozone_half_width_m)};
}

Span span_in_air(const Air& air, const AirRay& ray, double end_m) {
  const Squares squares(air, ray);
  const std::vector<double> at_top = crossings(air, squares, air.top_m);
  if (at_top.empty()) return {};
  const Span span{std::max(at_top[0], 0.0), std::min(at_top[1], end_m)};
  return span.to_m > span.from_m ? span : Span{};
}

bool meets_planet(const Air& air, const AirRay& ray) {
  const Squares squares(air, ray);
  return squares.half_linear < 0 && squares.half_linear * squares.half_linear >= squares.constant;
}

std::vector<double> smooth_pieces(const Air& air, const AirRay& ray, Span span, std::vector<double> also) {
  const Squares squares(air, ray);
  std::vector<double> pieces = std::move(also);
  for (const double level : levels(air))
    for (const double t : crossings(air, squares, level)) pieces.push_back(t);
  pieces.push_back(-squares.half_linear);
  std::erase_if(pieces, [&](double t) { return !(t > span.from_m && t < span.to_m); });
  pieces.push_back(span.from_m), pieces.push_back(span.to_m);
  std::sort(pieces.begin(), pieces.end());
  return pieces;
}

glm::dvec3 column_between(const Air& air, const AirRay& ray, double from_m, double to_m) {
  const Squares squares(air, ray);
  using Rule = boost::math::quadrature::gauss<double, 6>;
  const double middle = (from_m + to_m) / 2, half = (to_m - from_m) / 2;
  const auto at = [&](double t) { return densities(air, altitude_from_squares(air, squares.at(t))); };
  glm::dvec3 sum(0);
  for (size_t i = 0; i < Rule::weights().size(); ++i)
    sum += Rule::weights()[i] * (at(middle - half * Rule::abscissa()[i]) + at(middle + half * Rule::abscissa()[i]));
  return half * sum;
}

glm::dvec3 column(const Air& air, const AirRay& ray, Span span) {
  const std::vector<double> pieces = smooth_pieces(air, ray, span);
  glm::dvec3 sum(0);
  for (size_t i = 1; i < pieces.size(); ++i) sum += column_between(air, ray, pieces[i - 1], pieces[i]);
  return sum;
}

glm::dvec3 transmittance(const Air& air, glm::dvec3 column) {
  return glm::exp(-(column.x * air.rayleigh + column.y * air.mie + column.z * air.ozone));
}

glm::dvec3 sun_transmittance(const Air& air, glm::dvec3 point, glm::dvec3 to_sun) {
  const AirRay ray{point, to_sun};
  if (meets_planet(air, ray)) return glm::dvec3(0);
  return transmittance(air, column(air, ray, span_in_air(air, ray, INFINITY)));
}

}  // namespace lamina
