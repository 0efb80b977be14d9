// SPDX-License-Identifier: Apache-2.0
// See sky_dome.h.
#include "harness/scene/made/sky_dome.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/scene/made/coloured_object.h"
#include "harness/scene/made/height_field.h"
#include "harness/scene/textures.h"

namespace lamina {

glm::vec3 sky_colour(const SkyColours& sky, float root) {
  return root < 0.5f ? glm::mix(sky.horizon, sky.middle, 2 * root) : glm::mix(sky.middle, sky.zenith, 2 * root - 1);
}

void add_sky_dome(Scene& scene, const SkyColours& sky, float radius_m, float low_m) {
  // From the east around by the north, and from the horizon up; v runs down the picture. Normals point down, where no sun
  // shines.
  constexpr uint32_t columns = 65, rows = 33, texels = 256;
  Mesh mesh;
  add_grid(mesh, columns, rows, [&](uint32_t column, uint32_t row) {
    const glm::vec2 uv = glm::vec2(column, row) / glm::vec2(columns - 1, rows - 1);
    const float turn = 2 * std::numbers::pi_v<float> * uv.x, root = 1 - uv.y, sine = row == 0 ? 0.9999f : root * root;
    const float out = std::sqrt(1 - sine * sine);
    const glm::vec3 at = radius_m * glm::vec3(out * std::sin(turn), sine, -out * std::cos(turn));
    return Vertex{at + glm::vec3(0, low_m, 0), {0, -1, 0}, {1, 0, 0, 1}, {uv.x, 0.001f + 0.998f * uv.y}};
  });
  // `down`: from the zenith at the top to the horizon; else along the width, from the horizon.
  const auto ramp = [&](bool down, glm::vec3 white) {
    Texels made{down ? 2 : texels, down ? texels : 2, {}};
    for (uint32_t y = 0; y < made.height; ++y)
      for (uint32_t x = 0; x < made.width; ++x) {
        const float at = (static_cast<float>(down ? y : x) + 0.5f) / static_cast<float>(texels);
        made.rgba.emplace_back(sky_colour(sky, down ? 1 - at : at) / white, 1);
      }
    return make_texture("sky", made, TexelMeaning::colour);
  };
  Object dome = coloured_object("sky", std::move(mesh), glm::vec3(1), false);
  dome.said.values["albedo"] = {ramp(true, scene.ambient)};
  scene.objects.push_back(std::move(dome));
  const float brightest = std::max({scene.ambient.r, scene.ambient.g, scene.ambient.b});
  scene.said["water"].values["sky_light"] = {double(brightest)};
  scene.said["water"].values["sky"] = {ramp(false, glm::vec3(brightest))};
}

}  // namespace lamina
