// SPDX-License-Identifier: Apache-2.0
// A sky that the frame, mirrors and rays all see alike: half a sphere of plain surface, lit from all around alone, and the same
// colours as a ramp for what rays see beyond a picture.
#pragma once

#include <glm/glm.hpp>

#include "harness/scene/scene.h"

namespace lamina {

// Linear light, each channel at most the scene's ambient.
struct SkyColours {
  glm::vec3 horizon, middle, zenith;
};

// At the square root of the sine of the height over the horizon, 0 to 1.
glm::vec3 sky_colour(const SkyColours& sky, float root);

// Adds the object "sky", whose horizon lies at y = `low_m`, and tells the scene's water of it. Call it after scene.ambient is
// set.
void add_sky_dome(Scene& scene, const SkyColours& sky, float radius_m, float low_m);

}  // namespace lamina
