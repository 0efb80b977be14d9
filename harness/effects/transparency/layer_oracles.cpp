// SPDX-License-Identifier: Apache-2.0
// Three layers over black, front to back; and what passes one or two layers on the way to a depth.
#include "harness/effects/transparency/layer_oracles.h"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

// alpha, change, color, first, step
Real sorted_light(std::span<const Real> p) {
  Real sum = 0, through = 1;
  for (int i = 0; i < 3; ++i) {
    const Real alpha = std::clamp(Real(p[0] + i * p[1]), Real(0), Real(1)), color = i == 1 ? Real(1 - p[2]) : p[2];
    sum += through * alpha * color;
    through *= 1 - alpha;
  }
  return sum;
}

// z0, z1, share, total, z
Real transmittance_to(std::span<const Real> p) {
  Real share = 0;
  if (p[0] < p[4]) share += p[2];
  if (p[1] < p[4]) share += 1 - p[2];
  return exp(-p[3] * share);
}

std::vector<double> layers(SetRandom& r, double least, double most, double first, double step) {
  const double alpha = r.uniform(least, most), change = r.uniform(least, most);
  return {alpha, (change - alpha) / 2, r.uniform(0, 1), first, step};
}

// At least `gap` from both, anywhere from -1 to 1.
double asked(SetRandom& r, double z0, double z1, double gap) {
  for (;;)
    if (const double z = r.uniform(-1, 1); std::abs(z - z0) >= gap && std::abs(z - z1) >= gap) return z;
}
std::vector<double> two_layers(SetRandom& r, double min_gap, double max_gap, double total) {
  const double gap = r.uniform(min_gap, max_gap), z0 = r.uniform(-0.95, 0.95 - gap), z1 = z0 + gap;
  return {z0, z1, r.uniform(0.1, 0.9), total, asked(r, z0, z1, 0.1)};
}

}  // namespace

const Oracle& compositing_oracle() {
  static const FormulaOracle oracle(
      {{"alpha", "change", "color", "first", "step"},
       "alpha and color must lie from 0 to 1, change from -1 to 1, first from 0.15 to 500, step from 0 to 100",
       [](Oracle::Point p) {
         return p[0] >= 0 && p[0] <= 1 && std::abs(p[1]) <= 1 && p[2] >= 0 && p[2] <= 1 && p[3] >= 0.15 && p[3] <= 500 &&
                p[4] >= 0 && p[4] <= 100;
       },
       sorted_light,
       of_one,
       {{"everyday", [](SetRandom& r) { return layers(r, 0.1, 0.7, r.uniform(1, 8), r.uniform(0.2, 4)); }},
        {"thin", [](SetRandom& r) { return layers(r, 0.001, 0.03, r.uniform(1, 8), r.uniform(0.2, 4)); }},
        {"dense", [](SetRandom& r) { return layers(r, 0.7, 0.98, r.uniform(1, 8), r.uniform(0.2, 4)); }},
        {"opaque_front",
         [](SetRandom& r) {
           return std::vector{1.0, -r.uniform(0.05, 0.45), r.uniform(0, 1), r.uniform(1, 8), r.uniform(0.2, 4)};
         }},
        {"close", [](SetRandom& r) { return layers(r, 0.1, 0.7, r.uniform(1, 8), r.logarithmic(1e-3, 1e-2)); }},
        {"far", [](SetRandom& r) { return layers(r, 0.1, 0.7, r.uniform(50, 120), r.uniform(1, 30)); }}}});
  return oracle;
}

const Oracle& moment_transmittance_oracle() {
  static const FormulaOracle oracle(
      {{"z0", "z1", "share", "total", "z"},
       "depths must lie from -1 to 1 and the asking one differ from both, share from 0 to 1, total from 0 to 20",
       [](Oracle::Point p) {
         return std::abs(p[0]) <= 1 && std::abs(p[1]) <= 1 && std::abs(p[4]) <= 1 && p[2] >= 0 && p[2] <= 1 && p[3] >= 0 &&
                p[3] <= 20 && p[4] != p[0] && p[4] != p[1];
       },
       transmittance_to,
       of_one,
       {{"apart", [](SetRandom& r) { return two_layers(r, 0.5, 1.8, r.uniform(0.1, 4)); }},
        {"near_one",
         [](SetRandom& r) {
           std::vector<double> point = two_layers(r, 0.5, 1.8, r.uniform(0.1, 4));
           point[4] = point[0] + r.uniform(0.01, 0.1);
           return point;
         }},
        {"together", [](SetRandom& r) { return two_layers(r, 0.001, 0.02, r.uniform(0.1, 4)); }},
        {"one",
         [](SetRandom& r) {
           const double z0 = r.uniform(-0.95, 0.95);
           return std::vector{z0, z0, r.uniform(0, 1), r.uniform(0.1, 4), asked(r, z0, z0, 0.1)};
         }},
        {"faint", [](SetRandom& r) { return two_layers(r, 0.5, 1.8, r.logarithmic(1e-5, 1e-2)); }}}});
  return oracle;
}

}  // namespace lamina
