// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/translucency/random_walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lamina {
namespace {

constexpr int max_events = 4096;
constexpr double roulette_below = 0.05;

double mean(glm::dvec3 v) { return (v.x + v.y + v.z) / 3; }

}  // namespace

glm::dvec3 WalkRandom::direction() {
  const double z = 2 * uniform() - 1, angle = 2 * std::numbers::pi * uniform(), r = std::sqrt(std::max(1 - z * z, 0.0));
  return {r * std::cos(angle), r * std::sin(angle), z};
}

// Henyey and Greenstein, Astrophysical Journal 93, 1941; the inverse of their distribution.
glm::dvec3 WalkRandom::scattered(glm::dvec3 from, double forward) {
  if (forward == 0) return direction();
  const double root = (1 - forward * forward) / (1 - forward + 2 * forward * uniform()),
               cosine = std::clamp((1 + forward * forward - root * root) / (2 * forward), -1.0, 1.0),
               sine = std::sqrt(1 - cosine * cosine), angle = 2 * std::numbers::pi * uniform();
  const glm::dvec3 aside = glm::normalize(glm::cross(from, std::abs(from.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  return glm::normalize(from * cosine + (aside * std::cos(angle) + glm::cross(from, aside) * std::sin(angle)) * sine);
}

WalkEnd random_walk(const Solids& solids, size_t object, glm::dvec3 albedo, glm::dvec3 start, glm::dvec3 direction,
                    WalkRandom& random, const std::function<void(glm::dvec3, glm::dvec3, int)>& at_event, double forward) {
  const Medium& medium = *solids.medium(object);
  const double eta = medium.refraction_index, start_off = 1e-6 * solids.radius_m();
  const int hero = std::min(static_cast<int>(3 * random.uniform()), 2);
  // What the path carries and how likely it is, for each channel, over the mean likelihood.
  glm::dvec3 carried(1), likely(1), position = start;
  int order = 0;
  const auto rescale = [&] {
    const double scale = mean(likely);
    if (scale > 0) carried /= scale, likely /= scale;
    return scale > 0;
  };
  for (int event = 0; event < max_events; ++event) {
    const std::optional<SurfaceCrossing> out = solids.way_out(position, direction, object);
    if (!out) return {};
    const double sigma = medium.extinction[hero], free = sigma > 0 ? -std::log(random.uniform()) / sigma : 1e30;
    if (free < out->distance) {
      position += direction * free;
      const glm::dvec3 density = medium.extinction * glm::exp(-medium.extinction * free);
      carried *= albedo * density;
      likely *= density;
      if (!rescale()) return {};
      at_event(position, carried, ++order);
      if (const double left = std::max({carried.r, carried.g, carried.b}); left < roulette_below) {
        const double survives = left / roulette_below;
        if (random.uniform() >= survives) return {};
        carried /= survives;
      }
      direction = random.scattered(direction, forward);
      continue;
    }
    const glm::dvec3 passed = glm::exp(-medium.extinction * out->distance);
    carried *= passed;
    likely *= passed;
    if (!rescale()) return {};
    position += direction * out->distance;
    const double inside = std::clamp(glm::dot(direction, out->normal), 0.0, 1.0);
    const double sine = eta * std::sqrt(1 - inside * inside);
    const double reflected = sine >= 1 ? 1 : fresnel_reflectance(std::sqrt(1 - sine * sine), eta);
    if (random.uniform() >= reflected) return {true, position, carried};
    direction -= out->normal * (2 * glm::dot(direction, out->normal));
    position -= out->normal * start_off;
  }
  return {};
}

}  // namespace lamina
