// SPDX-License-Identifier: Apache-2.0
// Snell's law: the cosine on the far side of a smooth boundary; and the points that are hard for a boundary's functions.
#include "harness/effects/scattering_functions/formulas.h"

namespace lamina {

bool accepts_boundary(Oracle::Point p) { return p[0] > 0 && p[0] <= 1 && p[1] >= 0.25 && p[1] <= 4; }

std::vector<Formula::Set> boundary_sets() {
  return {{"outside", single<[](SingleRandom& r) {
             return std::vector<double>{r.uniform(1e-6, 1), r.uniform(1.1, 3)};
           }>},
          {"grazing", single<[](SingleRandom& r) {
             return std::vector<double>{r.logarithmic(1e-7, 1e-2), r.uniform(1.1, 3)};
           }>},
          {"matched", single<[](SingleRandom& r) {
             return std::vector<double>{r.uniform(0.05, 1), 1 + r.sign() * r.logarithmic(1e-6, 1e-2)};
           }>},
          {"inside", single<[](SingleRandom& r) {
             return std::vector<double>{r.uniform(1e-6, 1), 1 / r.uniform(1.1, 3)};
           }>},
          {"near_critical", single<[](SingleRandom& r) {
             const float n = 1 / r.uniform(1.1, 3), off = r.sign() * r.logarithmic(1e-7, 1e-2);
             return std::vector<double>{std::min(std::sqrt(1 - n * n) * (1 + off), 1.0f), n};
           }>}};
}

Formula refraction_formula() {
  return {{"c", "n"},
          "the cosine must lie above 0 and up to 1, the index from 0.25 to 4",
          accepts_boundary,
          [](std::span<const Real> p) -> Real {
            const Real squared = p[1] * p[1] - 1 + p[0] * p[0];
            return squared <= 0 ? Real(0) : Real(sqrt(squared) / p[1]);
          },
          of_one,
          boundary_sets()};
}

}  // namespace lamina
