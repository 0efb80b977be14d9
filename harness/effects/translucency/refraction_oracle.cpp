// SPDX-License-Identifier: Apache-2.0
// Fresnel's reflectance of unpolarized light; n is the index that the light goes into over the one that it comes from, so below
// 1 from inside, where it is reflected whole beyond the critical angle.
#include "harness/effects/translucency/oracles.h"

namespace lamina {
namespace {

Real reflectance_of(std::span<const Real> p) {
  const Real c = p[0], n = p[1], k = n * n - 1 + c * c;
  if (k <= 0) return 1;
  const Real g = sqrt(k);
  if (c + g == 0) return 1;
  const Real across = (c - g) / (c + g), along = (n * n * c - g) / (n * n * c + g);
  return (across * across + along * along) / 2;
}

double critical(double n) { return std::sqrt(std::max(1 - n * n, 0.0)); }

}  // namespace

const Oracle& refraction_oracle() {
  static const FormulaOracle oracle(
      {{"c", "n"},
       "the cosine must lie above 0 and up to 1, the index from 0.25 to 4",
       [](Oracle::Point p) { return p[0] > 0 && p[0] <= 1 && p[1] >= 0.25 && p[1] <= 4; },
       reflectance_of,
       of_one,
       {{"outside",
         [](SetRandom& r) {
           return std::vector{r.uniform(1e-6, 1), r.uniform(1, 3)};
         }},
        {"inside",
         [](SetRandom& r) {
           return std::vector{r.uniform(1e-6, 1), 1 / r.uniform(1, 3)};
         }},
        {"grazing",
         [](SetRandom& r) {
           return std::vector{r.logarithmic(1e-6, 1e-2), r.uniform(1, 3)};
         }},
        {"near_critical",
         [](SetRandom& r) {
           const double n = 1 / r.uniform(1.05, 3), off = r.logarithmic(1e-7, 1e-2);
           return std::vector{std::clamp(critical(n) * (1 + (r.uniform(-1, 1) < 0 ? -off : off)), 1e-6, 1.0), n};
         }},
        {"index_near_1", [](SetRandom& r) {
           return std::vector{r.uniform(1e-3, 1), 1 + r.logarithmic(1e-6, 1e-2)};
         }}}});
  return oracle;
}

}  // namespace lamina
