// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/hair/strands.h"

#include <cmath>
#include <numeric>

#include "harness/core/error.h"

namespace lamina {
namespace {

uint32_t root_of(std::vector<uint32_t>& parent, uint32_t vertex) {
  while (parent[vertex] != vertex) vertex = parent[vertex] = parent[parent[vertex]];
  return vertex;
}

// dP/dv of a triangle times twice its area in space; 0 where its texture coordinates span nothing.
glm::dvec3 weighed_direction(const Mesh& mesh, const uint32_t* corner) {
  const Vertex &a = mesh.vertices[corner[0]], &b = mesh.vertices[corner[1]], &c = mesh.vertices[corner[2]];
  const glm::dvec3 p1 = glm::dvec3(b.position) - glm::dvec3(a.position), p2 = glm::dvec3(c.position) - glm::dvec3(a.position);
  const glm::dvec2 t1 = glm::dvec2(b.uv) - glm::dvec2(a.uv), t2 = glm::dvec2(c.uv) - glm::dvec2(a.uv);
  const double spanned = t1.x * t2.y - t2.x * t1.y;
  if (spanned == 0) return glm::dvec3(0);
  const glm::dvec3 along = (t1.x * p2 - t2.x * p1) / spanned;
  const double length = glm::length(along);
  return length > 0 ? along / length * glm::length(glm::cross(p1, p2)) : glm::dvec3(0);
}

}  // namespace

Strands strands_of(const Mesh& mesh, const std::string& owner) {
  std::vector<uint32_t> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0u);
  std::vector<glm::dvec3> sums(mesh.vertices.size(), glm::dvec3(0));
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const uint32_t* corner = &mesh.indices[i];
    const glm::dvec3 along = weighed_direction(mesh, corner);
    for (int k = 0; k < 3; ++k) {
      sums[corner[k]] += along;
      // The smaller number is the root, so that cards come in the order of their first vertices.
      const uint32_t a = root_of(parent, corner[0]), b = root_of(parent, corner[k]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  Strands strands;
  strands.card_of.resize(mesh.vertices.size());
  strands.directions.resize(mesh.vertices.size());
  glm::vec3 low(INFINITY), high(-INFINITY);
  for (uint32_t vertex = 0; vertex < mesh.vertices.size(); ++vertex) {
    const uint32_t root = root_of(parent, vertex);
    strands.card_of[vertex] = static_cast<uint32_t>(root == vertex ? strands.cards++ : strands.card_of[root]);
    const double length = glm::length(sums[vertex]);
    if (!(length > 0))
      throw Error(
          ErrorKind::bad_input, "bake", owner,
          fmt::format("has no tangents for hair: around vertex {} texture coordinates give no direction from root to tip; "
                      "unwrap each card with v running along its strands",
                      vertex));
    strands.directions[vertex] = glm::vec3(sums[vertex] / length);
    low = glm::min(low, mesh.vertices[vertex].position), high = glm::max(high, mesh.vertices[vertex].position);
  }
  strands.middle = (low + high) * 0.5f;
  return strands;
}

}  // namespace lamina
