// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/tiles.h"

#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/noise.h"
#include "harness/scene/textures.h"

namespace lamina {
namespace {

Texels tiles(glm::uvec2 count, uint32_t seed) {
  constexpr uint32_t side = 512;
  Texels made{side, side, {}};
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const glm::uvec2 cell = glm::uvec2(x, y) * count / side, first = (cell * side + count - 1u) / count;
      Random random(hash_lattice(glm::ivec3(cell, 0), seed));
      const float hue = random.next(), light = 0.25f + 0.55f * random.next();
      const glm::vec3 colour =
          light * (0.35f + 0.65f * glm::clamp(glm::abs(glm::fract(hue + glm::vec3(1, 2.0f / 3, 1.0f / 3)) * 6.0f - 3.0f) - 1.0f,
                                              0.0f, 1.0f));
      const bool joint = x - first.x < 5 || y - first.y < 5;
      made.rgba.emplace_back(joint ? glm::vec3(0.78f, 0.76f, 0.72f) : colour, 1);
    }
  return made;
}

}  // namespace

Object tiled_object(std::string name, Mesh mesh, glm::uvec2 count, uint32_t seed) {
  Object object = coloured_object(std::move(name), std::move(mesh), glm::vec3(1), false);
  object.said.values["albedo"] = {make_texture("tiles", tiles(count, seed), TexelMeaning::colour)};
  return object;
}

Mesh upright_square() {
  Mesh mesh;
  for (const glm::vec2 uv : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
    mesh.vertices.push_back({{uv.x - 0.5f, 0.5f - uv.y, 0}, {0, 0, 1}, {1, 0, 0, -1}, uv});
  mesh.indices = {0, 2, 1, 0, 3, 2};
  return mesh;
}

}  // namespace lamina
