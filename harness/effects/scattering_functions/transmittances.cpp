// SPDX-License-Identifier: Apache-2.0
// What passes a layer of an optical depth, its mean along the layer, and what a homogeneous slab scatters once.
#include <algorithm>

#include "harness/effects/scattering_functions/formulas.h"

namespace lamina {
namespace {

const char* const depth_refusal = "an optical depth must lie from 0 to 200";
bool are_depths(Oracle::Point p) {
  return std::ranges::all_of(p, [](double x) { return x >= 0 && x <= 200; });
}

// (1 - e^-x) / x
Real wide_mean(const Real& x) { return x == 0 ? Real(1) : Real(-expm1(-x) / x); }

}  // namespace

Formula transmittance_formula() {
  return {{"depth"},
          depth_refusal,
          are_depths,
          [](std::span<const Real> p) -> Real { return exp(-p[0]); },
          of_value,
          {{"everyday", single<[](SingleRandom& r) { return std::vector<double>{r.uniform(0, 10)}; }>},
           {"thin", single<[](SingleRandom& r) { return std::vector<double>{r.logarithmic(1e-20, 1e-2)}; }>},
           {"thick", single<[](SingleRandom& r) { return std::vector<double>{r.uniform(10, 87)}; }>},
           {"beyond", single<[](SingleRandom& r) { return std::vector<double>{r.uniform(87, 200)}; }>}}};
}

Formula mean_transmittance_formula() {
  return {{"depth"},
          depth_refusal,
          are_depths,
          [](std::span<const Real> p) -> Real { return wide_mean(p[0]); },
          of_value,
          {{"everyday", single<[](SingleRandom& r) { return std::vector<double>{r.uniform(0.01, 10)}; }>},
           {"thin", single<[](SingleRandom& r) { return std::vector<double>{r.logarithmic(1e-20, 1e-2)}; }>},
           {"none", [](SetRandom&) { return std::vector<double>{0}; }},
           {"thick", single<[](SingleRandom& r) { return std::vector<double>{r.uniform(10, 200)}; }>}}};
}

// a: the sun's path from above to the bottom, b: the eye's from the bottom to above. For an irradiance and a phase function
// of 1.
Formula slab_in_scatter_formula() {
  return {{"sun_depth", "view_depth"},
          depth_refusal,
          are_depths,
          [](std::span<const Real> p) -> Real {
            return p[1] * exp(-p[0]) * (p[0] == p[1] ? Real(1) : Real(-expm1(-(p[1] - p[0])) / (p[1] - p[0])));
          },
          of_value,
          {{"everyday", single<[](SingleRandom& r) {
              return std::vector<double>{r.uniform(0.01, 5), r.uniform(0.01, 5)};
            }>},
           {"beside_the_sun", single<[](SingleRandom& r) {
              const float sun = r.logarithmic(1e-2, 10);
              return std::vector<double>{sun, sun * (1 + r.sign() * r.logarithmic(1e-7, 1e-2))};
            }>},
           {"at_the_sun", single<[](SingleRandom& r) {
              const float sun = r.logarithmic(1e-2, 10);
              return std::vector<double>{sun, sun};
            }>},
           {"thin", single<[](SingleRandom& r) {
              return std::vector<double>{r.logarithmic(1e-10, 1e-2), r.logarithmic(1e-10, 1e-2)};
            }>},
           {"thick", single<[](SingleRandom& r) {
              return std::vector<double>{r.uniform(0, 80), r.uniform(0, 80)};
            }>}}};
}

}  // namespace lamina
