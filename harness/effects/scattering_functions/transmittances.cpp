// SPDX-License-Identifier: Apache-2.0
// What passes a layer of an optical depth, its mean along the layer, and what a homogeneous slab scatters once.
#include "harness/effects/scattering_functions/exact_function.h"

namespace lamina {
namespace {

std::string depth_refusal(Oracle::Point p) {
  for (const double x : p)
    if (!(x >= 0 && x <= 200)) return "an optical depth must lie from 0 to 200";
  return "";
}

// (1 - e^-x) / x
WideReal wide_mean(const WideReal& x) { return x == 0 ? WideReal(1) : WideReal(-expm1(-x) / x); }

}  // namespace

ExactFunction transmittance_function() {
  return {{"depth"},
          depth_refusal,
          [](std::span<const WideReal> p) -> WideReal { return exp(-p[0]); },
          {{"everyday", [](InputRandom& r) { return std::vector<float>{r.uniform(0, 10)}; }},
           {"thin", [](InputRandom& r) { return std::vector<float>{r.logarithmic(1e-20, 1e-2)}; }},
           {"thick", [](InputRandom& r) { return std::vector<float>{r.uniform(10, 87)}; }},
           {"beyond", [](InputRandom& r) { return std::vector<float>{r.uniform(87, 200)}; }}}};
}

ExactFunction mean_transmittance_function() {
  return {{"depth"},
          depth_refusal,
          [](std::span<const WideReal> p) -> WideReal { return wide_mean(p[0]); },
          {{"everyday", [](InputRandom& r) { return std::vector<float>{r.uniform(0.01, 10)}; }},
           {"thin", [](InputRandom& r) { return std::vector<float>{r.logarithmic(1e-20, 1e-2)}; }},
           {"none", [](InputRandom&) { return std::vector<float>{0}; }},
           {"thick", [](InputRandom& r) { return std::vector<float>{r.uniform(10, 200)}; }}}};
}

// a: the sun's path from above to the bottom, b: the eye's from the bottom to above. For an irradiance and a phase function
// of 1.
ExactFunction slab_in_scatter_function() {
  return {{"sun_depth", "view_depth"},
          depth_refusal,
          [](std::span<const WideReal> p) -> WideReal {
            return p[1] * exp(-p[0]) * (p[0] == p[1] ? WideReal(1) : WideReal(-expm1(-(p[1] - p[0])) / (p[1] - p[0])));
          },
          {{"everyday",
            [](InputRandom& r) {
              return std::vector<float>{r.uniform(0.01, 5), r.uniform(0.01, 5)};
            }},
           {"beside_the_sun",
            [](InputRandom& r) {
              const float sun = r.logarithmic(1e-2, 10);
              return std::vector<float>{sun, sun * (1 + r.sign() * r.logarithmic(1e-7, 1e-2))};
            }},
           {"at_the_sun",
            [](InputRandom& r) {
              const float sun = r.logarithmic(1e-2, 10);
              return std::vector<float>{sun, sun};
            }},
           {"thin",
            [](InputRandom& r) {
              return std::vector<float>{r.logarithmic(1e-10, 1e-2), r.logarithmic(1e-10, 1e-2)};
            }},
           {"thick", [](InputRandom& r) {
              return std::vector<float>{r.uniform(0, 80), r.uniform(0, 80)};
            }}}};
}

}  // namespace lamina
