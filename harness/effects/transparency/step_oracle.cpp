// SPDX-License-Identifier: Apache-2.0
// The share of a pixel that lies left of a straight edge.
#include <cmath>

#include "harness/effects/transparency/layer_oracles.h"

namespace lamina {
namespace {

// The integral of clamp(t, 0, 1) up to t.
Real below_ramp(const Real& t) { return t <= 0 ? Real(0) : t >= 1 ? Real(t - 0.5) : Real(t * t / 2); }

// slope, offset
Real left_share(std::span<const Real> p) {
  const Real left = p[1] + 0.5;
  if (p[0] == 0) return left < 0 ? Real(0) : left > 1 ? Real(1) : left;
  return (below_ramp(left + p[0] / 2) - below_ramp(left - p[0] / 2)) / p[0];
}

}  // namespace

const Oracle& step_reconstruction_oracle() {
  static const FormulaOracle oracle({{"slope", "offset"},
                                     "the slope must lie from 0 to 1, the offset from -4 to 4",
                                     [](Oracle::Point p) { return p[0] >= 0 && p[0] <= 1 && std::abs(p[1]) <= 4; },
                                     left_share,
                                     of_one,
                                     {{"upright",
                                       [](SetRandom& r) {
                                         return std::vector{0.0, r.uniform(-2, 2)};
                                       }},
                                      {"between",
                                       [](SetRandom& r) {
                                         return std::vector{0.0, std::floor(r.uniform(-2, 2)) + 0.5};
                                       }},
                                      {"gentle",
                                       [](SetRandom& r) {
                                         return std::vector{0.5, r.uniform(-2.5, 2.5)};
                                       }},
                                      {"diagonal",
                                       [](SetRandom& r) {
                                         return std::vector{1.0, r.uniform(-3, 3)};
                                       }},
                                      {"any", [](SetRandom& r) {
                                         return std::vector{r.uniform(0, 1), r.uniform(-3, 3)};
                                       }}}});
  return oracle;
}

}  // namespace lamina
