// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/mesh/split_overlaps.h"

#include <gtest/gtest.h>

#include "harness/scene/mesh/unwrap_check.h"
#include "tests/builtin_library.h"

namespace lamina {
namespace {

// A square of the unwrap, in a plane of its own.
void add_square(Mesh& mesh, glm::vec2 corner, float side, float z, bool mirrored = false) {
  const auto base = static_cast<uint32_t>(mesh.vertices.size());
  for (const glm::vec2 at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
    mesh.vertices.push_back(
        {{at.x, at.y, z}, {0, 0, 1}, {1, 0, 0, 1}, corner + side * glm::vec2(mirrored ? 1 - at.x : at.x, at.y)});
  for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(base + i);
}

TEST(SplitOverlaps, MirroredHalvesBecomeTwo) {
  Mesh mesh;
  add_square(mesh, {0.1f, 0.1f}, 0.5f, 0);
  add_square(mesh, {0.1f, 0.1f}, 0.5f, 1, true);
  EXPECT_DOUBLE_EQ(overlap_fraction(mesh), 1);
  const std::vector<Mesh> parts = split_overlaps(mesh);
  ASSERT_EQ(parts.size(), 2u);
  for (const Mesh& part : parts) {
    EXPECT_EQ(overlap_fraction(part), 0);
    EXPECT_EQ(part.vertices.size(), 4u);
    EXPECT_EQ(part.indices.size(), 6u);
  }
  EXPECT_EQ(parts[1].vertices[0].position.z, 1);
}

TEST(SplitOverlaps, UniqueUnwrapStaysWhole) {
  Mesh mesh;
  add_square(mesh, {0, 0}, 0.5f, 0);
  add_square(mesh, {0.5f, 0}, 0.5f, 1);  // touches the first
  const std::vector<Mesh> parts = split_overlaps(mesh);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].indices, mesh.indices);
}

TEST(SplitOverlaps, FurtherChartsFillTheFirstPartTheyFit) {
  Mesh mesh;
  add_square(mesh, {0, 0}, 0.4f, 0);
  add_square(mesh, {0, 0}, 0.4f, 1);
  add_square(mesh, {0.5f, 0.5f}, 0.4f, 2);
  const std::vector<Mesh> parts = split_overlaps(mesh);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].vertices.size(), 8u);
  EXPECT_EQ(parts[1].vertices.size(), 4u);
}

TEST(SplitOverlaps, KeepsTogetherWhatIsBeyondTheMostParts) {
  Mesh mesh;
  for (int i = 0; i < 12; ++i) add_square(mesh, {0, 0}, 0.5f, float(i));
  const std::vector<Mesh> parts = split_overlaps(mesh);
  ASSERT_EQ(parts.size(), max_parts);
  EXPECT_EQ(parts.back().vertices.size(), 4u * 5);
}

TEST(SplitOverlaps, ObjectsAreNamedAndSaidOnlyWhenSplit) {
  Object object;
  object.name = "wing";
  object.effects["layered_material"];
  add_square(object.mesh, {0, 0}, 0.5f, 0);
  std::vector<Object> objects = {object};
  std::vector<std::string> warnings;
  OverlapFractions overlaps;
  split_overlapping_objects(objects, builtin_library(), overlaps, warnings);
  EXPECT_EQ(objects.size(), 1u);
  EXPECT_TRUE(warnings.empty());
  add_square(objects[0].mesh, {0, 0}, 0.5f, 1);
  split_overlapping_objects(objects, builtin_library(), overlaps, warnings);
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].name, "wing");
  EXPECT_EQ(objects[1].name, "wing.2");
  EXPECT_EQ(warnings.size(), 1u);
}

}  // namespace
}  // namespace lamina
