// SPDX-License-Identifier: Apache-2.0
// Light of a card, in doubles: what the variants shade, computed apart from them. Blinn and Phong's from all lights; Ward's
// along the strand from the two lights that matter most and from the camera. In units where a white diffuse surface that faces
// a light of irradiance 1 shows 1.
#pragma once

#include "harness/effects/hair/card_rays.h"
#include "harness/truth/filtered_texture.h"

namespace lamina {

class HairLight {
 public:
  HairLight(const Scene& scene, size_t object);

  double opacity(const CardHit& hit) const { return albedo_.at(hit.uv, hit.uv_right, hit.uv_down).a; }
  glm::dvec3 light(const CardHit& hit, glm::dvec3 to_eye) const;

 private:
  const Scene& scene_;
  const EffectValues& values_;
  FilteredTexture albedo_, direction_;
  std::vector<size_t> influential_;  // two at most
};

// The two lights whose luminance at the object's middle is greatest, the greater first.
std::vector<size_t> influential_lights(const Scene& scene, const Object& object);

// Ward's reflectance times pi and the light's cosine. l, v: unit, in the strand's frame (x along it, z the normal).
double ward_reflected(glm::dvec3 l, glm::dvec3 v, double along, double across);

}  // namespace lamina
