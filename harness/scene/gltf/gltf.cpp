// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <set>

#include "harness/core/error.h"
#include "harness/scene/gltf/gltf_file.h"
#include "harness/scene/gltf/gltf_material.h"
#include "harness/scene/gltf/gltf_mesh.h"
#include "harness/scene/mesh/unwrap_check.h"
#include "harness/scene/mesh/vertex_colours.h"

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
  bool moves = false;  // the animation places it, or a node above it
};

// Every node of the shown scene with its place, parents first. glTF demands a tree: a node met twice is refused.
std::vector<PlacedNode> placed_nodes(const tinygltf::Model& model, const std::set<int>& animated, const std::string& file) {
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
  const auto place = [&](int node, const glm::dmat4& world_from_parent, bool parent_moves, const std::string& by) {
    if (node < 0 || size_t(node) >= model.nodes.size())
      refuse_gltf(by, fmt::format("refers to node {}; the file has {}", node, model.nodes.size()));
    if (!met.insert(node).second) refuse_gltf(node_label(model, node), "is reached twice; nodes must form a tree");
    const glm::dmat4 world_from_node = world_from_parent * parent_from_node(model.nodes[size_t(node)], node_label(model, node));
    placed.push_back({node, world_from_node, parent_moves || animated.contains(node)});
  };
  for (const int root : roots) place(root, glm::dmat4(1), false, file);
  for (size_t i = 0; i < placed.size(); ++i)
    for (const int child : model.nodes[size_t(placed[i].node)].children)
      place(child, glm::dmat4(placed[i].world_from_node), placed[i].moves, node_label(model, placed[i].node));
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

// Each joint's place over its place when the skin was bound (glTF 2.0, section 3.7.3.1).
std::vector<glm::dmat4> world_from_bind(const tinygltf::Model& model, int skin_index, const std::map<int, PlacedNode>& places,
                                        const std::string& by) {
  if (size_t(skin_index) >= model.skins.size())
    refuse_gltf(by, fmt::format("refers to skin {}; the file has {}", skin_index, model.skins.size()));
  const tinygltf::Skin& skin = model.skins[size_t(skin_index)];
  const std::string subject = fmt::format("skin {}", skin_index);
  std::vector<double> inverse_bind;
  if (skin.inverseBindMatrices >= 0) {
    inverse_bind = read_accessor(model, skin.inverseBindMatrices, 16, subject + ", inverseBindMatrices");
    if (inverse_bind.size() < 16 * skin.joints.size())
      refuse_gltf(subject,
                  fmt::format("has {} inverseBindMatrices for {} joints", inverse_bind.size() / 16, skin.joints.size()));
  }
  std::vector<glm::dmat4> matrices;
  for (size_t i = 0; i < skin.joints.size(); ++i) {
    glm::dmat4 bind(1);
    for (size_t k = 0; k < 16 && !inverse_bind.empty(); ++k) bind[int(k / 4)][int(k % 4)] = inverse_bind[16 * i + k];
    const auto place = places.find(skin.joints[i]);
    if (place == places.end()) refuse_gltf(subject, fmt::format("joint {} is no node of the shown scene", skin.joints[i]));
    matrices.push_back(place->second.world_from_node * bind);
  }
  return matrices;
}

class ObjectMaker {
 public:
  ObjectMaker(const tinygltf::Model& model, LoadedModel& result) : model_(model), result_(result) {}

  void add_mesh(int mesh_index, const std::string& node_name, const std::string& by, const Placement& place, PrimitiveUse use) {
    if (size_t(mesh_index) >= model_.meshes.size())
      refuse_gltf(by, fmt::format("refers to mesh {}; the file has {}", mesh_index, model_.meshes.size()));
    const tinygltf::Mesh& mesh = model_.meshes[size_t(mesh_index)];
    use.name = mesh.name.empty() ? fmt::format("mesh {}", mesh_index) : mesh.name;
    use.mirrored = place.mirrored;
    if (use.morph_weights.empty()) use.morph_weights = mesh.weights;
    const std::string base = node_name.empty() ? use.name : node_name;
    for (size_t i = 0; i < mesh.primitives.size(); ++i) {
      const tinygltf::Primitive& primitive = mesh.primitives[i];
      const Material& material = material_of(primitive.material);
      use.uv_set = material.asks.uv_set, use.texture_from_uv = material.asks.texture_from_uv;
      use.double_sided = material.asks.double_sided;
      std::optional<GltfMesh> triangles = mesh_from_primitive(model_, primitive, use, result_.warnings);
      if (!triangles) continue;
      Object object;
      object.name = unique(mesh.primitives.size() == 1 ? base : fmt::format("{}_{}", base, i));
      object.world_from_object = place.world_from_object;
      object.look = look_of(material, *triangles, object.name);
      object.mesh = std::move(triangles->mesh);
      result_.objects.push_back(std::move(object));
    }
  }

 private:
  struct Material {
    GltfMaterial asks;  // its look has moved to the one beside
    std::shared_ptr<const ModelLook> look;
  };

  const Material& material_of(int index) {
    const auto known = materials_.find(index);
    if (known != materials_.end()) return known->second;
    Material material{read_material(model_, index, result_.warnings), nullptr};
    material.look = std::make_shared<const ModelLook>(std::move(material.asks.look));
    return materials_.emplace(index, std::move(material)).first->second;
  }

  // The material's look as it is on this mesh; shared where the mesh adds nothing to it.
  std::shared_ptr<const ModelLook> look_of(const Material& material, GltfMesh& of, const std::string& object) {
    const GltfMaterial& asks = material.asks;
    std::shared_ptr<ModelLook> own;
    const auto changed = [&]() -> ModelLook& {
      if (!own) own = std::make_shared<ModelLook>(*material.look), own->made.clear();
      return *own;
    };
    if (!of.has_uv && asks.textured) {
      changed().base_colour = Texels{1, 1, {asks.factor}};
      changed().normal.reset();
      result_.warnings.push_back(fmt::format("The textures of '{}' are left out: it has no texture coordinates.", object));
    }
    if (!of.colours.empty()) {
      const bool textured = asks.textured && of.has_uv;
      const size_t vertices = of.mesh.vertices.size();
      const std::string why =
          apply_vertex_colours(of.mesh, of.colours, textured, !material.look->opaque && !asks.masked, changed());
      if (!why.empty())
        result_.warnings.push_back(fmt::format("The colours of the vertices of '{}' are not applied: {}.", object, why));
      if (of.mesh.vertices.size() != vertices) of.has_uv = true;  // its own patches
    }
    if (material.look->thickness && share_without_texels(of.mesh) == 1) {
      changed().thickness.reset();
      result_.warnings.push_back(
          fmt::format("The thickness of '{}' in metres is left out: its texture coordinates have no area, and so no texels to "
                      "count it in. It has the thickness of a model that gives none.",
                      object));
    }
    if (own) return own;
    return material.look;
  }

  std::string unique(const std::string& wanted) {
    std::string name = wanted;
    for (int i = 2; !names_.insert(name).second; ++i) name = fmt::format("{}_{}", wanted, i);
    return name;
  }

  const tinygltf::Model& model_;
  LoadedModel& result_;
  std::map<int, Material> materials_;
  std::set<std::string> names_;
};

}  // namespace

LoadedModel load_gltf(const std::filesystem::path& file, std::optional<double> time_s) {
  LoadedModel result;
  const GltfFile read = read_gltf_file(file, time_s, result.warnings);
  const tinygltf::Model& model = read.model;
  ObjectMaker maker(model, result);
  const std::vector<PlacedNode> placed = placed_nodes(model, read.animated.placed, file.string());
  std::map<int, PlacedNode> places;
  for (const PlacedNode& node : placed) places.emplace(node.node, node);
  for (const PlacedNode& node : placed) {
    const tinygltf::Node& from = model.nodes[size_t(node.node)];
    if (from.mesh < 0) continue;
    const std::string label = node_label(model, node.node);
    PrimitiveUse use{.morph_weights = from.weights};
    result.mesh_moves = result.mesh_moves || read.animated.weighted.contains(node.node);
    if (from.skin >= 0) {  // joints place it, its own node does not (section 3.7.3.3)
      use.world_from_bind = world_from_bind(model, from.skin, places, label);
      const bool moves =
          std::ranges::any_of(model.skins[size_t(from.skin)].joints, [&](int joint) { return places.at(joint).moves; });
      result.mesh_moves = result.mesh_moves || moves;
      if (!moves) result.warnings.push_back(fmt::format("The {} is posed by its skin at rest.", label));
      maker.add_mesh(from.mesh, from.name, label, Placement{}, use);
    } else if (const std::optional<Placement> place = placement(node, label, result.warnings)) {
      result.objects_move = result.objects_move || node.moves;
      maker.add_mesh(from.mesh, from.name, label, *place, use);
    }
  }
  if (model.nodes.empty())  // a file of meshes alone
    for (size_t i = 0; i < model.meshes.size(); ++i)
      maker.add_mesh(static_cast<int>(i), "", file.string(), Placement{}, PrimitiveUse{});
  if (result.objects.empty()) refuse_gltf(file.string(), "has no triangles to draw");
  return result;
}

}  // namespace lamina
