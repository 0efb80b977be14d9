// SPDX-License-Identifier: Apache-2.0
// The physical truth of the layered material: a random walk of light through its layers. Layers are thin sheets that let a
// share of the light pass straight, their transparency, and scatter the rest as Lambert's law says; between them lies a medium
// that scatters and absorbs. Nothing refracts or reflects at borders. There are no discs, no N.V and no limit to how often
// light bounces. Written from the physics; shares nothing with shaders, nor with the model's truth but where lights stand.
//
// Lengths are texels of inner_albedo's base level, as in the effect; the layers follow the surface, so that each place has the
// lights of its own frame, and a light that casts is hidden where the mesh is in its way. A layer's normal, its own map's or a
// flat one, counts for the light that comes straight from a light.
#pragma once

#include <memory>

#include "harness/bake/occluders.h"
#include "harness/scene/scene.h"

namespace lamina {

// A place that is looked at.
struct WalkStart {
  glm::dvec2 uv, right, down;  // steps to the neighbouring pixels
  glm::dvec3 to_eye;           // unit, in the tangent frame: dP/du, dP/dv, normal
};
struct WalkedLight {
  glm::dvec3 mean, deviation;  // linear; the standard deviation of the mean
};

class LayerWalk {
 public:
  // Both outlive this. `object` has the layered material. The medium's optical depth between the outer two layers is
  // medium_depth times scattering squared; it goes on as dense to the last layer.
  LayerWalk(const Scene& scene, size_t object, const Occluders& occluders);
  ~LayerWalk();
  // Light towards the eye, by `paths` walks that start over the pixel.
  WalkedLight light(const WalkStart& start, size_t paths, uint64_t seed) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace lamina
