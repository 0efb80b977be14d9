// SPDX-License-Identifier: Apache-2.0
// Blended normals, sharpened shadows, Burley's radius and the sum of Gaussians.
#include <algorithm>
#include <cmath>

#include "harness/effects/skin/skin_oracles.h"
#include "harness/stress/formula_oracle.h"

namespace lamina {
namespace {

Real unit_clamp(Real x) { return x < 0 ? Real(0) : x > 1 ? Real(1) : x; }

Real blended_cosine(std::span<const Real> p) {
  const Real red = p[1] + (p[0] - p[1]) * p[2], rest = p[1] + (p[0] - p[1]) * p[3];
  return unit_clamp(red < rest ? red : rest);
}

Real sharpened_red(std::span<const Real> p) {
  const Real x = p[0] <= 0 ? Real(0) : Real(pow(p[0], p[1])), y = p[0] <= 0 ? Real(0) : Real(pow(p[0], p[2]));
  const Real red = y + (x - y) * p[3], rest = y + (x - y) * p[3] / 2;
  const Real grey = Real("0.3") * red + Real("0.7") * rest;
  return unit_clamp(red / 4 + 3 * grey / 4);
}

// x^3 + 3 x = 4 (1 - u), x = exp(-r / 3), by Newton's method from above.
Real burley_distance(std::span<const Real> p) {
  const Real right = 4 * (1 - p[0]);
  Real x = right / 3;
  if (x > 1) x = 1;
  for (int i = 0; i < 60; ++i) x -= (x * x * x + 3 * x - right) / (3 * x * x + 3);
  return -3 * log(x);
}

Real six_gaussians(std::span<const Real> p) {
  static const Real variances[] = {Real("0.0064"), Real("0.0484"), Real("0.187"), Real("0.567"), Real("1.99"), Real("7.41")};
  static const Real weights[] = {Real("0.233"), Real("0.1"), Real("0.118"), Real("0.113"), Real("0.358"), Real("0.078")};
  const Real two_pi = 2 * acos(Real(-1));
  Real sum = 0;
  for (int i = 0; i < 6; ++i) sum += weights[i] * exp(-p[0] * p[0] / (2 * variances[i])) / (two_pi * variances[i]);
  return sum;
}

double code_cosine(SetRandom& r) { return std::floor(r.uniform(0, 256)) / 127.5 - 1; }

FormulaOracle shadow_oracle() {
  return FormulaOracle({{"s", "px", "py", "amount"},
                        "the shadow and the amount must lie from 0 to 1, powers from 1 to 16",
                        [](Oracle::Point p) {
                          return p[0] >= 0 && p[0] <= 1 && p[1] >= 1 && p[1] <= 16 && p[2] >= 1 && p[2] <= 16 && p[3] >= 0 &&
                                 p[3] <= 1;
                        },
                        sharpened_red,
                        of_one,
                        {{"subdermal",
                          [](SetRandom& r) {
                            return std::vector{r.uniform(0, 1), 1.0, 2.0, r.uniform(0, 1)};
                          }},
                         {"epidermal",
                          [](SetRandom& r) {
                            return std::vector{r.uniform(0, 1), 4.0, 8.0, r.uniform(0, 1)};
                          }},
                         {"diffuse",
                          [](SetRandom& r) {
                            return std::vector{r.uniform(0, 1), 16.0, 16.0, r.uniform(0, 1)};
                          }},
                         {"ends", [](SetRandom& r) {
                            const double off = r.uniform(0, 1) < 0.2 ? 0 : r.logarithmic(1e-7, 1e-6);
                            return std::vector{r.uniform(0, 1) < 0.5 ? off : 1 - off, std::floor(r.uniform(1, 17)),
                                               std::floor(r.uniform(1, 17)), r.uniform(0, 1)};
                          }}}});
}

}  // namespace

const Oracle& blended_normals_oracle() {
  static const FormulaOracle oracle({{"vertex", "bump", "red", "rest"},
                                     "cosines must lie from -1 to 1, intensities from 0 to 1",
                                     [](Oracle::Point p) {
                                       return std::abs(p[0]) <= 1 && std::abs(p[1]) <= 1 && p[2] >= 0 && p[2] <= 1 &&
                                              p[3] >= 0 && p[3] <= 1;
                                     },
                                     blended_cosine,
                                     of_one,
                                     {{"codes",
                                       [](SetRandom& r) {
                                         const double vertex = code_cosine(r);
                                         return std::vector{vertex, code_cosine(r), 0.6, 0.4};
                                       }},
                                      {"all", [](SetRandom& r) {
                                         const double vertex = r.uniform(-1, 1), bump = r.uniform(-1, 1), red = r.uniform(0, 1);
                                         return std::vector{vertex, bump, red, r.uniform(0, 1)};
                                       }}}});
  return oracle;
}

const Oracle& shadow_powers_oracle() {
  static const FormulaOracle oracle = shadow_oracle();
  return oracle;
}

const Oracle& burley_radius_oracle() {
  static const FormulaOracle oracle({{"u"},
                                     "the share must lie between 0 and 1",
                                     [](Oracle::Point p) { return p[0] > 0 && p[0] < 1; },
                                     burley_distance,
                                     of_value,
                                     {{"all", [](SetRandom& r) { return std::vector{r.uniform(0.001, 0.999)}; }},
                                      {"small", [](SetRandom& r) { return std::vector{r.logarithmic(1e-7, 1e-2)}; }},
                                      {"large", [](SetRandom& r) { return std::vector{1 - r.logarithmic(1e-6, 1e-3)}; }}}});
  return oracle;
}

const Oracle& gaussian_sum_oracle() {
  static const FormulaOracle oracle({{"r"},
                                     "the distance must lie from 0 to 16 mm",
                                     [](Oracle::Point p) { return p[0] >= 0 && p[0] <= 16; },
                                     six_gaussians,
                                     [](double value) { return std::max(std::abs(value), 1e-3); },
                                     {{"near", [](SetRandom& r) { return std::vector{r.uniform(0, 0.5)}; }},
                                      {"middle", [](SetRandom& r) { return std::vector{r.uniform(0.5, 5)}; }},
                                      {"far", [](SetRandom& r) { return std::vector{r.uniform(5, 16)}; }}}});
  return oracle;
}

}  // namespace lamina
