// SPDX-License-Identifier: Apache-2.0
// Hair's truth against closed forms, what the baker finds in a mesh of cards, and mips that keep their coverage.
#include "harness/effects/hair/hair_truth.h"

#include <gtest/gtest.h>

#include "harness/effects/hair/kept_coverage.h"
#include "harness/effects/hair/strands.h"
#include "harness/scene/made/hair_cards.h"
#include "tests/effects/hair_scenes.h"

namespace lamina {
namespace {

TruthAnswer true_hair(const Scene& scene, int size, size_t rays, glm::vec3 behind) {
  std::map<std::string, Image> targets;
  Image& seen = targets["seen_behind"];
  seen.width = seen.height = size;
  for (int i = 0; i < size * size; ++i) seen.rgba.insert(seen.rgba.end(), {behind.r, behind.g, behind.b, 1});
  const Occluders occluders(scene);
  DiskCache cache("");
  const auto truth = hair_truth({scene, occluders, cache, rays});
  return truth->answer({targets, scene.views[0], {}}, [](double) {});
}

TEST(HairTruth, CardsAreBlendedInOrder) {
  const float stored_front = std::round(0.5f * 255) / 255, stored_back = std::round(0.25f * 255) / 255;
  for (const bool swapped : {false, true}) {
    // The nearer card comes first or last in the mesh.
    std::vector<CardSquare> squares = {{0, -0.6f, 0.6f, {0.25f, 0.1f}, {0.4f, 0.9f}},
                                       {-0.5f, -0.7f, 0.7f, {0.65f, 0.1f}, {0.8f, 0.9f}}};
    if (swapped) std::swap(squares[0], squares[1]);
    Texels texels{8, 1, {}};
    for (int i = 0; i < 8; ++i)
      texels.rgba.push_back(i < 4 ? glm::vec4(1, 0, 0, i == 0 ? 0 : 0.5f) : glm::vec4(0, 1, 0, 0.25f));
    const Scene scene = declared_scene({hair_of(card_squares(squares), texels)});
    const TruthAnswer answer = true_hair(scene, 4, 16, {0, 0, 1});
    ASSERT_EQ(answer.pixels.size(), 16u);
    for (const TruthStep& step : answer.steps)
      for (const glm::vec3& light : step.light) {
        EXPECT_NEAR(light.r, stored_front, 1e-6);
        EXPECT_NEAR(light.g, (1 - stored_front) * stored_back, 1e-6);
        EXPECT_NEAR(light.b, (1 - stored_front) * (1 - stored_back), 1e-6);
      }
  }
}

TEST(HairTruth, WhatIsOpaqueHidesCards) {
  Object wall;
  wall.name = "wall";
  wall.mesh = card_squares({{0.5f, -0.9f, 0.0f}});
  Object hair = hair_of(card_squares({{0, -0.6f, 0.6f, {0.65f, 0.1f}, {0.85f, 0.9f}}}), two_opacities(0, 0.5f));
  const Scene scene = declared_scene({std::move(hair), std::move(wall)});
  const TruthAnswer answer = true_hair(scene, 8, 1, glm::vec3(0));
  EXPECT_EQ(answer.pixels.size(), 32u);
  for (const size_t pixel : answer.pixels) EXPECT_GE(pixel % 8, 4u);
}

TEST(HairTruth, AStrandsEdgeTakesManyRays) {
  // A card covers a quarter of the width of the middle pixel alone.
  Object hair = hair_of(card_squares({{0, 0, 0.25f / 4, {0.65f, 0.1f}, {0.85f, 0.9f}}}), two_opacities(0, 1));
  const TruthAnswer answer = true_hair(declared_scene({std::move(hair)}), 4, 64, glm::vec3(0));
  ASSERT_EQ(answer.pixels.size(), 4u);  // a column
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(answer.steps[0].light[i].r, 0) << "the ray through the middle misses";
    EXPECT_NEAR(answer.steps[1].light[i].r, 0.25, 1e-6);
  }
}

TEST(HairStrands, CardsArePartsAndDirectionsRunFromRootToTip) {
  const Mesh mesh = hair_card_mesh(4);
  const Strands strands = strands_of(mesh, "hair");
  EXPECT_EQ(strands.cards, 20u);
  EXPECT_EQ(mesh.vertices.size(), 20u * 26);
  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
    EXPECT_EQ(strands.card_of[i], i / 26);
    const Vertex& vertex = mesh.vertices[i];
    const glm::vec3 down = glm::cross(vertex.normal, glm::vec3(vertex.tangent)) * vertex.tangent.w;
    EXPECT_GT(glm::dot(strands.directions[i], down), 0.8f) << i;
  }
}

TEST(HairStrands, TheBakerRefusesWhatItCannotBake) {
  const BakerCode& baker = *effect_code().bakers.at("strands");
  EXPECT_EQ(baker.problem({}), "");
  EXPECT_EQ(baker.problem({{"count", 2.0}}), "hair takes no [bake], and so no 'count'");
  Mesh point = card_squares({{}});  // all of its texture is one point
  for (Vertex& vertex : point.vertices) vertex.uv = glm::vec2(0.5f);
  try {
    strands_of(point, "object 'fringe'");
    ADD_FAILURE() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    for (const char* part : {"object 'fringe'", "has no tangents for hair", "vertex 0", "v running along its strands"})
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(HairStrands, MipsKeepTheirCoverage) {
  const auto made = make_texture("strands", strand_textures(glm::vec3(0.2f), hair_card_m).albedo, TexelMeaning::colour);
  const TextureImage kept = with_kept_coverage(*made, 0.5);
  EXPECT_EQ(kept.levels[0], made->levels[0]);
  const double base = alpha_coverage(*made, 0, 0.5);
  for (size_t level = 1; level <= 4; ++level) {
    const double texels = double(kept.levels[level].size()) / 4;
    EXPECT_NEAR(alpha_coverage(kept, level, 0.5), base, 0.02 + 2 / texels) << level;
  }
  // Strands a texel wide, each fourth column, more opaque from row to row: gone from every plain level, where they are half and
  // a quarter as opaque. A quarter of the texels can be kept to the texel: rows above the median, then the upper quarter.
  const auto thin = make_texture(
      "thin", filled(64, [](uint32_t x, uint32_t y) { return glm::vec4(1, 1, 1, x % 4 == 0 ? 0.5f + float(y + 1) / 129 : 0); }),
      TexelMeaning::colour);
  const TextureImage thin_kept = with_kept_coverage(*thin, 0.5);
  EXPECT_EQ(alpha_coverage(*thin, 0, 0.5), 0.25);
  for (size_t level = 1; level <= 4; ++level) {
    EXPECT_EQ(alpha_coverage(*thin, level, 0.5), 0) << level;
    EXPECT_EQ(alpha_coverage(thin_kept, level, 0.5), 0.25) << level;
  }
}

}  // namespace
}  // namespace lamina
