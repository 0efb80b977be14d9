// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/water/waves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lamina {

double GerstnerWave::wave_number() const { return 2 * std::numbers::pi / length_m; }

double GerstnerWave::frequency() const {
  const double w = wave_number();
  return std::sqrt(wave_gravity * w * (depth_m > 0 ? std::tanh(w * depth_m) : 1));
}

glm::dvec3 WavePoint::normal() const { return glm::normalize(glm::cross(along_z, along_x)); }
double WavePoint::jacobian() const { return along_z.z * along_x.x - along_z.x * along_x.z; }

GerstnerWaves::GerstnerWaves(const EffectValues& values) {
  double sum = 0;
  for (int i = 1; i <= most_waves; ++i) {
    const auto number = [&](const char* name) { return values.numbers.find(fmt::format("wave_{}_{}", i, name))->second; };
    if (!(number("amplitude") > 0)) continue;
    const double turn = number("direction") * std::numbers::pi / 180;
    GerstnerWave wave{
        number("amplitude"), number("length"), {std::cos(turn), std::sin(turn)}, 0, values.numbers.find("wave_depth")->second};
    wave.reach_m = number("steepness") / wave.wave_number();
    sum += number("steepness");
    waves_.push_back(wave);
  }
  for (GerstnerWave& wave : waves_) wave.reach_m /= std::max(sum, 1.0);
}

WavePoint GerstnerWaves::at(glm::dvec2 ground, double time_s) const {
  WavePoint point{{ground.x, 0, ground.y}, {1, 0, 0}, {0, 0, 1}};
  for (const GerstnerWave& wave : waves_) {
    const double w = wave.wave_number(), turn = w * glm::dot(wave.from, ground) + wave.frequency() * time_s;
    const double sine = std::sin(turn), cosine = std::cos(turn);
    const glm::dvec2 d = wave.from;
    point.position += glm::dvec3(wave.reach_m * d.x * cosine, wave.amplitude_m * sine, wave.reach_m * d.y * cosine);
    const glm::dvec3 per_turn(-wave.reach_m * d.x * sine, wave.amplitude_m * cosine, -wave.reach_m * d.y * sine);
    point.along_x += w * d.x * per_turn;
    point.along_z += w * d.y * per_turn;
  }
  return point;
}

glm::dvec2 GerstnerWaves::ground_under(glm::dvec2 xz, double time_s, int steps) const {
  glm::dvec2 ground = xz;
  for (int step = 0; step < steps; ++step) {
    const glm::dvec3 p = at(ground, time_s).position;
    ground = xz - (glm::dvec2(p.x, p.z) - ground);
  }
  return ground;
}

double GerstnerWaves::sinking_m() const {
  double sum = 0;
  for (const GerstnerWave& wave : waves_) sum += wave.wave_number() * wave.amplitude_m * wave.reach_m / 2;
  return sum;
}

}  // namespace lamina
