// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/water/water_oracles.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>

namespace lamina {
namespace {

Real wide_two_pi() { return boost::math::constants::two_pi<Real>(); }

// The waves of shaders/gerstner/four_waves.glsl.
Real gerstner_component(std::span<const Real> p) {
  const Real lengths[] = {Real(8), Real(5), Real("3.2"), Real(2)},
             amplitudes[] = {Real("0.18"), Real("0.10"), Real("0.06"), Real("0.03")},
             from_degrees[] = {Real(10), Real(55), Real(-40), Real(100)}, steepness("0.2");
  Real place[] = {p[0], Real(0), p[1]}, along_x[] = {Real(1), Real(0), Real(0)}, along_z[] = {Real(0), Real(0), Real(1)};
  for (int i = 0; i < 4; ++i) {
    const Real turn = from_degrees[i] * wide_two_pi() / 360, dx = cos(turn), dz = sin(turn), w = wide_two_pi() / lengths[i];
    const Real phase = w * (dx * p[0] + dz * p[1]) + sqrt(Real("9.81") * w) * p[2], reach = steepness / w;
    const Real sine = sin(phase), cosine = cos(phase);
    place[0] += reach * dx * cosine, place[1] += amplitudes[i] * sine, place[2] += reach * dz * cosine;
    const Real slope[] = {-reach * dx * sine, amplitudes[i] * cosine, -reach * dz * sine};
    for (int c = 0; c < 3; ++c) along_x[c] += w * dx * slope[c], along_z[c] += w * dz * slope[c];
  }
  const int component = static_cast<int>(static_cast<double>(p[3]));
  if (component < 3) return place[component];
  const Real normal[] = {along_z[1] * along_x[2] - along_z[2] * along_x[1], along_z[2] * along_x[0] - along_z[0] * along_x[2],
                         along_z[0] * along_x[1] - along_z[1] * along_x[0]};
  return normal[component - 3] / sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
}

std::vector<double> on_four_waves(SetRandom& r, double reach_m, double reach_s) {
  return {r.uniform(-reach_m, reach_m), r.uniform(-reach_m, reach_m), r.uniform(0, reach_s), std::floor(r.uniform(0, 6))};
}

std::vector<double> along_wave(SetRandom& r, double reach_m, double shortest_m) {
  return {r.uniform(-reach_m, reach_m), r.logarithmic(shortest_m, 20)};
}

std::vector<double> both_ways(SetRandom& r, double least, double most) {
  return {r.logarithmic(least, most), r.logarithmic(0.01, 50), r.logarithmic(0.01, 50), r.uniform(0.66, 1)};
}

// (1 - e^-kd) / k, where k may be 0.
Real wide_in_scatter(std::span<const Real> p) {
  const Real x = p[0] * (1 + p[2] / p[3]) * p[1];
  return x == 0 ? p[1] : Real(p[1] * -expm1(-x) / x);
}

}  // namespace

Formula gerstner_formula() {
  return {{"x", "z", "time", "component"},
          "places lie within 5 km, times from 0 to 100000 s, and components are whole numbers from 0 to 5",
          [](Oracle::Point p) {
            return std::max(std::abs(p[0]), std::abs(p[1])) <= 5000 && p[2] >= 0 && p[2] <= 1e5 && p[3] >= 0 && p[3] <= 5 &&
                   p[3] == std::floor(p[3]);
          },
          gerstner_component,
          of_one,
          {{"near", [](SetRandom& r) { return on_four_waves(r, 20, 60); }},
           {"far", [](SetRandom& r) { return on_four_waves(r, 4999, 60); }},
           {"late", [](SetRandom& r) { return on_four_waves(r, 20, 86400); }}}};
}

Formula wave_phase_formula() {
  return {{"x", "wave_length"},
          "places lie within 100 km, and a wave is 0.1 to 1000 m long",
          [](Oracle::Point p) { return std::abs(p[0]) <= 1e5 && p[1] >= 0.1 && p[1] <= 1000; },
          [](std::span<const Real> p) -> Real { return sin(wide_two_pi() * p[0] / p[1]); },
          of_one,
          {{"near", [](SetRandom& r) { return along_wave(r, 10, 0.5); }},
           {"far", [](SetRandom& r) { return along_wave(r, 5000, 2); }},
           {"very_far", [](SetRandom& r) { return along_wave(r, 99999, 0.5); }}}};
}

Formula water_in_scatter_formula() {
  return {{"extinction", "distance_m", "view_cosine", "sun_cosine"},
          "an extinction must lie from 0 to 100, a distance from 0 to 10000 m, the cosines from 0 and 0.5 to 1",
          [](Oracle::Point p) {
            return p[0] >= 0 && p[0] <= 100 && p[1] >= 0 && p[1] <= 1e4 && p[2] >= 0 && p[2] <= 1 && p[3] >= 0.5 && p[3] <= 1;
          },
          wide_in_scatter,
          of_value,
          {{"everyday",
            [](SetRandom& r) {
              return std::vector{r.logarithmic(1e-3, 1), r.logarithmic(0.01, 50), r.uniform(0, 1), r.uniform(0.66, 1)};
            }},
           {"thin",
            [](SetRandom& r) {
              return std::vector{r.logarithmic(1e-10, 1e-3), r.logarithmic(0.01, 1), r.uniform(0, 1), r.uniform(0.66, 1)};
            }},
           {"endless", [](SetRandom& r) {
              return std::vector{r.logarithmic(1e-2, 1), 1e4, r.uniform(0, 1), r.uniform(0.66, 1)};
            }}}};
}

Formula water_extinction_formula() {
  return {{"extinction", "depth_m", "way_m", "down_cosine"},
          "an extinction must lie from 0 to 100, a depth and a way from 0 to 10000 m, the cosine from 0.5 to 1",
          [](Oracle::Point p) {
            return p[0] >= 0 && p[0] <= 100 && p[1] >= 0 && p[1] <= 1e4 && p[2] >= 0 && p[2] <= 1e4 && p[3] >= 0.5 && p[3] <= 1;
          },
          [](std::span<const Real> p) -> Real { return exp(-p[0] * (p[1] / p[3] + p[2])); },
          of_one,
          {{"everyday", [](SetRandom& r) { return both_ways(r, 1e-3, 1); }},
           {"turbid", [](SetRandom& r) { return both_ways(r, 1, 100); }},
           {"clear", [](SetRandom& r) { return both_ways(r, 1e-10, 1e-3); }}}};
}

Formula rgbm8_formula() {
  return {{"light"},
          "light must lie from 0 to 6",
          [](Oracle::Point p) { return p[0] >= 0 && p[0] <= 6; },
          [](std::span<const Real> p) -> Real { return p[0]; },
          of_value,
          {{"everyday", [](SetRandom& r) { return std::vector{r.logarithmic(3e-3, 5.99)}; }},
           {"dark", [](SetRandom& r) { return std::vector{r.logarithmic(1e-4, 3e-3)}; }}}};
}

Formula refraction_way_formula() {
  return {{"view_cosine", "depth_m", "index"},
          "a cosine must lie from 0.001 to 1, a depth from 0 to 1000 m, an index from 1.05 to 2",
          [](Oracle::Point p) { return p[0] >= 1e-3 && p[0] <= 1 && p[1] >= 0 && p[1] <= 1000 && p[2] >= 1.05 && p[2] <= 2; },
          [](std::span<const Real> p) -> Real {
            const Real sine = sqrt(1 - p[0] * p[0]) / p[2];
            return p[1] * sine / sqrt(1 - sine * sine);
          },
          of_value,
          {{"everyday",
            [](SetRandom& r) {
              return std::vector{std::cos(r.uniform(0.02, 1.48)), r.logarithmic(0.1, 10), 1.333};
            }},
           {"grazing", [](SetRandom& r) {
              return std::vector{std::cos(r.uniform(1.48, 1.569)), r.logarithmic(0.1, 10), 1.333};
            }}}};
}

}  // namespace lamina
