// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <set>

#include "harness/core/error.h"
#include "harness/scene/gltf/gltf_file.h"
#include "harness/scene/gltf/gltf_material.h"
#include "harness/scene/gltf/gltf_mesh.h"

namespace lamina {
namespace {

std::string node_label(const tinygltf::Model& model, int node) {
  const std::string& name = model.nodes[size_t(node)].name;
  return name.empty() ? fmt::format("node {}", node) : fmt::format("node '{}'", name);
}

// A vector of a node's `count` numbers, or `otherwise` where it has none.
std::vector<double> numbers(const std::vector<double>& given, std::vector<double> otherwise, const char* what,
                            const std::string& subject) {
  if (given.empty()) return otherwise;
  if (given.size() != otherwise.size())
    refuse_gltf(subject, fmt::format("{} has {} numbers; it needs {}", what, given.size(), otherwise.size()));
  return given;
}

glm::dmat4 parent_from_node(const tinygltf::Node& node, const std::string& subject) {
  if (!node.matrix.empty()) {
    const std::vector<double> m = numbers(node.matrix, std::vector<double>(16), "matrix", subject);
    glm::dmat4 matrix;
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = m[size_t(i)];  // both are column-major
    return matrix;
  }
  const std::vector<double> t = numbers(node.translation, {0, 0, 0}, "translation", subject);
  const std::vector<double> r = numbers(node.rotation, {0, 0, 0, 1}, "rotation", subject);
  const std::vector<double> s = numbers(node.scale, {1, 1, 1}, "scale", subject);
  const glm::dquat rotation(r[3], r[0], r[1], r[2]);
  if (!(glm::length(rotation) > 0)) refuse_gltf(subject, "rotation is the zero quaternion");
  return glm::translate(glm::dmat4(1), {t[0], t[1], t[2]}) * glm::mat4_cast(glm::normalize(rotation)) *
         glm::scale(glm::dmat4(1), {s[0], s[1], s[2]});
}

struct PlacedNode {
  int node;
  glm::dmat4 world_from_node;
};

// Every node of the shown scene with its place, parents first. glTF demands a tree: a node met twice is refused.
std::vector<PlacedNode> placed_nodes(const tinygltf::Model& model, const std::string& file) {
  std::vector<int> roots;
  if (!model.scenes.empty()) {
    const int shown = std::max(model.defaultScene, 0);
    if (size_t(shown) >= model.scenes.size())
      refuse_gltf(file, fmt::format("shows scene {}; it has {}", shown, model.scenes.size()));
    roots = model.scenes[size_t(shown)].nodes;
  } else {
    std::set<int> children;
    for (const tinygltf::Node& node : model.nodes) children.insert(node.children.begin(), node.children.end());
    for (int i = 0; i < int(model.nodes.size()); ++i)
      if (!children.contains(i)) roots.push_back(i);
  }

  std::vector<PlacedNode> placed;
  std::set<int> met;
  const auto place = [&](int node, const glm::dmat4& world_from_parent, const std::string& by) {
    if (node < 0 || size_t(node) >= model.nodes.size())
      refuse_gltf(by, fmt::format("refers to node {}; the file has {}", node, model.nodes.size()));
    if (!met.insert(node).second) refuse_gltf(node_label(model, node), "is reached twice; nodes must form a tree");
    const glm::dmat4 world_from_node = world_from_parent * parent_from_node(model.nodes[size_t(node)], node_label(model, node));
    placed.push_back({node, world_from_node});
  };
  for (const int root : roots) place(root, glm::dmat4(1), file);
  for (size_t i = 0; i < placed.size(); ++i)
    for (const int child : model.nodes[size_t(placed[i].node)].children)
      place(child, glm::dmat4(placed[i].world_from_node), node_label(model, placed[i].node));
  return placed;
}

// A world matrix as scene.h wants it: one that does not mirror. Where the node's does, the mesh is mirrored in x to make up for
// it.
struct Placement {
  glm::mat4 world_from_object{1};
  bool mirrored = false;
};
std::optional<Placement> placement(const PlacedNode& node, const std::string& label, std::vector<std::string>& warnings) {
  glm::dmat4 matrix = node.world_from_node;
  const double determinant = glm::determinant(glm::dmat3(matrix));
  const bool mirrored = determinant < 0;
  if (mirrored) matrix = matrix * glm::scale(glm::dmat4(1), {-1, 1, 1});
  const glm::mat4 world_from_object(matrix);
  for (int i = 0; i < 16; ++i)
    if (!std::isfinite(world_from_object[i / 4][i % 4]))
      refuse_gltf(label, "its place in the world is not finite; check its matrices");
  if (determinant == 0) {
    warnings.push_back(fmt::format("The {} is scaled to nothing and is left out.", label));
    return std::nullopt;
  }
  return Placement{world_from_object, mirrored};
}

class ObjectMaker {
 public:
  ObjectMaker(const tinygltf::Model& model, LoadedModel& result) : model_(model), result_(result) {}

  void add_mesh(int mesh_index, const std::string& node_name, const std::string& by, const Placement& place) {
    if (size_t(mesh_index) >= model_.meshes.size())
      refuse_gltf(by, fmt::format("refers to mesh {}; the file has {}", mesh_index, model_.meshes.size()));
    const tinygltf::Mesh& mesh = model_.meshes[size_t(mesh_index)];
    const std::string mesh_name = mesh.name.empty() ? fmt::format("mesh {}", mesh_index) : mesh.name;
    const std::string base = node_name.empty() ? mesh_name : node_name;
    for (size_t i = 0; i < mesh.primitives.size(); ++i) {
      const tinygltf::Primitive& primitive = mesh.primitives[i];
      std::optional<Mesh> triangles = mesh_from_primitive(model_, primitive, mesh_name, place.mirrored, result_.warnings);
      if (!triangles) continue;
      Object object;
      object.name = unique(mesh.primitives.size() == 1 ? base : fmt::format("{}_{}", base, i));
      object.mesh = std::move(*triangles);
      object.world_from_object = place.world_from_object;
      object.look = look_of(primitive.material);
      result_.objects.push_back(std::move(object));
    }
  }

 private:
  const std::shared_ptr<const ModelLook>& look_of(int material) {
    std::shared_ptr<const ModelLook>& look = looks_[material];
    if (!look) look = std::make_shared<const ModelLook>(read_material(model_, material, result_.warnings));
    return look;
  }

  std::string unique(const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; !names_.insert(name).second; ++i) name = fmt::format("{}_{}", wanted, i);
    return name;
  }

  const tinygltf::Model& model_;
  LoadedModel& result_;
  std::map<int, std::shared_ptr<const ModelLook>> looks_;
  std::set<std::string> names_;
};

}  // namespace

LoadedModel load_gltf(const std::filesystem::path& file) {
  LoadedModel result;
  const tinygltf::Model model = read_gltf_file(file, result.warnings);
  if (!model.skins.empty() || !model.animations.empty())
    result.warnings.push_back(fmt::format("{}: skins and animations are not applied.", file.string()));
  ObjectMaker maker(model, result);
  for (const PlacedNode& node : placed_nodes(model, file.string())) {
    const tinygltf::Node& from = model.nodes[size_t(node.node)];
    if (from.mesh < 0) continue;
    const std::string label = node_label(model, node.node);
    if (const std::optional<Placement> place = placement(node, label, result.warnings))
      maker.add_mesh(from.mesh, from.name, label, *place);
  }
  if (model.nodes.empty())  // a file of meshes alone
    for (size_t i = 0; i < model.meshes.size(); ++i) maker.add_mesh(static_cast<int>(i), "", file.string(), Placement{});
  if (result.objects.empty()) refuse_gltf(file.string(), "has no triangles to draw");
  return result;
}

}  // namespace lamina
