// SPDX-License-Identifier: Apache-2.0
// Phase functions, a steradian; the cosine is 1 where light goes straight on.
// Henyey and Greenstein, "Diffuse Radiation in the Galaxy", Astrophysical Journal 93, 1941; Cornette and Shanks, "Physically
// Reasonable Analytic Expression for the Single-Scattering Phase Function", Applied Optics 31, 1992.
#include <boost/math/constants/constants.hpp>

#include "harness/effects/scattering_functions/exact_function.h"

namespace lamina {
namespace {

WideReal wide_pi() { return boost::math::constants::pi<WideReal>(); }

std::string phase_refusal(Oracle::Point p) {
  return std::abs(p[0]) < 1 && std::abs(p[1]) <= 1 ? "" : "g must lie between -1 and 1, the cosine from -1 to 1";
}

WideReal base_to_three_halves(const WideReal& g, const WideReal& c) {
  const WideReal base = 1 + g * g - 2 * g * c;
  return base * sqrt(base);
}

std::vector<ExactFunction::Set> phase_sets() {
  return {{"everyday",
           [](InputRandom& r) {
             return std::vector<float>{r.uniform(-0.9, 0.9), r.uniform(-1, 1)};
           }},
          {"forward",
           [](InputRandom& r) {
             return std::vector<float>{1 - r.logarithmic(1e-5, 1e-2), 1 - r.logarithmic(1e-7, 1e-2)};
           }},
          {"peak",
           [](InputRandom& r) {
             return std::vector<float>{1 - r.logarithmic(1e-5, 1e-2), 1};
           }},
          {"backward",
           [](InputRandom& r) {
             return std::vector<float>{r.logarithmic(1e-5, 1e-2) - 1, r.logarithmic(1e-7, 1e-2) - 1};
           }},
          {"isotropic", [](InputRandom& r) {
             return std::vector<float>{r.sign() * r.logarithmic(1e-10, 1e-2), r.uniform(-1, 1)};
           }}};
}

}  // namespace

ExactFunction henyey_greenstein_function() {
  return {{"g", "cosine"},
          phase_refusal,
          [](std::span<const WideReal> p) -> WideReal {
            return (1 - p[0] * p[0]) / (4 * wide_pi() * base_to_three_halves(p[0], p[1]));
          },
          phase_sets()};
}

ExactFunction cornette_shanks_function() {
  return {{"g", "cosine"},
          phase_refusal,
          [](std::span<const WideReal> p) -> WideReal {
            const WideReal squared = p[0] * p[0];
            return 3 * (1 - squared) * (1 + p[1] * p[1]) / (8 * wide_pi() * (2 + squared) * base_to_three_halves(p[0], p[1]));
          },
          phase_sets()};
}

ExactFunction rayleigh_function() {
  return {{"cosine"},
          [](Oracle::Point p) -> std::string { return std::abs(p[0]) <= 1 ? "" : "the cosine must lie from -1 to 1"; },
          [](std::span<const WideReal> p) -> WideReal { return 3 * (1 + p[0] * p[0]) / (16 * wide_pi()); },
          {{"everyday", [](InputRandom& r) { return std::vector<float>{r.uniform(-1, 1)}; }},
           {"sideways", [](InputRandom& r) { return std::vector<float>{r.sign() * r.logarithmic(1e-20, 1e-2)}; }}}};
}

}  // namespace lamina
