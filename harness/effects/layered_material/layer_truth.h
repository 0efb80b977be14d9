// SPDX-License-Identifier: Apache-2.0
// The layered material's own truth: the model of variants/layered_material/README.md without its filters. Discs are means of
// many samples, each lit by N.L at its own place; every light is its own ray through every transparency; a pixel is the mean of
// what its footprint covers; there are no mip levels. What remains of a variant's error against it are the variant's filters.
#pragma once

#include <memory>
#include <optional>

#include "harness/truth/truth.h"

namespace lamina {

// Named "layers". The truth passes of a variant give, as targets of four floats:
//   seen_point    world position; the object's place + 1
//   seen_along    world, unit dP/du of the tangent frame; handedness, -1 or 1
//   seen_normal   world, unit, as interpolated
//   seen_uv       texture coordinates; 0, 0
//   seen_steps    their steps to the neighbouring pixels: right, down
//   seen_outer    the outer layer's colour and transparency, as the device filters them
//   seen_mapped   the mapped normal, tangent space, unit, as the device filters it: all that is told bends the eye's ray the
//   same way
// Two steps: first the filters of light and of the layers below, under the outer layer as the device shows it; then that layer
// over the pixel's footprint, without mip levels. Samples a pixel: the setting's rays. Where the scene's word `truth` is "walk"
// two more follow: the model with the eye's ray straight and N.V left out; then the physical truth (layer_walk.h), by four
// walks a sample.
std::unique_ptr<Truth> layer_truth(const TruthSetting& setting);

// One seen place, for tests and for the truth itself.
struct SeenLayers {
  glm::dvec3 position, along, across, normal;  // world; an orthonormal frame: dP/du, dP/dv, normal
  glm::dvec2 uv, right, down;                  // steps to the neighbouring pixels
  // As the device filters them; without them they are means over the pixel's footprint.
  std::optional<glm::dvec4> outer;
  std::optional<glm::dvec3> mapped;
  // The outer normal does not bend the eye's ray, and N.V hides nothing.
  bool straight = false;
};
struct LayeredLight {
  glm::dvec3 under_shown_outer, all;  // linear, after the first step and after both
};
class LayerModel {
 public:
  // The scene outlives this. `object` has the layered material.
  LayerModel(const Scene& scene, size_t object);
  ~LayerModel();
  // Light towards `eye`. `turn`: of the samples, 0 to 1, another for each pixel.
  LayeredLight light(const SeenLayers& seen, glm::dvec3 eye, size_t samples, double turn) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace lamina
