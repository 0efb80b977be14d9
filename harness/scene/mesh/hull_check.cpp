// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/mesh/hull_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_map>

namespace lamina {
namespace {

// Spreads 64 bits (the finalizer of Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", 2014): meshes on
// grids have keys that differ in few bits.
uint64_t mixed_bits(uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

using PositionBits = std::array<uint32_t, 3>;
struct HashPosition {
  size_t operator()(const PositionBits& p) const { return mixed_bits(mixed_bits(uint64_t{p[0]} << 32 | p[1]) + p[2]); }
};
struct HashEdge {
  size_t operator()(uint64_t edge) const { return mixed_bits(edge); }
};

// A number for each vertex: the first vertex that stands at its place.
std::vector<uint32_t> places_of(const std::vector<Vertex>& vertices) {
  std::unordered_map<PositionBits, uint32_t, HashPosition> first_at;
  first_at.reserve(vertices.size());
  std::vector<uint32_t> places(vertices.size());
  for (uint32_t v = 0; v < vertices.size(); ++v) {
    const glm::vec3 p = vertices[v].position + 0.0f;  // -0 becomes 0: one place, and one pattern of bits
    places[v] =
        first_at.try_emplace({std::bit_cast<uint32_t>(p.x), std::bit_cast<uint32_t>(p.y), std::bit_cast<uint32_t>(p.z)}, v)
            .first->second;
  }
  return places;
}

// How many faces run along an edge from its lower place to its higher one, and back.
struct Faces {
  uint32_t up = 0, down = 0;
};
using FacesAtEdges = std::unordered_map<uint64_t, Faces, HashEdge>;
uint64_t edge_between(uint32_t a, uint32_t b) { return uint64_t{std::min(a, b)} << 32 | std::max(a, b); }

// Calls visit(from, to) for each edge of each triangle of three different corners.
template <class Visit>
void for_each_edge(const Mesh& mesh, const std::vector<uint32_t>& places, const Visit& visit) {
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const uint32_t a = places[mesh.indices[i]], b = places[mesh.indices[i + 1]], c = places[mesh.indices[i + 2]];
    if (a == b || b == c || c == a) continue;
    visit(a, b), visit(b, c), visit(c, a);
  }
}

FacesAtEdges faces_at_edges(const Mesh& mesh, const std::vector<uint32_t>& places) {
  FacesAtEdges faces;
  faces.reserve(mesh.indices.size() / 2);  // a closed mesh has three edges for two triangles
  for_each_edge(mesh, places, [&](uint32_t from, uint32_t to) {
    Faces& at_edge = faces[edge_between(from, to)];
    ++(from < to ? at_edge.up : at_edge.down);
  });
  return faces;
}

std::string problem_at(glm::vec3 from, glm::vec3 to, uint32_t along, uint32_t against) {
  const std::string edge = fmt::format("the edge from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g})", from.x, from.y,
                                       from.z, to.x, to.y, to.z);
  if (along + against == 1) return fmt::format("is open: {} has a face on one side only", edge);
  // Faces come in pairs where nothing is missing, so an even number means that one is turned.
  if ((along + against) % 2 == 1)
    return fmt::format("is open: {} has {} faces that run one way and {} the other", edge, along, against);
  if (along + against == 2) return fmt::format("has a turned face: two faces run along {} in the same direction", edge);
  return fmt::format("has a turned face: {} faces run along {} in the same direction, and {} in the other", along, edge,
                     against);
}

}  // namespace

std::optional<std::string> hull_problem(const Mesh& mesh) {
  if (mesh.indices.size() < 3) return "has no triangles";
  const std::vector<uint32_t> places = places_of(mesh.vertices);
  const FacesAtEdges faces = faces_at_edges(mesh, places);
  if (faces.empty()) return "has no triangle of three different corners";

  std::optional<std::string> problem;
  for_each_edge(mesh, places, [&](uint32_t from, uint32_t to) {
    const Faces& at_edge = faces.at(edge_between(from, to));
    if (problem || at_edge.up == at_edge.down) return;
    // Told in the direction that more faces run.
    const auto [low, high] = std::minmax(from, to);
    const bool up = at_edge.up > at_edge.down;
    problem = problem_at(mesh.vertices[up ? low : high].position, mesh.vertices[up ? high : low].position,
                         std::max(at_edge.up, at_edge.down), std::min(at_edge.up, at_edge.down));
  });
  return problem;
}

bool has_open_edge(const Mesh& mesh) {
  return std::ranges::any_of(faces_at_edges(mesh, places_of(mesh.vertices)),
                             [](const auto& edge) { return edge.second.up + edge.second.down == 1; });
}

}  // namespace lamina
