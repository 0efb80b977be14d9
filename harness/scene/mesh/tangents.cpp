// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/mesh/tangents.h"

#include <array>
#include <cmath>

namespace lamina {
namespace {

// Twice the area in texture space below which a triangle has no direction there: a ten-thousandth of a texel of an 8192
// texture.
constexpr double min_uv_area = 1e-12;
// Share of a summed tangent that must lie in the tangent plane; below it, what is left is rounding.
constexpr double min_in_plane = 1e-4;

// What the triangles of one handedness add up to at a vertex.
struct Sums {
  glm::dvec3 along_u{0}, along_v{0};
  bool used = false;
};

glm::vec4 frame(glm::vec3 normal, const Sums& sums) {
  const glm::dvec3 n(normal);
  const glm::dvec3 in_plane = sums.along_u - n * glm::dot(n, sums.along_u);
  const double length = glm::length(in_plane);
  if (!(length > min_in_plane * glm::length(sums.along_u))) return {any_orthogonal(normal), 1.0f};
  const glm::dvec3 tangent = in_plane / length;
  return {glm::vec3(tangent), glm::dot(glm::cross(n, tangent), sums.along_v) < 0 ? -1.0f : 1.0f};
}

}  // namespace

// Duff et al., "Building an Orthonormal Basis, Revisited", Journal of Computer Graphics Techniques 6(1), 2017, listing 3.
glm::vec3 any_orthogonal(glm::vec3 unit) {
  const float sign = std::copysign(1.0f, unit.z);
  const float a = -1.0f / (sign + unit.z);
  return glm::normalize(glm::vec3(1.0f + sign * unit.x * unit.x * a, sign * unit.x * unit.y * a, -sign * unit.x));
}

void compute_tangents(Mesh& mesh) {
  enum Handedness : size_t { positive, negative };
  std::vector<std::array<Sums, 2>> sums(mesh.vertices.size());
  constexpr int no_direction = -1;
  std::vector<int> handedness_of(mesh.indices.size() / 3, no_direction);

  for (size_t triangle = 0; triangle < handedness_of.size(); ++triangle) {
    const uint32_t* corner = &mesh.indices[triangle * 3];
    const Vertex &a = mesh.vertices[corner[0]], &b = mesh.vertices[corner[1]], &c = mesh.vertices[corner[2]];
    const glm::dvec3 edge_1 = glm::dvec3(b.position) - glm::dvec3(a.position),
                     edge_2 = glm::dvec3(c.position) - glm::dvec3(a.position);
    const glm::dvec2 uv_1 = glm::dvec2(b.uv) - glm::dvec2(a.uv), uv_2 = glm::dvec2(c.uv) - glm::dvec2(a.uv);
    const double determinant = uv_1.x * uv_2.y - uv_2.x * uv_1.y;
    if (!(std::abs(determinant) > min_uv_area)) continue;
    const Handedness handedness = determinant > 0 ? positive : negative;
    handedness_of[triangle] = handedness;
    // dP/du and dP/dv times |determinant|, the weight.
    const double sign = determinant > 0 ? 1 : -1;
    const glm::dvec3 along_u = sign * (edge_1 * uv_2.y - edge_2 * uv_1.y), along_v = sign * (edge_2 * uv_1.x - edge_1 * uv_2.x);
    for (int i = 0; i < 3; ++i) {
      Sums& sum = sums[corner[i]][handedness];
      sum.along_u += along_u;
      sum.along_v += along_v;
      sum.used = true;
    }
  }

  // A vertex keeps its place for the handedness it has, the positive one where it has both; the other gets a copy.
  const size_t originals = mesh.vertices.size();
  constexpr uint32_t no_copy = 0xffffffffu;
  std::vector<uint32_t> copy_of(originals, no_copy);
  for (size_t i = 0; i < originals; ++i) {
    const glm::vec3 normal = mesh.vertices[i].normal;
    mesh.vertices[i].tangent = frame(normal, sums[i][sums[i][positive].used ? positive : negative]);
    if (!sums[i][positive].used || !sums[i][negative].used) continue;
    copy_of[i] = static_cast<uint32_t>(mesh.vertices.size());
    Vertex copy = mesh.vertices[i];
    copy.tangent = frame(normal, sums[i][negative]);
    mesh.vertices.push_back(copy);
  }
  for (size_t i = 0; i < mesh.indices.size(); ++i)
    if (handedness_of[i / 3] == negative && copy_of[mesh.indices[i]] != no_copy) mesh.indices[i] = copy_of[mesh.indices[i]];
}

}  // namespace lamina
