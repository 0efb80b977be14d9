// SPDX-License-Identifier: Apache-2.0
// The share of unpolarized light that a smooth boundary of dielectrics reflects: Fresnel's equations.
#include "harness/effects/scattering_functions/formulas.h"

namespace lamina {
namespace {

// n: the index of refraction behind over that before.
Real wide_fresnel(const Real& cosine, const Real& n) {
  const Real squared = n * n - 1 + cosine * cosine;
  if (squared < 0) return 1;
  const Real refracted = sqrt(squared);  // n times its cosine
  if (cosine + refracted == 0) return 1;
  const Real across = (cosine - refracted) / (cosine + refracted);
  const Real along = (n * n * cosine - refracted) / (n * n * cosine + refracted);
  return (across * across + along * along) / 2;
}

}  // namespace

Formula fresnel_formula() {
  return {{"c", "n"},       "the cosine must lie above 0 and up to 1, the index from 0.25 to 4",
          accepts_boundary, [](std::span<const Real> p) -> Real { return wide_fresnel(p[0], p[1]); },
          of_value,         boundary_sets()};
}

}  // namespace lamina
