// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/mesh/tangents.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace lamina {
namespace {

// The unit square in the plane z = 0, facing +z, counter-clockwise; uv = `uv_of` of its corners.
template <class UvOf>
Mesh quad(const UvOf& uv_of) {
  Mesh mesh;
  for (const glm::vec2 p : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}})
    mesh.vertices.push_back({glm::vec3(p, 0), {0, 0, 1}, glm::vec4(0), uv_of(p)});
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

void expect_frames(const Mesh& mesh) {
  for (const Vertex& vertex : mesh.vertices) {
    EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0f, 1e-5f);
    EXPECT_NEAR(glm::dot(glm::vec3(vertex.tangent), vertex.normal), 0.0f, 1e-5f);
    EXPECT_TRUE(vertex.tangent.w == 1 || vertex.tangent.w == -1);
  }
}

glm::vec3 bitangent(const Vertex& vertex) { return vertex.tangent.w * glm::cross(vertex.normal, glm::vec3(vertex.tangent)); }

// In all eight ways to lay a square onto its texture along the axes, dP/du and dP/dv are known.
TEST(ComputeTangents, AreTheDerivativesOnAQuadInAllEightUnwraps) {
  for (int variant = 0; variant < 8; ++variant) {
    const bool swap = variant & 1;
    const float u_sign = variant & 2 ? -1.0f : 1.0f, v_sign = variant & 4 ? -1.0f : 1.0f;
    Mesh mesh = quad([&](glm::vec2 p) { return glm::vec2(u_sign * (swap ? p.y : p.x), 0.5f * v_sign * (swap ? p.x : p.y)); });
    compute_tangents(mesh);
    expect_frames(mesh);
    ASSERT_EQ(mesh.vertices.size(), 4u);
    const glm::vec3 along_u = u_sign * (swap ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0));
    const glm::vec3 along_v = v_sign * (swap ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0));
    for (const Vertex& vertex : mesh.vertices) {
      EXPECT_LT(glm::distance(glm::vec3(vertex.tangent), along_u), 1e-5f) << "variant " << variant;
      EXPECT_LT(glm::distance(bitangent(vertex), along_v), 1e-5f) << "variant " << variant;
    }
  }
}

// uv = (atan2(z, x), y) around a cylinder: dP/du goes round it, dP/dv along it. Facets of 3 degrees leave 1.5 degrees of error.
TEST(ComputeTangents, FollowACylinder) {
  constexpr int sides = 120;
  Mesh mesh;
  for (int i = 0; i <= sides; ++i)
    for (const float y : {0.0f, 1.0f}) {
      const float angle = 2 * float(M_PI) * float(i) / sides;
      const glm::vec3 outward(std::cos(angle), 0, std::sin(angle));
      mesh.vertices.push_back({outward + glm::vec3(0, y, 0), outward, glm::vec4(0), {float(i) / sides, y}});
    }
  for (uint32_t i = 0; i < sides; ++i)
    mesh.indices.insert(mesh.indices.end(), {2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 2, 2 * i + 1, 2 * i + 3});
  compute_tangents(mesh);
  expect_frames(mesh);
  for (const Vertex& vertex : mesh.vertices) {
    const glm::vec3 round(-vertex.normal.z, 0, vertex.normal.x);
    EXPECT_GT(glm::dot(glm::vec3(vertex.tangent), round), std::cos(glm::radians(2.0f)));
    EXPECT_GT(glm::dot(bitangent(vertex), glm::vec3(0, 1, 0)), 0.9999f);
  }
}

// Two quads mirrored about x = 0 share the edge's vertices and half of the texture: u = |x|.
TEST(ComputeTangents, SplitsVerticesWhereHandednessDiffers) {
  Mesh mesh;
  for (const float x : {-1.0f, 0.0f, 1.0f})
    for (const float y : {0.0f, 1.0f}) mesh.vertices.push_back({{x, y, 0}, {0, 0, 1}, glm::vec4(0), {std::abs(x), y}});
  mesh.indices = {0, 2, 3, 0, 3, 1, 2, 4, 5, 2, 5, 3};
  compute_tangents(mesh);
  expect_frames(mesh);
  EXPECT_EQ(mesh.vertices.size(), 8u);
  for (size_t i = 0; i < mesh.indices.size(); ++i) {
    const bool left = i < 6;
    const Vertex& vertex = mesh.vertices[mesh.indices[i]];
    EXPECT_LT(glm::distance(glm::vec3(vertex.tangent), glm::vec3(left ? -1 : 1, 0, 0)), 1e-5f) << "corner " << i;
    EXPECT_LT(glm::distance(bitangent(vertex), glm::vec3(0, 1, 0)), 1e-5f) << "corner " << i;
  }
}

TEST(ComputeTangents, DegenerateTextureCoordinatesStillGiveAFrame) {
  Mesh point = quad([](glm::vec2) { return glm::vec2(0.3f, 0.7f); });
  compute_tangents(point);
  expect_frames(point);
  Mesh line = quad([](glm::vec2 p) { return glm::vec2(p.x, p.x); });
  compute_tangents(line);
  expect_frames(line);
  // dP/du along the normal: nothing of it lies in the tangent plane.
  Mesh upright = quad([](glm::vec2 p) { return p; });
  for (Vertex& vertex : upright.vertices) vertex.normal = {1, 0, 0};
  compute_tangents(upright);
  expect_frames(upright);
  Mesh flat = quad([](glm::vec2 p) { return p; });
  for (Vertex& vertex : flat.vertices) vertex.position = glm::vec3(1);
  compute_tangents(flat);
  expect_frames(flat);
}

TEST(AnyOrthogonal, IsUnitAndOrthogonalInEveryDirection) {
  std::mt19937 random(3);
  std::vector<glm::vec3> directions = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, glm::normalize(glm::vec3(1e-4f, 0, -1))};
  std::normal_distribution<float> normal;
  for (int i = 0; i < 1000; ++i)
    directions.push_back(glm::normalize(glm::vec3(normal(random), normal(random), normal(random))));
  for (const glm::vec3 d : directions) {
    EXPECT_NEAR(glm::length(any_orthogonal(d)), 1.0f, 1e-5f);
    EXPECT_NEAR(glm::dot(any_orthogonal(d), d), 0.0f, 2e-5f);
  }
}

}  // namespace
}  // namespace lamina
