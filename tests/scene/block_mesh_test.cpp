// SPDX-License-Identifier: Apache-2.0
// Surfaces of blocks against their volumes and areas.
#include "harness/scene/made/block_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "harness/scene/mesh/unwrap_check.h"
#include "tests/scene/rays.h"

namespace lamina {
namespace {

double area(const Mesh& mesh) {
  double sum = 0;
  const auto place = [&](size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[i]].position); };
  for (size_t i = 0; i < mesh.indices.size(); i += 3)
    sum += glm::length(glm::cross(place(i + 1) - place(i), place(i + 2) - place(i))) / 2;
  return sum;
}

TEST(BlockMesh, OneBox) {
  const Mesh mesh = block_mesh({{{-1, 0, 2}, {1, 3, 2.5f}}}, 10);
  EXPECT_EQ(mesh.vertices.size(), 24u);
  EXPECT_EQ(mesh.indices.size(), 36u);
  EXPECT_NEAR(enclosed_volume(mesh), 3.0, 1e-6);
  EXPECT_NEAR(area(mesh), 17.0, 1e-5);
  for (const Vertex& v : mesh.vertices) {
    // Out of the box: a step along the normal leaves it.
    const glm::vec3 p = v.position + 0.01f * v.normal;
    EXPECT_TRUE(p.x < -1 || p.x > 1 || p.y < 0 || p.y > 3 || p.z < 2 || p.z > 2.5f);
  }
}

TEST(BlockMesh, OverlapsCountOnceAndHolesGoThrough) {
  EXPECT_NEAR(enclosed_volume(block_mesh({{{0, 0, 0}, {2, 1, 1}}, {{1, 0, 0}, {3, 1, 1}}}, 0.3f)), 3.0, 1e-5);
  const Mesh ring = block_mesh({{{0, 0, 0}, {3, 3, 1}}, {{1, 1, -1}, {2, 2, 2}, false}}, 0.3f);
  EXPECT_NEAR(enclosed_volume(ring), 8.0, 1e-5);
  EXPECT_NEAR(area(ring), 2 * 8 + 4 * 3 + 4 * 1, 1e-4) << "no face between what is empty on both sides";
}

TEST(BlockMesh, NoEdgeIsLongerThanTheSpacingAllows) {
  const Mesh mesh = block_mesh({{{0, 0, 0}, {1, 0.55f, 0.2f}}}, 0.1f);
  float longest = 0;
  for (size_t i = 0; i < mesh.indices.size(); ++i) {
    const size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const glm::vec3 edge = mesh.vertices[mesh.indices[next]].position - mesh.vertices[mesh.indices[i]].position;
    longest = std::max({longest, std::abs(edge.x), std::abs(edge.y), std::abs(edge.z)});
  }
  EXPECT_LE(longest, 0.1001f);
  EXPECT_EQ(mesh.indices.size() / 6, 2u * (10 * 6 + 10 * 2 + 6 * 2)) << "and no shorter than it asks";
}

TEST(BlockMesh, TheUnwrapIsUniqueAtOneScale) {
  const Mesh mesh = block_mesh({{{0, 0, 0}, {3, 3, 1}}, {{1, 1, -1}, {2, 2, 2}, false}}, 0.3f);
  EXPECT_EQ(unwrap_problem(mesh), "");
  EXPECT_EQ(overlap_fraction(mesh), 0.0);
  double low = INFINITY, high = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]];
    const double scale = glm::distance(a.uv, b.uv) / glm::distance(a.position, b.position);
    low = std::min(low, scale), high = std::max(high, scale);
  }
  EXPECT_NEAR(low, high, 1e-3 * high);
}

TEST(BlockMesh, TangentsAreTheUnwrapsDerivatives) {
  const Mesh mesh = block_mesh({{{0, 0, 0}, {1, 2, 3}}}, 0.7f);
  for (size_t i = 0; i < mesh.indices.size(); ++i) {
    const size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[next]];
    const glm::vec3 tangent(a.tangent), bitangent = a.tangent.w * glm::cross(a.normal, tangent);
    const glm::vec2 uv = b.uv - a.uv;
    const glm::vec3 edge = b.position - a.position;
    const float scale = glm::length(uv) / glm::length(edge);
    EXPECT_LT(glm::distance(tangent * uv.x + bitangent * uv.y, scale * edge), 1e-5f);
  }
}

TEST(AddPart, MovesAndPutsTheUnwrapIntoItsCell) {
  const Mesh box = block_mesh({{{0, 0, 0}, {1, 1, 1}}}, 2);
  Mesh mesh;
  add_part(mesh, box, glm::mat4(1), {0, 0}, {2, 1});
  const glm::mat4 turned = glm::rotate(glm::translate(glm::mat4(1), {5, 0, 0}), glm::radians(90.0f), {0, 1, 0});
  add_part(mesh, box, turned, {1, 0}, {2, 1});
  EXPECT_EQ(mesh.vertices.size(), 48u);
  EXPECT_NEAR(enclosed_volume(mesh), 2.0, 1e-5);
  EXPECT_EQ(overlap_fraction(mesh), 0.0);
  for (size_t i = 0; i < 24; ++i) {
    EXPECT_LE(mesh.vertices[i].uv.x, 0.5f);
    EXPECT_GE(mesh.vertices[24 + i].uv.x, 0.5f);
    // A quarter turn about y takes x to -z.
    const glm::vec3 n = mesh.vertices[i].normal;
    EXPECT_LT(glm::distance(mesh.vertices[24 + i].normal, glm::vec3(n.z, n.y, -n.x)), 1e-5f);
  }
}

}  // namespace
}  // namespace lamina
