// SPDX-License-Identifier: Apache-2.0
// Gerstner's waves on the host, in doubles: where the water's surface is, for truths, tests, and whatever floats on it. Written
// apart from the shaders.
// Source: Gerstner, "Theorie der Wellen", 1802, as Finch writes it in "Effective Water Simulation from Physical Models", GPU
// Gems, 2004, chapter 1: P = (g + sum R D cos a, sum A sin a), a = w D.g + f t, w = 2 pi / L, f = sqrt(9.81 w), or, over a
// bottom of depth d, sqrt(9.81 w tanh(w d)). Its text has lost the pi of w, and its normal the products of waves; here the
// normal is the cross product of the tangents.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "harness/scene/effect_values.h"

namespace lamina {

inline constexpr double wave_gravity = 9.81;  // m/s^2
inline constexpr int max_waves = 4;

struct GerstnerWave {
  double amplitude_m = 0, length_m = 1;
  glm::dvec2 from{1, 0};  // unit, (x, z): where the wave comes from
  double reach_m = 0;     // by which points swing to and fro along it
  double depth_m = 0;     // of the water that slows it; 0: deep

  double wave_number() const;  // radians a metre
  double frequency() const;    // radians a second
};

// The depth of the bottom as waves feel it: bilinear in a texture around the world's middle, its edges held.
class BottomMap {
 public:
  BottomMap() = default;  // deep everywhere
  explicit BottomMap(const EffectValues& values);
  // Metres, and the slopes of the depth along x and z, by differences over a texel.
  glm::dvec3 at(glm::dvec2 ground) const;

 private:
  double depth_at(glm::dvec2 ground) const;
  uint32_t width_ = 0, height_ = 0;
  std::vector<double> depth_m_;
  double width_m_ = 1;
};

// A point of the surface, that lies at `ground` (x, z) when there are no waves.
struct WavePoint {
  glm::dvec3 position;          // y is height over the still water
  glm::dvec3 along_x, along_z;  // tangents: its derivatives by the ground's x and z
  glm::dvec2 ground{0};
  glm::dvec3 normal() const;  // unit; of the side that looks up where the surface has not folded
  double jacobian() const;    // the area that a piece of ground covers, seen from above; below 0 where the surface has folded
};

class GerstnerWaves {
 public:
  explicit GerstnerWaves(std::vector<GerstnerWave> waves) : waves_(std::move(waves)) {}
  // Numbers wave_1_amplitude, _length, _direction (degrees from +x towards +z), _steepness (w times reach) and so on, and
  // wave_depth; bottom_depth and bottom_width with the texture bottom, where waves fade. A wave without amplitude is none.
  // Steepnesses whose sum is above 1 are shrunk to it, so that nothing folds.
  explicit GerstnerWaves(const EffectValues& values);

  WavePoint at(glm::dvec2 ground, double time_s) const;
  // The ground whose point stands over (x, z), in `steps` steps; the error shrinks by the sum of steepnesses in each.
  glm::dvec2 ground_under(glm::dvec2 xz, double time_s, int steps = 24) const;
  // Metres over the still water, at (x, z).
  double height_over(glm::dvec2 xz, double time_s) const { return at(ground_under(xz, time_s), time_s).position.y; }
  // By which the mean level lies under the still water's: half the sum of w A R.
  double sinking_m() const;
  const std::vector<GerstnerWave>& waves() const { return waves_; }

 private:
  std::vector<GerstnerWave> waves_;
  BottomMap bottom_;
};

}  // namespace lamina
