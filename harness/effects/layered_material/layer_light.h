// SPDX-License-Identifier: Apache-2.0
// Light on an object's surface by texture coordinates, as a light map holds it, but exact: at any place, from each light apart,
// by doubles. Beyond the charts it is that of the nearest texel that a chart covers. Shares no code with shaders.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "harness/scene/scene.h"
#include "harness/truth/filtered_texture.h"

namespace lamina {

// Irradiance of each light of the scene, in its order. What comes from all around is the scene's ambient light everywhere.
using LightsAt = std::array<glm::dvec3, max_lights>;

// Where texture coordinates lie on the mesh.
struct LayerPlace {
  glm::dvec2 uv;                               // of the place; beyond the charts those of the nearest texel
  glm::dvec3 position, along, across, normal;  // world; an orthonormal frame: dP/du, dP/dv, normal
};
// A light from a place: the unit direction to it, and what it gives there at normal incidence.
struct LightFrom {
  glm::dvec3 direction, irradiance;
};

class LayerLight {
 public:
  // `normals`: tangent-space normals, 1/2 + 1/2 n. The object's charts are sought on a grid of as many texels as this texture
  // has; an object without any covered texel is dark.
  LayerLight(const Scene& scene, const Object& object, const TextureImage& normals);

  LightsAt at(glm::dvec2 uv) const;
  glm::dvec3 at(glm::dvec2 uv, size_t light) const;  // of one light alone
  // Nothing where no texel is covered.
  std::optional<LayerPlace> place(glm::dvec2 uv) const;
  LightFrom from(const LayerPlace& place, size_t light) const;
  // On a surface of this normal, unit, in the place's frame.
  LightsAt lights(const LayerPlace& place, glm::dvec3 tangent_normal) const;
  glm::dvec3 light(const LayerPlace& place, glm::dvec3 tangent_normal, size_t light) const;
  // The unit normal of the normal map's base level.
  glm::dvec3 mapped_normal(glm::dvec2 uv) const;

 private:
  struct Chart {
    glm::dmat2 weights_from_uv;  // of the second and third corner
    glm::dvec2 first_uv;
    std::array<glm::dvec3, 3> position, normal, tangent;  // of the corners, in the world; the last two of any length
    double handedness;                                    // 1, or -1 where the texture is mirrored
  };
  void cover(uint32_t triangle, glm::dvec2 low, glm::dvec2 high);
  void spread();

  const Scene& scene_;
  FilteredTexture normals_;
  int width_, height_;
  std::vector<Chart> charts_;
  std::vector<int32_t> chart_of_;    // by texel: a triangle, or -1
  std::vector<int32_t> nearest_of_;  // by texel: the nearest covered texel, itself where it is covered
};

}  // namespace lamina
