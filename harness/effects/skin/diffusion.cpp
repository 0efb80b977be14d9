// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/skin/diffusion.h"

#include <cmath>
#include <numbers>
#include <random>

namespace lamina {
namespace {

using std::numbers::pi;

constexpr double reach_in_sigmas = 5;
constexpr double golden = 0.6180339887498949;

double fraction(double x) { return x - std::floor(x); }

glm::dvec2 on_disc(double u, double v) { return std::sqrt(u) * glm::dvec2(std::cos(2 * pi * v), std::sin(2 * pi * v)); }

// Distances from a line of sight, drawn from one channel of the profile, so that on a flat surface every line counts as much.
class Radii {
 public:
  Radii(const DiffusionProfile& profile, int channel) : profile_(profile), channel_(channel) {
    for (size_t i = 0; i < 6; ++i) sum_ += profile.weight[i][channel];
  }
  // u from 0 to 1.
  double at(double u) const {
    size_t i = 0;
    const auto share = [&] { return profile_.weight[i][channel_] / sum_; };
    while (i < 5 && u >= share()) u -= share(), ++i;
    const double within = std::min(u / std::max(share(), 1e-12), 1 - 1e-7);
    return std::sqrt(-2 * profile_.variance[i] * std::log1p(-within));
  }
  double density(double r) const { return profile_.value(r)[channel_] / sum_; }  // mm^-2

 private:
  const DiffusionProfile& profile_;
  int channel_;
  double sum_ = 0;
};

}  // namespace

DiffusedLight diffused_light(const SkinSurface& surface, glm::dvec3 position, glm::dvec3 normal, size_t lines, uint64_t seed) {
  const DiffusionProfile& profile = surface.profile();
  const double reach_mm = reach_in_sigmas * std::sqrt(profile.variance[5]);
  const glm::dvec3 aside =
      glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const std::array<glm::dvec3, 3> axes = {normal, aside, glm::cross(normal, aside)};
  const size_t each = lines / 3, quarter = each / 4;
  const std::array<size_t, 3> count = {each - 2 * quarter, quarter, quarter};
  std::mt19937_64 random(seed);
  const auto next = [&] { return double(random() >> 11) * 0x1p-53; };
  std::vector<SkinHit> hits;
  DiffusedLight sum;
  for (int channel = 0; channel < 3; ++channel) {
    const Radii radii(profile, channel);
    for (size_t a = 0; a < 3; ++a) {
      const double turn = next(), shadow_u = next(), shadow_v = next(), first = next();
      for (size_t k = 0; k < count[a]; ++k) {
        const double r = radii.at((double(k) + first) / double(count[a])), angle = 2 * pi * fraction(turn + golden * double(k));
        const glm::dvec3 off = r * (std::cos(angle) * axes[(a + 1) % 3] + std::sin(angle) * axes[(a + 2) % 3]);
        const double along = std::sqrt(std::max(reach_mm * reach_mm - r * r, 0.0));
        if (along <= 0) continue;
        surface.hits_along(position + off / 1000.0, axes[a], along / 1000, hits);
        // Places of a disc that fill it evenly in any order of k (M. Roberts' R2).
        const glm::dvec2 disc =
            on_disc(fraction(shadow_u + 0.7548776662466927 * double(k)), fraction(shadow_v + 0.5698402909980532 * double(k)));
        for (const SkinHit& hit : hits) {
          const glm::dvec3 apart = (hit.position - position) * 1000.0;
          double density = 0;  // of all lines, mm^-2 of surface
          for (size_t b = 0; b < 3; ++b) {
            const double height = glm::dot(apart, axes[b]);
            density += double(count[b]) * std::abs(glm::dot(hit.flat_normal, axes[b])) *
                       radii.density(std::sqrt(std::max(glm::dot(apart, apart) - height * height, 0.0)));
          }
          if (density <= 0) continue;
          const double light = surface.entering(hit, disc)[channel] * profile.value(glm::length(apart))[channel] / density;
          sum.all[channel] += light;
          if (glm::dot(hit.flat_normal, normal) > 0) sum.same_side[channel] += light;
        }
      }
    }
  }
  return sum;
}

}  // namespace lamina
