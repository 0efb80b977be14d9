// SPDX-License-Identifier: Apache-2.0
// How lights meet the surfaces that rays find, in doubles: the formulas of variants/transparency/README.md.
#pragma once

#include <map>

#include "harness/effects/transparency/layer_rays.h"
#include "harness/truth/filtered_texture.h"

namespace lamina {

class LayerShading {
 public:
  // The scene outlives this.
  explicit LayerShading(const Scene& scene);

  struct Layer {
    glm::dvec3 color{0};  // linear, not multiplied by the opacity
    double opacity = 0;   // 0 to 1
  };
  // Of a transparent surface, seen from `eye`.
  Layer layer(const LayerHit& hit, glm::dvec3 eye) const;
  // Of an opaque one that plain diffuse light lights; none where another effect draws it.
  std::optional<glm::dvec3> opaque(const LayerHit& hit, glm::dvec3 eye) const;
  // What a ray shows that meets nothing opaque; none where an effect of the whole scene may change it.
  std::optional<glm::dvec3> background() const;

 private:
  struct MetLight {
    glm::dvec3 diffuse, specular;
  };
  MetLight met_light(glm::dvec3 position, glm::dvec3 normal, glm::dvec3 eye, double gloss) const;

  const Scene& scene_;
  std::map<std::pair<size_t, std::string>, FilteredTexture> textures_;  // by object and effect
};

}  // namespace lamina
