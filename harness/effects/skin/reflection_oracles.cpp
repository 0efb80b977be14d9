// SPDX-License-Identifier: Apache-2.0
// The surface's own reflection.
#include <algorithm>
#include <cmath>

#include "harness/effects/skin/skin_oracles.h"
#include "harness/stress/formula_oracle.h"

namespace lamina {
namespace {

double of_a_thousandth(double value) { return std::max(std::abs(value), 1e-3); }

Real facet_density(Real nh, Real m) {
  if (nh <= 0) return 0;
  const Real squared = nh * nh;
  return exp(-(1 - nh) * (1 + nh) / (squared * m * m)) / (m * m * squared * squared);
}

Real reflected(std::span<const Real> p) {
  const Real squared = 2 + 2 * p[2];
  if (squared <= 0 || p[0] <= 0) return 0;
  const Real length = sqrt(squared), nh = (p[0] + p[1]) / length;
  const Real fresnel = Real("0.028") + Real("0.972") * pow(1 - length / 2, 5);
  return p[0] * fresnel * facet_density(nh < 1 ? nh : Real(1), p[3]) / squared;
}

// Cosines that three unit vectors can have: light and eye at these cosines to the normal, this azimuth apart.
std::vector<double> pair_of(double nl, double nv, double azimuth, double m) {
  const double lv = nl * nv + std::sqrt((1 - nl * nl) * (1 - nv * nv)) * std::cos(azimuth);
  return {nl, nv, std::clamp(lv, -0.9999, 1.0), m};
}

}  // namespace

const Oracle& beckmann_oracle() {
  static const FormulaOracle oracle({{"nh", "m"},
                                     "the cosine must lie from 0 to 1, the slope from 1/32 to 1",
                                     [](Oracle::Point p) { return p[0] >= 0 && p[0] <= 1 && p[1] >= 0.03125 && p[1] <= 1; },
                                     [](std::span<const Real> p) { return facet_density(p[0], p[1]); },
                                     of_a_thousandth,
                                     {{"skin",
                                       [](SetRandom& r) {
                                         return std::vector{r.uniform(0.866, 1), r.uniform(0.1, 0.5)};
                                       }},
                                      {"peak",
                                       [](SetRandom& r) {
                                         const double off = r.uniform(0, 1) < 0.1 ? 0 : r.logarithmic(1e-7, 1e-3);
                                         return std::vector{1 - off, r.uniform(0.1, 1)};
                                       }},
                                      {"grazing",
                                       [](SetRandom& r) {
                                         return std::vector{r.logarithmic(1e-4, 1e-1), r.uniform(0.05, 1)};
                                       }},
                                      {"sharp", [](SetRandom& r) {
                                         const double m = r.uniform(0.03125, 0.1), tangent = m * r.uniform(0, 3);
                                         return std::vector{1 / std::sqrt(1 + tangent * tangent), m};
                                       }}}});
  return oracle;
}

const Oracle& kelemen_reflection_oracle() {
  static const FormulaOracle oracle(
      {{"nl", "nv", "lv", "m"},
       "cosines of light and eye to the normal must lie from 0 to 1, between them from -1 to 1, the slope from 0.05 to 1",
       [](Oracle::Point p) {
         return p[0] >= 0 && p[0] <= 1 && p[1] >= 0 && p[1] <= 1 && std::abs(p[2]) <= 1 && p[3] >= 0.05 && p[3] <= 1;
       },
       reflected,
       of_a_thousandth,
       {{"all",
         [](SetRandom& r) {
           const double nl = r.uniform(0, 1), nv = r.uniform(0, 1), azimuth = r.uniform(0, 3.14159);
           return pair_of(nl, nv, azimuth, r.uniform(0.1, 1));
         }},
        {"mirror",
         [](SetRandom& r) {
           const double nl = r.uniform(0.2, 0.999), nv = std::clamp(nl + r.uniform(-0.05, 0.05), 0.1, 0.9999);
           return pair_of(nl, nv, 3.14159265 - r.uniform(0, 0.1), r.uniform(0.1, 0.5));
         }},
        {"grazing",
         [](SetRandom& r) {
           const double nl = r.uniform(0.01, 0.05), nv = r.uniform(0.01, 0.05);
           return pair_of(nl, nv, 3.14159265 - r.uniform(0, 0.02), r.uniform(0.1, 1));
         }},
        {"opposite", [](SetRandom& r) {
           return std::vector{0.0, 0.0, -1.0, r.uniform(0.1, 1)};
         }}}});
  return oracle;
}

}  // namespace lamina
