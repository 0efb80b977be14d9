// SPDX-License-Identifier: Apache-2.0
// See skin_plate.h.
#include "harness/scene/made/skin_plate.h"

#include <cmath>

#include "harness/scene/default_views.h"
#include "harness/scene/made/directional_light.h"
#include "harness/scene/made/height_field.h"
#include "harness/scene/made/skin_object.h"
#include "harness/scene/mesh/tangents.h"
#include "harness/scene/textures.h"

namespace lamina {
namespace {

constexpr float plate_half_m = 0.020f;
constexpr uint32_t bump_texels = 256, bumps = 16;  // along a side

// A square in the plane z = const that faces +z; v runs down.
Mesh plate_square(float left, float right, float top, float bottom, float z) {
  Mesh mesh;
  add_grid(mesh, 2, 2, [&](uint32_t column, uint32_t row) -> Vertex {
    const glm::vec2 t(column, row);
    return {{left + (right - left) * t.x, top + (bottom - top) * t.y, z}, {0, 0, 1}, glm::vec4(0), t};
  });
  compute_tangents(mesh);
  return mesh;
}

// Egg-box bumps in the upper half, none in the lower one.
Texels bump_normals() {
  Texels normals{bump_texels, bump_texels, {}};
  const float turn = 2 * static_cast<float>(M_PI) * bumps / bump_texels;
  for (uint32_t y = 0; y < bump_texels; ++y)
    for (uint32_t x = 0; x < bump_texels; ++x) {
      const float amount = 0.5f * (1 - glm::smoothstep(0.45f, 0.5f, (static_cast<float>(y) + 0.5f) / bump_texels));
      const glm::vec2 p = turn * (glm::vec2(x, y) + 0.5f);
      const glm::vec3 n =
          glm::normalize(glm::vec3(amount * std::sin(p.x) * std::cos(p.y), amount * std::cos(p.x) * std::sin(p.y), 1));
      normals.rgba.emplace_back(n * 0.5f + 0.5f, 1);
    }
  return normals;
}

}  // namespace

Scene make_skin_plate() {
  Scene scene;
  Object plate = skin_object("plate", plate_square(-plate_half_m, plate_half_m, plate_half_m, -plate_half_m, 0),
                             {0.61f, 0.37f, 0.27f}, {{"skin.penumbra", 1}});
  plate.said.values["skin.normal"] = {make_texture("bumps", bump_normals(), TexelMeaning::normal)};
  scene.objects.push_back(std::move(plate));
  Object edge;
  edge.name = "edge";
  edge.mesh = plate_square(-0.03f, -0.004f, 0.03f, -0.03f, 0.008f);
  edge.said.values["albedo"] = {glm::vec3(0.1f)};
  scene.objects.push_back(std::move(edge));
  scene.lights.push_back(directional_light("lamp", glm::normalize(glm::vec3(-0.5f, 0.3f, 1)), {2.2f, 2.1f, 2.0f}));
  scene.ambient = glm::vec3(0.05f);
  scene.background = glm::vec3(0.02f);
  scene.views = {{"front", {0.012f, 0, 0.09f}, {0.004f, 0, 0}, {0, 1, 0}, 26},
                 {"grazing", {0.05f, -0.01f, 0.018f}, {0, 0, 0}, {0, 0, 1}, 26}};
  const BoundingSphere bounds = bounding_sphere(scene.objects);
  for (View& view : scene.views) fit_depth(view, bounds);
  return scene;
}

}  // namespace lamina
