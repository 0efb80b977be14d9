// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/default_layers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "harness/core/error.h"
#include "harness/scene/marble.h"

namespace lamina {
namespace {

// The same picture for every material of a size, so each size is made once.
std::shared_ptr<const TextureImage> inner_layer(uint32_t width, uint32_t height) {
  static std::mutex making;
  static std::map<std::pair<uint32_t, uint32_t>, std::shared_ptr<const TextureImage>> made;
  const std::lock_guard lock(making);
  std::shared_ptr<const TextureImage>& layer = made[{width, height}];
  if (!layer) layer = make_texture("inner layer", marble(width, height, 1), TexelMeaning::colour);
  return layer;
}

}  // namespace

LayeredMaterial default_layers(const std::string& name, const Texels& outer, std::shared_ptr<const TextureImage> normal) {
  // At most 1024: the light map is as large as this layer, and the marbling has nothing finer to show.
  const uint32_t width = std::clamp(outer.width, 512u, 1024u), height = std::clamp(outer.height, 512u, 1024u);
  LayeredMaterial layers;
  layers.outer_albedo = make_texture(name + " outer albedo", outer, TexelMeaning::colour);
  layers.outer_normal =
      normal ? std::move(normal) : constant_texture(name + " flat normal", {0.5f, 0.5f, 1.0f, 1.0f}, TexelMeaning::normal);
  layers.inner_albedo = inner_layer(width, height);
  layers.thickness_texels = float(width) / 100;
  return layers;
}

float thickness_in_texels(float thickness, const Mesh& mesh, const TextureImage& texture, const std::string& subject) {
  double texture_area = 0, surface_area = 0;  // both doubled
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                 &c = mesh.vertices[mesh.indices[i + 2]];
    const glm::dvec2 uv_1 = glm::dvec2(b.uv) - glm::dvec2(a.uv), uv_2 = glm::dvec2(c.uv) - glm::dvec2(a.uv);
    texture_area += std::abs(uv_1.x * uv_2.y - uv_2.x * uv_1.y);
    surface_area += glm::length(
        glm::cross(glm::dvec3(b.position) - glm::dvec3(a.position), glm::dvec3(c.position) - glm::dvec3(a.position)));
  }
  if (!(texture_area > 0 && surface_area > 0))
    throw Error(ErrorKind::bad_input, "scene", subject,
                "its texture coordinates cover no area, so a thickness in metres has no length in texels; unwrap the mesh");
  return static_cast<float>(thickness * std::sqrt(texture_area * texture.width * texture.height / surface_area));
}

}  // namespace lamina
