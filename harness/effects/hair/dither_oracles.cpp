// SPDX-License-Identifier: Apache-2.0
// Patterns of thresholds over pixels.
#include <cmath>

#include "harness/effects/hair/hair_oracles.h"

namespace lamina {
namespace {

// Bayer's matrix, doubled from 2x2: M(2n) = 4 M(n) + M(2), row by row.
int bayer_rank(int64_t x, int64_t y) {
  static constexpr int two[2][2] = {{0, 2}, {3, 1}};
  return 4 * two[y % 2][x % 2] + two[y / 2 % 2][x / 2 % 2];
}

Real bayer_threshold(std::span<const Real> p) {
  const auto x = static_cast<int64_t>(floor(p[0])), y = static_cast<int64_t>(floor(p[1]));
  return (Real(bayer_rank(x, y)) + Real("0.5")) / 16;
}

Real real_fract(const Real& x) { return x - floor(x); }

Real gradient_threshold(std::span<const Real> p) {
  const Real inner = real_fract(p[0] * Real("0.06711056") + p[1] * Real("0.00583715"));
  return real_fract(Real("52.9829189") * inner);
}

bool whole_pixel(Oracle::Point p, double most) {
  return p[0] >= 0 && p[1] >= 0 && p[0] <= most && p[1] <= most && p[0] == std::floor(p[0]) && p[1] == std::floor(p[1]);
}

std::vector<double> pixel_within(SetRandom& r, double low, double high) {
  return {std::floor(r.uniform(low, high)), std::floor(r.uniform(low, high))};
}

// A pixel whose noise, and the product inside it, are not within 2% of a jump.
std::vector<double> smooth_pixel(SetRandom& r, double high) {
  for (;;) {
    const std::vector<double> at = pixel_within(r, 0, high);
    const double inner = at[0] * 0.06711056 + at[1] * 0.00583715, a = inner - std::floor(inner), b = 52.9829189 * a;
    if (std::abs(a - 0.5) < 0.48 && std::abs(b - std::floor(b) - 0.5) < 0.48) return at;
  }
}

}  // namespace

const Oracle& ordered_dither_oracle() {
  static const FormulaOracle oracle({{"x", "y"},
                                     "pixels must be whole numbers from 0 to 2^22",
                                     [](Oracle::Point p) { return whole_pixel(p, 4194304); },
                                     bayer_threshold,
                                     of_one,
                                     {{"screen", [](SetRandom& r) { return pixel_within(r, 0, 4096); }},
                                      {"far", [](SetRandom& r) { return pixel_within(r, 4096, 4194304); }}}});
  return oracle;
}

const Oracle& gradient_noise_oracle() {
  static const FormulaOracle oracle({{"x", "y"},
                                     "pixels must be whole numbers from 0 to 65535",
                                     [](Oracle::Point p) { return whole_pixel(p, 65535); },
                                     gradient_threshold,
                                     of_one,
                                     {{"corner", [](SetRandom& r) { return smooth_pixel(r, 64); }},
                                      {"screen", [](SetRandom& r) { return smooth_pixel(r, 4096); }}}});
  return oracle;
}

}  // namespace lamina
