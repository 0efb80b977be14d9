// SPDX-License-Identifier: Apache-2.0
// Hulls made by code, each whole and with one fault put in. A mesh is its corners and the triangles over them.
#include "harness/scene/mesh/hull_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <numbers>

#include "harness/scene/made/sphere_mesh.h"

namespace lamina {
namespace {

Mesh mesh_of(const std::vector<glm::vec3>& corners, std::vector<uint32_t> indices) {
  Mesh mesh;
  for (const glm::vec3 corner : corners) mesh.vertices.push_back({corner, {0, 0, 1}, {1, 0, 0, 1}, {0, 0}});
  mesh.indices = std::move(indices);
  return mesh;
}

Mesh tetrahedron() { return mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}); }

// Every face has four vertices of its own, as a mesh with seams does: 24 in all.
void add_cube(Mesh& mesh, glm::vec3 low) {
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {0.0f, 1.0f}) {
      const auto first = static_cast<uint32_t>(mesh.vertices.size());
      for (const glm::vec2 uv : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        glm::vec3 corner;
        corner[axis] = side, corner[(axis + 1) % 3] = uv.x, corner[(axis + 2) % 3] = uv.y;
        mesh.vertices.push_back({low + corner, {0, 0, 1}, {1, 0, 0, 1}, uv});
      }
      for (const uint32_t i : side > 0 ? std::vector<uint32_t>{0, 1, 2, 0, 2, 3} : std::vector<uint32_t>{0, 2, 1, 0, 3, 2})
        mesh.indices.push_back(first + i);
    }
}
Mesh cube() {
  Mesh mesh;
  add_cube(mesh, glm::vec3(0));
  return mesh;
}

Mesh torus(uint32_t around, uint32_t across) {
  Mesh mesh;
  const auto angle = [](uint32_t i, uint32_t count) { return 2 * std::numbers::pi_v<float> * float(i) / float(count); };
  for (uint32_t i = 0; i < around; ++i)
    for (uint32_t j = 0; j < across; ++j) {
      const float a = angle(i, around), b = angle(j, across), radius = 2 + std::cos(b);
      mesh.vertices.push_back({{radius * std::cos(a), radius * std::sin(a), std::sin(b)}, {}, {}, {}});
      const auto at = [&](uint32_t di, uint32_t dj) { return (i + di) % around * across + (j + dj) % across; };
      for (const uint32_t v : {at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1)}) mesh.indices.push_back(v);
    }
  return mesh;
}

// Rings of latitude between two poles.
Mesh sphere(uint32_t rings, uint32_t around) {
  Mesh mesh;
  for (uint32_t i = 0; i <= rings; ++i)
    for (uint32_t j = 0; j < around; ++j) {
      const float down = std::numbers::pi_v<float> * float(i) / float(rings);
      const float a = 2 * std::numbers::pi_v<float> * float(j) / float(around);
      const float radius = i == 0 || i == rings ? 0 : std::sin(down);
      mesh.vertices.push_back({{radius * std::cos(a), std::cos(down), radius * std::sin(a)}, {}, {}, {}});
    }
  for (uint32_t i = 0; i < rings; ++i)
    for (uint32_t j = 0; j < around; ++j) {
      const auto at = [&](uint32_t di, uint32_t dj) { return (i + di) * around + (j + dj) % around; };
      for (const uint32_t v : {at(0, 0), at(0, 1), at(1, 1), at(0, 0), at(1, 1), at(1, 0)}) mesh.indices.push_back(v);
    }
  return mesh;
}

void remove_triangle(Mesh& mesh, size_t triangle) {
  const auto first = mesh.indices.begin() + static_cast<std::ptrdiff_t>(3 * triangle);
  mesh.indices.erase(first, first + 3);
}
void turn_triangle(Mesh& mesh, size_t triangle) { std::swap(mesh.indices[3 * triangle], mesh.indices[3 * triangle + 1]); }

TEST(HullCheck, ClosedMeshesAreHulls) {
  EXPECT_EQ(hull_problem(tetrahedron()), std::nullopt);
  EXPECT_EQ(hull_problem(cube()), std::nullopt) << "vertices split at seams are one by their place";
  EXPECT_EQ(hull_problem(torus(16, 8)), std::nullopt);
  EXPECT_EQ(hull_problem(sphere(6, 9)), std::nullopt) << "its poles are many vertices at one place";
}

TEST(HullCheck, AHullInsideOutIsAHole) {
  Mesh mesh = cube();
  for (size_t t = 0; t < mesh.indices.size() / 3; ++t) turn_triangle(mesh, t);
  EXPECT_EQ(hull_problem(mesh), std::nullopt);
}

TEST(HullCheck, AMissingFaceIsTold) {
  Mesh mesh = tetrahedron();
  remove_triangle(mesh, 0);  // 0 2 1: the face z = 0
  EXPECT_EQ(hull_problem(mesh), "is open: the edge from (0, 0, 0) to (1, 0, 0) has a face on one side only");
  for (const Mesh& whole : {cube(), torus(16, 8)})
    for (size_t t = 0; t < whole.indices.size() / 3; ++t) {
      Mesh open = whole;
      remove_triangle(open, t);
      const std::string problem = hull_problem(open).value_or("none");
      EXPECT_TRUE(problem.starts_with("is open: ")) << t << ": " << problem;
    }
}

TEST(HullCheck, ATurnedFaceIsTold) {
  Mesh mesh = tetrahedron();
  turn_triangle(mesh, 0);  // now 2 0 1; 0 3 2 runs from 2 to 0 too
  EXPECT_EQ(hull_problem(mesh),
            "has a turned face: two faces run along the edge from (0, 1, 0) to (0, 0, 0) in the same direction");
  for (const Mesh& whole : {cube(), torus(16, 8)})
    for (size_t t = 0; t < whole.indices.size() / 3; ++t) {
      Mesh turned = whole;
      turn_triangle(turned, t);
      const std::string problem = hull_problem(turned).value_or("none");
      EXPECT_TRUE(problem.starts_with("has a turned face: ")) << t << ": " << problem;
    }
}

TEST(HullCheck, PlacesHaveFourDigits) {
  Mesh mesh = mesh_of({{0.123456f, -2, 1e6f}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 2});
  EXPECT_EQ(hull_problem(mesh), "is open: the edge from (0.1235, -2, 1e+06) to (1, 0, 0) has a face on one side only");
}

// Two cubes side by side along a diagonal have four faces on the edge between them.
TEST(HullCheck, HullsMayTouchAtAnEdge) {
  Mesh mesh = cube();
  add_cube(mesh, {1, 1, 0});
  EXPECT_EQ(hull_problem(mesh), std::nullopt);
  Mesh turned = mesh;
  turn_triangle(turned, 2);  // of the face x = 1, its triangle at the edge between (1, 1, 0) and (1, 1, 1)
  turn_triangle(turned, 3);
  const std::string problem = hull_problem(turned).value_or("none");
  EXPECT_TRUE(problem.starts_with("has a turned face: ")) << problem;
  // That edge alone: the cubes without all but the four faces that meet there.
  const Mesh fins =
      mesh_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {0, 1, 2, 0, 1, 3, 0, 1, 4, 1, 0, 5});
  EXPECT_EQ(
      hull_problem(fins),
      "has a turned face: 3 faces run along the edge from (0, 0, 0) to (0, 0, 1) in the same direction, and 1 in the other");
}

TEST(HullCheck, AFaceTooManyIsTold) {
  Mesh mesh = tetrahedron();
  mesh.vertices.push_back({{2, 2, 2}, {}, {}, {}});
  mesh.indices.insert(mesh.indices.begin(), {0, 1, 4});  // a fin on the edge from 0 to 1
  EXPECT_EQ(hull_problem(mesh), "is open: the edge from (0, 0, 0) to (1, 0, 0) has 2 faces that run one way and 1 the other");
}

// The middle of the edge from 1 to 2 is a vertex of one of its faces only.
TEST(HullCheck, AVertexInANeighboursEdgeIsTold) {
  Mesh mesh = tetrahedron();
  mesh.vertices.push_back({{0.5f, 0.5f, 0}, {}, {}, {}});
  mesh.indices = {0, 2, 4, 0, 4, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  EXPECT_EQ(hull_problem(mesh), "is open: the edge from (0, 1, 0) to (0.5, 0.5, 0) has a face on one side only");
  mesh.indices = {0, 2, 4, 0, 4, 1, 0, 1, 3, 0, 3, 2, 1, 4, 3, 4, 2, 3};
  EXPECT_EQ(hull_problem(mesh), std::nullopt);
}

TEST(HullCheck, TrianglesOfEqualCornersDoNotCount) {
  Mesh mesh = tetrahedron();
  mesh.vertices.push_back(mesh.vertices[1]);  // another vertex at the place of 1
  mesh.indices.insert(mesh.indices.end(), {1, 4, 3, 2, 2, 2});
  EXPECT_EQ(hull_problem(mesh), std::nullopt);
  mesh.indices = {1, 4, 3, 2, 2, 2};
  EXPECT_EQ(hull_problem(mesh), "has no triangle of three different corners");
}

TEST(HullCheck, NegativeZeroIsZero) {
  Mesh mesh = tetrahedron();
  mesh.vertices.push_back({{-0.0f, -0.0f, 1}, {}, {}, {}});
  mesh.indices[5] = 4;
  EXPECT_EQ(hull_problem(mesh), std::nullopt);
}

TEST(HullCheck, AnEmptyMeshIsRefused) { EXPECT_EQ(hull_problem(Mesh{}), "has no triangles"); }

// In time of this process, sanitizers included; quadratic time would take minutes.
TEST(HullCheck, AHundredThousandTrianglesAreQuick) {
  Mesh mesh = sphere(225, 224);
  ASSERT_GT(mesh.indices.size() / 3, 100'000u);
  const std::clock_t start = std::clock();
  EXPECT_EQ(hull_problem(mesh), std::nullopt);
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 2.0);
  remove_triangle(mesh, 77'777);
  EXPECT_NE(hull_problem(mesh), std::nullopt);
}

// Six charts with seams between them, whose vertices stand at exactly the same places.
TEST(HullCheck, ACubeSphereIsClosedAtItsSeams) {
  for (const uint32_t points : {2u, 3u, 8u, 25u, 41u}) EXPECT_EQ(hull_problem(sphere_mesh(points)), std::nullopt) << points;
}

}  // namespace
}  // namespace lamina
