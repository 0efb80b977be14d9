// SPDX-License-Identifier: Apache-2.0
// What passes an optical depth, which ramps tabulate; and the path that a texel of a depth map stands for.
#include "harness/effects/translucency/oracles.h"

namespace lamina {

const Oracle& ramp_oracle() {
  static const FormulaOracle oracle({{"x"},
                                     "the optical depth must lie from 0 to 16",
                                     [](Oracle::Point p) { return p[0] >= 0 && p[0] <= 16; },
                                     [](std::span<const Real> p) { return Real(exp(-p[0])); },
                                     of_one,
                                     {{"all", [](SetRandom& r) { return std::vector{r.uniform(0, 8)}; }},
                                      {"thin", [](SetRandom& r) { return std::vector{r.logarithmic(1e-5, 0.1)}; }},
                                      {"thick", [](SetRandom& r) { return std::vector{r.uniform(4, 16)}; }}}});
  return oracle;
}

// Inputs s, slope, u: the true path (in texels of the map), the tangent of the angle between the entry's normal and the light,
// and how far from the texel's middle the point lies (in texels). The map's own depth is that of the texel's middle.
const Oracle& depth_bias_oracle() {
  static const FormulaOracle oracle(
      {{"s", "slope", "u"},
       "the path must lie from 0 to 1000, the slope from 0 to 10, the place from -0.5 to 0.5",
       [](Oracle::Point p) { return p[0] >= 0 && p[0] <= 1000 && p[1] >= 0 && p[1] <= 10 && p[2] >= -0.5 && p[2] <= 0.5; },
       [](std::span<const Real> p) { return p[0]; },
       of_one,
       {{"thick",
         [](SetRandom& r) {
           return std::vector{r.uniform(5, 200), r.uniform(0, 3), r.uniform(-0.5, 0.5)};
         }},
        {"lit",
         [](SetRandom& r) {
           return std::vector{0.0, r.uniform(0, 3), r.uniform(-0.5, 0.5)};
         }},
        {"thin",
         [](SetRandom& r) {
           return std::vector{r.uniform(0, 5), r.uniform(0, 3), r.uniform(-0.5, 0.5)};
         }},
        {"steep", [](SetRandom& r) {
           return std::vector{r.uniform(0, 20), r.uniform(3, 10), r.uniform(-0.5, 0.5)};
         }}}});
  return oracle;
}

}  // namespace lamina
