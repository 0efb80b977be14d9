// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/water/waves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/scene/textures.h"

namespace lamina {

double GerstnerWave::wave_number() const { return 2 * std::numbers::pi / length_m; }

double GerstnerWave::frequency() const {
  const double w = wave_number();
  return std::sqrt(wave_gravity * w * (depth_m > 0 ? std::tanh(w * depth_m) : 1));
}

glm::dvec3 WavePoint::normal() const { return glm::normalize(glm::cross(along_z, along_x)); }
double WavePoint::jacobian() const { return along_z.z * along_x.x - along_z.x * along_x.z; }

BottomMap::BottomMap(const EffectValues& values) {
  const auto deepest = values.numbers.find("bottom_depth");
  if (deepest == values.numbers.end() || !(deepest->second > 0)) return;
  const Texels texels = base_texels(*values.textures.find("bottom")->second);
  width_ = texels.width, height_ = texels.height, width_m_ = values.numbers.find("bottom_width")->second;
  for (const glm::vec4& texel : texels.rgba) depth_m_.push_back(deepest->second * double(texel.r));
}

double BottomMap::depth_at(glm::dvec2 ground) const {
  const auto held = [](double texel, uint32_t count) { return std::clamp(texel, 0.0, double(count) - 1); };
  const double x = (ground.x / width_m_ + 0.5) * width_ - 0.5, y = (ground.y / width_m_ + 0.5) * height_ - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  const auto texel = [&](double column, double row) {
    return depth_m_[static_cast<size_t>(held(row, height_)) * width_ + static_cast<size_t>(held(column, width_))];
  };
  return glm::mix(glm::mix(texel(left, top), texel(left + 1, top), x - left),
                  glm::mix(texel(left, top + 1), texel(left + 1, top + 1), x - left), y - top);
}

glm::dvec3 BottomMap::at(glm::dvec2 ground) const {
  if (depth_m_.empty()) return {1e9, 0, 0};
  const double step = width_m_ / width_;
  const glm::dvec2 x(step, 0), z(0, step);
  return {depth_at(ground), (depth_at(ground + x) - depth_at(ground - x)) / (2 * step),
          (depth_at(ground + z) - depth_at(ground - z)) / (2 * step)};
}

GerstnerWaves::GerstnerWaves(const EffectValues& values) : bottom_(values) {
  double sum = 0;
  for (int i = 1; i <= max_waves; ++i) {
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
  WavePoint point{{ground.x, 0, ground.y}, {1, 0, 0}, {0, 0, 1}, ground};
  const glm::dvec3 depth = bottom_.at(ground);
  for (const GerstnerWave& wave : waves_) {
    // What is left of the wave here, and how that changes.
    const double deep = std::clamp(2 * depth.x / wave.length_m, 0.0, 1.0), left = deep * deep * (3 - 2 * deep);
    const glm::dvec2 change = 12 * deep * (1 - deep) / wave.length_m * glm::dvec2(depth.y, depth.z);
    const double w = wave.wave_number(), turn = w * glm::dot(wave.from, ground) + wave.frequency() * time_s;
    const double sine = std::sin(turn), cosine = std::cos(turn);
    const glm::dvec2 d = wave.from;
    const glm::dvec3 moved(wave.reach_m * d.x * cosine, wave.amplitude_m * sine, wave.reach_m * d.y * cosine);
    point.position += left * moved;
    const glm::dvec3 per_turn(-wave.reach_m * d.x * sine, wave.amplitude_m * cosine, -wave.reach_m * d.y * sine);
    point.along_x += left * w * d.x * per_turn + change.x * moved;
    point.along_z += left * w * d.y * per_turn + change.y * moved;
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
