// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/sphere_mesh.h"

#include <array>
#include <cmath>

#include "harness/scene/made/height_field.h"
#include "harness/scene/mesh/tangents.h"

namespace lamina {
namespace {

// Where points stand along a face of the cube from -1 to 1. Both ends are exactly 1, and the two halves exactly each other's
// negatives: two faces that meet run along their seam in opposite directions.
std::vector<float> along_face(uint32_t per_edge) {
  std::vector<float> places(per_edge);
  for (uint32_t i = 0; 2 * i < per_edge; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(per_edge - 1);
    const float place = i == 0 ? 1 : -std::tan(static_cast<float>(M_PI) / 4 * (2.0f * t - 1.0f));
    places[i] = -place, places[per_edge - 1 - i] = place;
  }
  if (per_edge % 2 == 1) places[per_edge / 2] = 0;
  return places;
}

}  // namespace

Mesh sphere_mesh(uint32_t face_points) {
  // What u and v run along; the face looks along cross(v, u), as columns run right and rows run down.
  static constexpr std::array<std::array<glm::vec3, 2>, 6> faces = {{{{{0, 0, -1}, {0, -1, 0}}},
                                                                     {{{0, 0, 1}, {0, -1, 0}}},
                                                                     {{{1, 0, 0}, {0, 0, 1}}},
                                                                     {{{1, 0, 0}, {0, 0, -1}}},
                                                                     {{{1, 0, 0}, {0, -1, 0}}},
                                                                     {{{-1, 0, 0}, {0, -1, 0}}}}};
  constexpr float gap = 0.02f;  // around a chart, as a share of its cell
  const std::vector<float> places = along_face(face_points);
  Mesh mesh;
  for (uint32_t face = 0; face < 6; ++face) {
    const auto [right, down] = faces[face];
    add_grid(mesh, face_points, face_points, [&, u = right, v = down](uint32_t column, uint32_t row) -> Vertex {
      const glm::vec2 t = glm::vec2(column, row) / static_cast<float>(face_points - 1);
      const glm::vec3 out = glm::normalize(glm::cross(v, u) + places[column] * u + places[row] * v);
      const glm::vec2 uv = (glm::vec2(face % 3, face / 3) + gap + (1 - 2 * gap) * t) / glm::vec2(3, 2);
      return {out, out, glm::vec4(0), uv};
    });
  }
  compute_tangents(mesh);
  return mesh;
}

Mesh shell_mesh(float hole, uint32_t face_points) {
  Mesh mesh = sphere_mesh(face_points);
  const Mesh whole = mesh;
  const auto first = static_cast<uint32_t>(whole.vertices.size());
  for (Vertex vertex : whole.vertices) {
    vertex.position *= hole;
    vertex.normal = -vertex.normal;
    vertex.tangent.w = -vertex.tangent.w;
    mesh.vertices.push_back(vertex);
  }
  for (size_t i = 0; i < whole.indices.size(); i += 3)
    for (const size_t corner : {0, 2, 1}) mesh.indices.push_back(first + whole.indices[i + corner]);
  // The outside fills the left half of the unwrap, the inside the right one.
  for (size_t i = 0; i < mesh.vertices.size(); ++i)
    mesh.vertices[i].uv.x = (mesh.vertices[i].uv.x + (i < first ? 0.0f : 1.0f)) / 2;
  return mesh;
}

Mesh bent_disc_mesh(glm::vec3 half_m, float bend_per_m, uint32_t face_points) {
  Mesh mesh = sphere_mesh(face_points);
  for (Vertex& vertex : mesh.vertices) {
    const glm::vec3 normal = vertex.normal / half_m;  // of the scaled sphere
    vertex.position *= half_m;
    const float x = vertex.position.x;
    vertex.position.z += bend_per_m * x * x;
    vertex.normal = glm::normalize(glm::vec3(normal.x - 2 * bend_per_m * x * normal.z, normal.y, normal.z));
  }
  compute_tangents(mesh);
  return mesh;
}

}  // namespace lamina
