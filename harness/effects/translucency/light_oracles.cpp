// SPDX-License-Identifier: Apache-2.0
// Wrap lighting that adds up over the sphere to what Lambert's cosine does, and a lobe of light from behind.
#include <algorithm>
#include <cmath>

#include "harness/effects/translucency/oracles.h"

namespace lamina {
namespace {

Real wrapped(std::span<const Real> p) {
  const Real sum = p[0] + p[1], whole = 1 + p[1];
  return sum <= 0 ? Real(0) : Real(sum / (whole * whole));
}

// Inputs vl, nl, vn, d, p: V.L, N.L, V.N of unit vectors, the bend of the light by the normal, the power.
Real lobe(std::span<const Real> p) {
  const Real squared = 1 + 2 * p[3] * p[1] + p[3] * p[3];
  if (squared <= 0) return 0;
  const Real cosine = -(p[0] + p[3] * p[2]) / sqrt(squared);
  return cosine <= 0 ? Real(0) : Real(pow(cosine, p[4]));
}

// Directions all over, as cosines that three unit vectors can have.
std::vector<double> directions(SetRandom& r, double d, double power, double spread) {
  const double nl = r.uniform(-1, 1), a = std::sqrt(1 - nl * nl);
  // V: around -L within `spread` (cosine), turned by any angle.
  const double away = 1 - r.uniform(0, spread), angle = r.uniform(0, 6.283185307),
               side = std::sqrt(std::max(1 - away * away, 0.0));
  return {-away, nl, -away * nl + side * std::cos(angle) * a, d, power};
}

}  // namespace

const Oracle& wrap_oracle() {
  static const FormulaOracle oracle(
      {{"c", "w"},
       "the cosine must lie from -1 to 1, the wrap from 0 to 1",
       [](Oracle::Point p) { return std::abs(p[0]) <= 1 && p[1] >= 0 && p[1] <= 1; },
       wrapped,
       of_one,
       {{"all",
         [](SetRandom& r) {
           return std::vector{r.uniform(-1, 1), r.uniform(0, 1)};
         }},
        {"edge",
         [](SetRandom& r) {
           const double w = r.uniform(0.01, 1);
           return std::vector{std::clamp(-w * (1 + r.logarithmic(1e-6, 1e-2) * (r.uniform(-1, 1) < 0 ? -1 : 1)), -1.0, 1.0), w};
         }},
        {"small", [](SetRandom& r) {
           return std::vector{r.uniform(-1, 1), r.logarithmic(1e-6, 1e-2)};
         }}}});
  return oracle;
}

const Oracle& back_light_oracle() {
  static const FormulaOracle oracle({{"vl", "nl", "vn", "d", "p"},
                                     "cosines must lie from -1 to 1, the bend from 0 to 1, the power from 1 to 64",
                                     [](Oracle::Point p) {
                                       return std::abs(p[0]) <= 1 && std::abs(p[1]) <= 1 && std::abs(p[2]) <= 1 && p[3] >= 0 &&
                                              p[3] <= 1 && p[4] >= 1 && p[4] <= 64;
                                     },
                                     lobe,
                                     of_one,
                                     {{"all",
                                       [](SetRandom& r) {
                                         const double d = r.uniform(0, 1), p = r.uniform(1, 12);
                                         return directions(r, d, p, 2);
                                       }},
                                      {"looking_into_the_light",
                                       [](SetRandom& r) {
                                         const double d = r.uniform(0, 0.3), p = r.uniform(2, 12);
                                         return directions(r, d, p, 0.1);
                                       }},
                                      {"sharp",
                                       [](SetRandom& r) {
                                         const double d = r.uniform(0, 0.5), p = r.uniform(16, 64);
                                         return directions(r, d, p, 0.3);
                                       }},
                                      {"strongly_bent", [](SetRandom& r) {
                                         const double d = r.uniform(0.7, 0.999), p = r.uniform(1, 12);
                                         return directions(r, d, p, 2);
                                       }}}});
  return oracle;
}

}  // namespace lamina
