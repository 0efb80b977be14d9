// SPDX-License-Identifier: Apache-2.0
// The truth of an effect that blurs a picture in place of sending rays through microfacets: glass that shows what is behind it,
// a floor that shows what is mirrored.
#pragma once

#include "harness/truth/scene_surfaces.h"
#include "harness/truth/seen_picture.h"
#include "harness/truth/truth.h"
#include "harness/truth/view_rays.h"

namespace lamina {

// A pixel that shows a surface of the effect.
struct BlurredPixel {
  const SurfaceHit& hit;
  size_t index;     // among those that show one
  int column, row;  // from the top left
  glm::dvec3 eye;   // world
  const ViewRays& rays;
  const SeenPicture& seen;
};
// Its light, linear, where each ray shows what the picture shows in the place that it lands on, and where it shows what it
// lands on, hidden from the picture or not.
struct BlurredLight {
  glm::dvec3 shown{0}, landed{0};
};

// Steps "blur" (the variant's blur against rays that show the picture) and "picture", whose titles name the picture by `named`:
// "the mirror's picture". Empty where no pixel shows a chosen surface. `light` is called on several threads.
TruthAnswer blurred_picture_truth(const Image& picture, const View& view, const SceneSurfaces& surfaces,
                                  const std::string& named, const std::function<BlurredLight(const BlurredPixel&)>& light,
                                  const std::function<void(double)>& progress);

}  // namespace lamina
