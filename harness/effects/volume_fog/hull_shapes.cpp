// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/volume_fog/hull_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "harness/bake/baker.h"
#include "harness/core/text.h"

namespace lamina {
namespace {

struct MeshBounds {
  glm::vec3 low{INFINITY}, high{-INFINITY};
};

MeshBounds bounds_of(const Mesh& mesh) {
  MeshBounds bounds;
  for (const Vertex& vertex : mesh.vertices)
    bounds.low = glm::min(bounds.low, vertex.position), bounds.high = glm::max(bounds.high, vertex.position);
  return bounds;
}

double volume_of(const Mesh& mesh) {
  double six = 0;
  const auto corner = [&](size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[i]].position); };
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) six += glm::dot(corner(i), glm::cross(corner(i + 1), corner(i + 2)));
  return six / 6;
}

// Whether the triangle lies in one of the faces of the bounds.
bool lies_in_face(const Mesh& mesh, size_t first, const MeshBounds& bounds) {
  for (int axis = 0; axis < 3; ++axis)
    for (const float plane : {bounds.low[axis], bounds.high[axis]}) {
      bool all = true;
      for (size_t i = 0; i < 3; ++i)
        all = all && std::abs(mesh.vertices[mesh.indices[first + i]].position[axis] - plane) <=
                         1e-6f * (bounds.high[axis] - bounds.low[axis]);
      if (all) return true;
    }
  return false;
}

class HullShapeBaker : public Baker {
 public:
  explicit HullShapeBaker(const Scene& scene) : scene_(scene) {}

  Baked bake(size_t object, const EffectValues&, const BakeOptions& options) override {
    Baked baked;
    const auto shapes = options.find("shapes");
    if (shapes == options.end() || shapes->second == 0) return baked;
    const Mesh& mesh = scene_.objects[object].mesh;
    const MeshBounds bounds = bounds_of(mesh);
    const glm::vec4 members[] = {glm::vec4(bounds.low, 0), glm::vec4(bounds.high, static_cast<float>(hull_shape(mesh)))};
    std::vector<std::byte>& bytes = baked.buffers["HullShape"];
    bytes.resize(sizeof members);
    std::memcpy(bytes.data(), members, sizeof members);
    return baked;
  }

 private:
  const Scene& scene_;
};

std::string shape_problem(const BakeOptions& options) {
  static const std::vector<std::string> known = {"shapes"};
  for (const auto& [name, value] : options) {
    if (name != known[0]) return unknown_name("key of [bake]", name, known);
    if (value != 0 && value != 1) return "'shapes' of [bake] must be 0 or 1";
  }
  return "";
}

std::vector<BakedName> shape_names(const BakeOptions& options) {
  return options.empty() ? std::vector<BakedName>{} : std::vector<BakedName>{{"HullShape", true}};
}

std::map<std::string, std::string> shape_defines(const BakeOptions&) { return {}; }

std::unique_ptr<Baker> start_shapes(const Scene& scene, BakeTools&) { return std::make_unique<HullShapeBaker>(scene); }

}  // namespace

HullShape hull_shape(const Mesh& mesh) {
  const MeshBounds bounds = bounds_of(mesh);
  const glm::dvec3 size = glm::dvec3(bounds.high) - glm::dvec3(bounds.low), middle = glm::dvec3(bounds.low) + size / 2.0;
  const double box = size.x * size.y * size.z, ellipsoid = box * std::numbers::pi / 6, volume = volume_of(mesh);
  if (!(box > 0)) return HullShape::any;
  bool is_box = std::abs(volume - box) <= 1e-4 * box;
  for (size_t i = 0; i + 2 < mesh.indices.size() && is_box; i += 3) is_box = lies_in_face(mesh, i, bounds);
  if (is_box) return HullShape::box;
  const bool is_ellipsoid = volume >= 0.97 * ellipsoid && std::ranges::all_of(mesh.vertices, [&](const Vertex& vertex) {
                              return std::abs(glm::length((glm::dvec3(vertex.position) - middle) / (size / 2.0)) - 1) <= 1e-4;
                            });
  return is_ellipsoid ? HullShape::ellipsoid : HullShape::any;
}

const BakerCode hull_shape_baker = {shape_problem, shape_names, shape_defines, start_shapes};

}  // namespace lamina
