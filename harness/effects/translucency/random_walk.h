// SPDX-License-Identifier: Apache-2.0
// A random walk of light in an object: exponential free paths, scattering by Henyey and Greenstein's law, Fresnel reflection
// and refraction at its surface. All three channels follow one path, which is weighed for each (Wilkie and others, "Hero
// Wavelength Spectral Sampling", EGSR 2014).
#pragma once

#include <functional>
#include <random>

#include "harness/effects/translucency/light_path.h"

namespace lamina {

class WalkRandom {
 public:
  explicit WalkRandom(uint64_t seed) : engine_(seed) {}
  double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }  // 0 and 1 left out
  glm::dvec3 direction();
  // Turned from `from` (unit) by an angle of mean cosine `forward`, -1 to 1 without the ends; 0: any direction.
  glm::dvec3 scattered(glm::dvec3 from, double forward);

 private:
  std::mt19937_64 engine_;
};

struct WalkEnd {
  bool left = false;       // else it died inside, or the mesh was open
  glm::dvec3 position{0};  // where it left
  glm::dvec3 weight{0};
};

// `at_event(position, weight, order)` is told of each scattering, from order 1 on, with what it leaves of the light. `forward`:
// the mean cosine of scattering.
WalkEnd random_walk(const Solids& solids, size_t object, glm::dvec3 albedo, glm::dvec3 start, glm::dvec3 direction,
                    WalkRandom& random, const std::function<void(glm::dvec3, glm::dvec3, int)>& at_event, double forward = 0);

}  // namespace lamina
