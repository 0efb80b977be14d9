// SPDX-License-Identifier: Apache-2.0
// The share of unpolarized light that a smooth boundary of dielectrics reflects: Fresnel's equations.
#include "harness/effects/scattering_functions/formulas.h"

namespace lamina {
namespace {

// eta: the index of refraction behind over that before.
Real wide_fresnel(const Real& cosine, const Real& eta) {
  const Real squared = eta * eta - 1 + cosine * cosine;
  if (squared < 0) return 1;
  const Real refracted = sqrt(squared);  // eta times its cosine
  if (cosine + refracted == 0) return 1;
  const Real across = (cosine - refracted) / (cosine + refracted);
  const Real along = (eta * eta * cosine - refracted) / (eta * eta * cosine + refracted);
  return (across * across + along * along) / 2;
}

}  // namespace

Formula fresnel_formula() {
  return {{"cosine", "eta"},
          "the cosine must lie from 0 to 1, eta from 0.1 to 10",
          [](Oracle::Point p) { return p[0] >= 0 && p[0] <= 1 && p[1] >= 0.1 && p[1] <= 10; },
          [](std::span<const Real> p) -> Real { return wide_fresnel(p[0], p[1]); },
          of_value,
          {{"everyday", single<[](SingleRandom& r) {
              return std::vector<double>{r.uniform(0, 1), r.uniform(1.1, 2)};
            }>},
           {"grazing", single<[](SingleRandom& r) {
              return std::vector<double>{r.logarithmic(1e-7, 1e-2), r.uniform(1.1, 2)};
            }>},
           {"matched", single<[](SingleRandom& r) {
              return std::vector<double>{r.uniform(0.05, 1), 1 + r.sign() * r.logarithmic(1e-5, 1e-3)};
            }>},
           {"inside", single<[](SingleRandom& r) {
              return std::vector<double>{r.uniform(0, 1), r.uniform(0.5, 0.9)};
            }>},
           {"critical", single<[](SingleRandom& r) {
              const float eta = r.uniform(0.5, 0.9);
              return std::vector<double>{std::sqrt(1 - eta * eta) * (1 + r.sign() * r.logarithmic(1e-7, 1e-3)), eta};
            }>}}};
}

}  // namespace lamina
