// SPDX-License-Identifier: Apache-2.0
// Skin in a furnace: light from everywhere, of which no surface may send back more than comes.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/effects/skin_scenes.h"
#include "tests/graph/each_backend.h"

namespace lamina {
namespace {

using std::numbers::pi;

// Squares in the plane z = 0, each with a normal of its own: rows at an angle to the eye, columns around it. Lights stand in
// one half plane around the eye's ray, so that columns see them from all sides; a column stands for its mirror image too.
constexpr double furnace_degrees[] = {0, 15, 30, 45, 60, 70, 75, 80};
constexpr int furnace_rows = 8, furnace_columns = 16, furnace_lights = 8;

Mesh turned_squares() {
  Mesh mesh;
  for (int row = 0; row < furnace_rows; ++row)
    for (int column = 0; column < furnace_columns; ++column) {
      const double t = furnace_degrees[row] * pi / 180, turn = pi * (column + 0.5) / furnace_columns;
      const glm::vec3 normal(std::sin(t) * std::cos(turn), std::sin(t) * std::sin(turn), std::cos(t));
      const glm::vec3 tangent = glm::normalize(glm::vec3(normal.z, 0, -normal.x));
      const auto first = static_cast<uint32_t>(mesh.vertices.size());
      for (const glm::vec2 at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        const glm::vec2 uv = (glm::vec2(column, row) + at) / glm::vec2(furnace_columns, furnace_rows);
        mesh.vertices.push_back({{0.06f * (uv.x - 0.5f), 0.03f * (0.5f - uv.y), 0}, normal, glm::vec4(tangent, -1), uv});
      }
      for (const uint32_t corner : {0u, 2u, 1u, 0u, 3u, 2u}) mesh.indices.push_back(first + corner);
    }
  return mesh;
}

// The profile is narrower than anything, so that squares keep their light.
Scene furnace(glm::vec3 albedo, SkinNumbers numbers) {
  for (int i = 1; i <= 6; ++i) numbers["skin.sigma_" + std::to_string(i)] = 1e-4 * i;
  std::vector<Object> objects;
  objects.push_back(skin_object("squares", turned_squares(), albedo, numbers));
  Scene scene = skin_scene(std::move(objects), {}, glm::vec3(0));
  View& view = scene.views[0];
  view.eye = {0, 0, 20};
  view.fov_y_degrees = glm::degrees(2 * std::atan(0.015f / 20));
  view.near_m = 19, view.far_m = 21;
  return scene;
}

class SkinFurnace : public EachBackend {
 protected:
  // What each row sends to the eye of light of radiance 1 / pi from all of the hemisphere, in red.
  std::vector<double> sent_back(Scene scene, const std::string& name, int frames) {
    std::vector<double> sums(furnace_rows);
    const int lights = frames * furnace_lights;
    for (int frame = 0; frame < frames; ++frame) {
      scene.lights.clear();
      for (int i = 0; i < furnace_lights; ++i) {
        const double from_eye = pi * (frame + frames * i + 0.5) / lights;
        scene.lights.push_back(directional_light("lamp_" + std::to_string(i), {std::sin(from_eye), 0, std::cos(from_eye)},
                                                 glm::vec3(float(2 * std::sin(from_eye) * pi / lights))));
      }
      Parameters parameters;
      if (variant(name).parameter("map_texels")) parameters = {{name + ".map_texels", 64}, {name + ".precision", 1}};
      const Image image = DrawnFrame(*backend_, library(), scene,
                                     {.variant = &variant(name), .width = 32, .height = 16, .parameters = parameters})
                              .picture();
      for (int row = 0; row < furnace_rows; ++row)
        for (int column = 0; column < furnace_columns; ++column)
          sums[size_t(row)] += double(pixel(image, 2 * column + 1, 2 * row + 1).r) / furnace_columns;
    }
    return sums;
  }
};

TEST_P(SkinFurnace, ADiffuseSurfaceSendsBackItsAlbedo) {
  for (const char* name : {"plain_lambert", "six_gaussians"})
    for (const double share : sent_back(furnace(glm::vec3(1), {{"skin.specular", 0}}), name, 2))
      EXPECT_NEAR(share, 1, 0.01) << name;
}

// Kelemen and Szirmay-Kalos' reflection alone: the table of albedos, over pi.
TEST_P(SkinFurnace, TheHighlightSendsBackItsAlbedo) {
  const std::vector<double> found = sent_back(furnace(glm::vec3(0), {{"skin.specular", 1}}), "plain_lambert", 4);
  EXPECT_NEAR(found[0], .0801 / pi, 0.03 * .0801 / pi);
  EXPECT_NEAR(found[3], .0899 / pi, 0.03 * .0899 / pi);
  EXPECT_NEAR(found[4], .1478 / pi, 0.03 * .1478 / pi);
  EXPECT_NEAR(found[6], .3712 / pi, 0.03 * .3712 / pi);
}

// The highlight alone, and over white skin: what it takes is not diffused. Models that are not the table's own may be off by
// 1%.
TEST_P(SkinFurnace, NoModelSendsBackMoreThanComes) {
  for (const char* name : {"six_gaussians", "plain_lambert", "four_lobes", "four_lobes_unnormalised", "four_lobes_half",
                           "blinn_phong_pair", "cook_torrance", "ggx_pair"}) {
    const SkinNumbers said = {{"skin.specular", 1}, {"skin.roughness", 0.5}};
    const std::vector<double> highlight = sent_back(furnace(glm::vec3(0), said), name, 2),
                              whole = sent_back(furnace(glm::vec3(1), said), name, 2);
    for (size_t row = 0; row < furnace_rows; ++row) {
      EXPECT_GT(highlight[row], 0.005) << name << " " << furnace_degrees[row];
      EXPECT_LE(highlight[row], 1) << name << " " << furnace_degrees[row];
      EXPECT_GT(whole[row], 0.8) << name << " " << furnace_degrees[row];
      EXPECT_LE(whole[row], 1.01) << name << " " << furnace_degrees[row];
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, SkinFurnace, api_parameters, backend_test_name);

}  // namespace
}  // namespace lamina
