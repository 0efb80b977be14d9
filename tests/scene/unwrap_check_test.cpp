// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/mesh/unwrap_check.h"

#include <gtest/gtest.h>

namespace lamina {
namespace {

// Adds a rectangle of the texture as two triangles that share a diagonal.
void add_rectangle(Mesh& mesh, glm::vec2 low, glm::vec2 high, bool mirrored = false) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  for (const glm::vec2 uv : {low, glm::vec2(high.x, low.y), high, glm::vec2(low.x, high.y)})
    mesh.vertices.push_back({{uv, 0}, {0, 0, 1}, {1, 0, 0, 1}, uv});
  for (const uint32_t i : mirrored ? std::vector<uint32_t>{0, 2, 1, 0, 3, 2} : std::vector<uint32_t>{0, 1, 2, 0, 2, 3})
    mesh.indices.push_back(first + i);
}
Mesh rectangle(glm::vec2 low, glm::vec2 high) {
  Mesh mesh;
  add_rectangle(mesh, low, high);
  return mesh;
}

TEST(MoveToUnitTile, ShiftsByWholeTilesOnly) {
  Mesh mesh = rectangle({-3 + 0.25f, 7 + 0.5f}, {-3 + 0.75f, 7 + 1});
  move_to_unit_tile(mesh);
  EXPECT_EQ(mesh.vertices[0].uv, glm::vec2(0.25f, 0.5f));
  EXPECT_EQ(mesh.vertices[2].uv, glm::vec2(0.75f, 1));
  EXPECT_EQ(unwrap_problem(mesh), "");
}

TEST(MoveToUnitTile, LeavesWhatFitsAndBearsRounding) {
  for (const auto& [low, high] :
       {std::pair{glm::vec2(0), glm::vec2(1)}, {glm::vec2(-0.0005f), glm::vec2(1.0005f)}, {glm::vec2(0.9995f), glm::vec2(1)}}) {
    Mesh mesh = rectangle(low, high);
    move_to_unit_tile(mesh);
    EXPECT_EQ(mesh.vertices[0].uv, low);
    EXPECT_EQ(unwrap_problem(mesh), "");
  }
  Mesh above = rectangle({0.9995f, 1.9996f}, {1.9f, 2.5f});
  move_to_unit_tile(above);
  EXPECT_NEAR(above.vertices[0].uv.x, -0.0005f, 1e-6f);
  EXPECT_NEAR(above.vertices[0].uv.y, -0.0004f, 1e-6f);
  EXPECT_EQ(unwrap_problem(above), "");
}

// Two rectangles of equal size in space; the texture coordinates of the second are shrunk.
Mesh with_shrunk_half(float factor) {
  Mesh mesh;
  add_rectangle(mesh, {0, 0}, {0.5f, 1});
  add_rectangle(mesh, {0.5f, 0}, {1, 1});
  for (size_t i = 4; i < 8; ++i) mesh.vertices[i].uv = glm::vec2(0.75f) + factor * (mesh.vertices[i].uv - glm::vec2(0.75f));
  return mesh;
}

TEST(UnwrapProblem, ASurfaceWithoutTexels) {
  EXPECT_EQ(share_without_texels(with_shrunk_half(1)), 0);
  EXPECT_EQ(share_without_texels(with_shrunk_half(0.1f)), 0) << "a hundredth of the texels is few, not none";
  EXPECT_EQ(unwrap_problem(with_shrunk_half(0.1f)), "");
  for (const float factor : {0.005f, 0.0f}) {
    EXPECT_NEAR(share_without_texels(with_shrunk_half(factor)), 0.5, 1e-6) << factor;
    EXPECT_EQ(unwrap_problem(with_shrunk_half(factor)),
              "texture coordinates have no area on 50% of its surface; unwrap the mesh so that every face has texels");
  }
  Mesh point = rectangle({0, 0}, {1, 1});
  for (Vertex& vertex : point.vertices) vertex.uv = {0.25f, 0.5f};
  EXPECT_EQ(share_without_texels(point), 1);
  EXPECT_EQ(unwrap_problem(point), "it has no texture coordinates, or all of them are one point; unwrap the mesh");
}

TEST(UnwrapProblem, NamesTheTilesThatAreSpanned) {
  EXPECT_NE(unwrap_problem(rectangle({0, 0}, {3, 1})).find("span 3 x 1 tiles"), std::string::npos);
  EXPECT_NE(unwrap_problem(rectangle({0.5f, 0}, {1.25f, 1})).find("cross the border"), std::string::npos);
  Mesh far_tile = rectangle({4.5f, 0}, {5, 1});
  EXPECT_NE(unwrap_problem(far_tile).find("cross the border"), std::string::npos);
  move_to_unit_tile(far_tile);
  EXPECT_EQ(unwrap_problem(far_tile), "");
}

// Neighbours that share an edge or a corner, of either winding, share no texel: the edges run through texels' centres.
TEST(OverlapFraction, NeighboursDoNotOverlap) {
  Mesh mesh;
  const float a = 100.5f / 512, b = 200.5f / 512, c = 300.5f / 512;
  add_rectangle(mesh, {a, a}, {b, b});
  add_rectangle(mesh, {b, a}, {c, b}, true);
  add_rectangle(mesh, {a, b}, {b, c});
  add_rectangle(mesh, {b, b}, {c, c}, true);
  EXPECT_EQ(overlap_fraction(mesh), 0.0);
}

TEST(OverlapFraction, CountsTheShareThatIsUsedTwice) {
  Mesh mesh;
  add_rectangle(mesh, {0, 0}, {0.5f, 1});
  EXPECT_EQ(overlap_fraction(mesh), 0.0);
  add_rectangle(mesh, {0.25f, 0}, {0.75f, 1}, true);
  EXPECT_DOUBLE_EQ(overlap_fraction(mesh), 1.0 / 3);
  add_rectangle(mesh, {0.25f, 0}, {0.5f, 1});
  EXPECT_DOUBLE_EQ(overlap_fraction(mesh), 1.0 / 3) << "three times is still once";
  EXPECT_EQ(overlap_fraction(Mesh{}), 0.0);
}

TEST(OverlapWarning, IsGivenAboveTwoPercent) {
  Object object;
  object.name = "shell";
  add_rectangle(object.mesh, {0, 0}, {1, 1});
  add_rectangle(object.mesh, {0, 0}, {0.125f, 0.125f});  // 1 / 64
  OverlapFractions overlaps;
  EXPECT_EQ(overlap_warning(object, overlaps), "");
  add_rectangle(object.mesh, {0.5f, 0.5f}, {0.75f, 0.75f});  // and 1 / 16: 7.8% together
  EXPECT_EQ(overlap_warning(object, overlaps),
            "7.8% of shell's texture is used twice; a map over its unwrap holds what is true of one use.");
  object.unwrap_problem = "it cannot be unwrapped";
  EXPECT_EQ(overlap_warning(object, overlaps), "") << "it is not used at all";
}

// Meshes of one unwrap in other places share a figure; another unwrap, or other triangles over it, have their own.
TEST(OverlapFractions, AreThoseOfEachUnwrap) {
  Mesh once, twice;
  add_rectangle(once, {0, 0}, {0.5f, 1});
  twice = once;
  twice.indices.insert(twice.indices.end(), once.indices.begin(), once.indices.end());
  Mesh moved = twice, half = twice;
  for (Vertex& vertex : moved.vertices) vertex.position += 3.0f;
  half.indices.resize(half.indices.size() - 3);
  OverlapFractions overlaps;
  for (const Mesh* mesh : {&once, &twice, &moved, &half}) EXPECT_EQ(overlaps.of(*mesh), overlap_fraction(*mesh));
  EXPECT_EQ(overlaps.of(moved), 1);
}

}  // namespace
}  // namespace lamina
