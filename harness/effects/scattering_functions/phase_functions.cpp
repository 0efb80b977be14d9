// SPDX-License-Identifier: Apache-2.0
// Phase functions, a steradian; the cosine is 1 where light goes straight on.
// Henyey and Greenstein, "Diffuse Radiation in the Galaxy", Astrophysical Journal 93, 1941; Cornette and Shanks, "Physically
// Reasonable Analytic Expression for the Single-Scattering Phase Function", Applied Optics 31, 1992.
#include <boost/math/constants/constants.hpp>

#include "harness/effects/scattering_functions/formulas.h"

namespace lamina {
namespace {

Real wide_pi() { return boost::math::constants::pi<Real>(); }

const char* const phase_refusal = "g must lie between -1 and 1, the cosine from -1 to 1";
bool has_phase(Oracle::Point p) { return std::abs(p[0]) < 1 && std::abs(p[1]) <= 1; }

Real base_to_three_halves(const Real& g, const Real& c) {
  const Real base = 1 + g * g - 2 * g * c;
  return base * sqrt(base);
}

std::vector<Formula::Set> phase_sets() {
  return {{"everyday", single<[](SingleRandom& r) {
             return std::vector<double>{r.uniform(-0.9, 0.9), r.uniform(-1, 1)};
           }>},
          {"forward", single<[](SingleRandom& r) {
             return std::vector<double>{1 - r.logarithmic(1e-5, 1e-2), 1 - r.logarithmic(1e-7, 1e-2)};
           }>},
          {"peak", single<[](SingleRandom& r) {
             return std::vector<double>{1 - r.logarithmic(1e-5, 1e-2), 1};
           }>},
          {"backward", single<[](SingleRandom& r) {
             return std::vector<double>{r.logarithmic(1e-5, 1e-2) - 1, r.logarithmic(1e-7, 1e-2) - 1};
           }>},
          {"isotropic", single<[](SingleRandom& r) {
             return std::vector<double>{r.sign() * r.logarithmic(1e-10, 1e-2), r.uniform(-1, 1)};
           }>}};
}

}  // namespace

Formula henyey_greenstein_formula() {
  return {
      {"g", "cosine"},
      phase_refusal,
      has_phase,
      [](std::span<const Real> p) -> Real { return (1 - p[0] * p[0]) / (4 * wide_pi() * base_to_three_halves(p[0], p[1])); },
      of_value,
      phase_sets()};
}

Formula cornette_shanks_formula() {
  return {{"g", "cosine"},
          phase_refusal,
          has_phase,
          [](std::span<const Real> p) -> Real {
            const Real squared = p[0] * p[0];
            return 3 * (1 - squared) * (1 + p[1] * p[1]) / (8 * wide_pi() * (2 + squared) * base_to_three_halves(p[0], p[1]));
          },
          of_value,
          phase_sets()};
}

Formula rayleigh_formula() {
  return {{"cosine"},
          "the cosine must lie from -1 to 1",
          [](Oracle::Point p) { return std::abs(p[0]) <= 1; },
          [](std::span<const Real> p) -> Real { return 3 * (1 + p[0] * p[0]) / (16 * wide_pi()); },
          of_value,
          {{"everyday", single<[](SingleRandom& r) { return std::vector<double>{r.uniform(-1, 1)}; }>},
           {"sideways", single<[](SingleRandom& r) { return std::vector<double>{r.sign() * r.logarithmic(1e-20, 1e-2)}; }>}}};
}

}  // namespace lamina
