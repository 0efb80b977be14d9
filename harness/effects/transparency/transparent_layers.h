// SPDX-License-Identifier: Apache-2.0
// The truth of transparent surfaces: every surface along each pixel's rays, shaded by the same lights, composited in order.
//
// A variant's passes with when = "truth" write seen_behind, four floats a pixel: the frame without transparent surfaces, and
// how many layers the variant keeps, 0 for all. Steps: this variant against the exact compositing of the layers that it keeps
// (reconstruction); those against all layers (layers); the ray through the pixel's middle against many rays (samples).
#pragma once

#include <memory>

#include "harness/truth/truth.h"

namespace lamina {

// As many rays a pixel as the greatest square up to TruthSetting::rays.
std::unique_ptr<Truth> transparent_layers_truth(const TruthSetting& setting);

// Premultiplied light of the first `kept` layers along a ray, 0 for all, and what they let through.
struct LayersLight {
  glm::dvec3 light{0};
  double through = 1;
};
struct PremultipliedLayer {
  glm::dvec3 light{0};
  double opacity = 0;
};
LayersLight composited(const std::vector<PremultipliedLayer>& layers, size_t kept);

}  // namespace lamina
