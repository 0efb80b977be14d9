// SPDX-License-Identifier: Apache-2.0
// The share of unpolarized light that a smooth boundary of dielectrics reflects: Fresnel's equations.
#include "harness/effects/scattering_functions/exact_function.h"

namespace lamina {
namespace {

std::string fresnel_refusal(Oracle::Point p) {
  return p[0] >= 0 && p[0] <= 1 && p[1] >= 0.1 && p[1] <= 10 ? "" : "the cosine must lie from 0 to 1, eta from 0.1 to 10";
}

// eta: the index of refraction behind over that before.
WideReal wide_fresnel(const WideReal& cosine, const WideReal& eta) {
  const WideReal squared = eta * eta - 1 + cosine * cosine;
  if (squared < 0) return 1;
  const WideReal refracted = sqrt(squared);  // eta times its cosine
  if (cosine + refracted == 0) return 1;
  const WideReal across = (cosine - refracted) / (cosine + refracted);
  const WideReal along = (eta * eta * cosine - refracted) / (eta * eta * cosine + refracted);
  return (across * across + along * along) / 2;
}

}  // namespace

ExactFunction fresnel_function() {
  return {{"cosine", "eta"},
          fresnel_refusal,
          [](std::span<const WideReal> p) -> WideReal { return wide_fresnel(p[0], p[1]); },
          {{"everyday",
            [](InputRandom& r) {
              return std::vector<float>{r.uniform(0, 1), r.uniform(1.1, 2)};
            }},
           {"grazing",
            [](InputRandom& r) {
              return std::vector<float>{r.logarithmic(1e-7, 1e-2), r.uniform(1.1, 2)};
            }},
           {"matched",
            [](InputRandom& r) {
              return std::vector<float>{r.uniform(0.05, 1), 1 + r.sign() * r.logarithmic(1e-5, 1e-3)};
            }},
           {"inside",
            [](InputRandom& r) {
              return std::vector<float>{r.uniform(0, 1), r.uniform(0.5, 0.9)};
            }},
           {"critical", [](InputRandom& r) {
              const float eta = r.uniform(0.5, 0.9);
              return std::vector<float>{std::sqrt(1 - eta * eta) * (1 + r.sign() * r.logarithmic(1e-7, 1e-3)), eta};
            }}}};
}

}  // namespace lamina
