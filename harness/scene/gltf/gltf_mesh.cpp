// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>

#include "harness/core/error.h"
#include "harness/scene/gltf/gltf_file.h"
#include "harness/scene/mesh/hull_check.h"
#include "harness/scene/mesh/tangents.h"

namespace lamina {
namespace {

// The attribute's numbers, all finite; empty where the primitive has no such attribute.
std::vector<double> read_attribute(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                   const std::string& attribute, int components, const std::string& mesh_name) {
  const auto found = primitive.attributes.find(attribute);
  if (found == primitive.attributes.end()) return {};
  const std::string subject = fmt::format("mesh '{}', {}", mesh_name, attribute);
  std::vector<double> values = read_accessor(model, found->second, components, subject);
  for (size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      refuse_gltf(fmt::format("{}, vertex {}", subject, i / size_t(components)), "is not a finite number; repair the model");
  return values;
}

// The triangles' corners as vertex numbers, by glTF 2.0, section 3.7.2.1: strips turn every other triangle round.
std::vector<uint32_t> triangle_corners(const tinygltf::Model& model, const tinygltf::Primitive& primitive, size_t vertices,
                                       const std::string& mesh_name) {
  std::vector<uint32_t> order;
  if (primitive.indices < 0) {
    order.resize(vertices);
    for (size_t i = 0; i < vertices; ++i) order[i] = static_cast<uint32_t>(i);
  } else {
    const std::string subject = fmt::format("mesh '{}', indices", mesh_name);
    for (const double index : read_accessor(model, primitive.indices, 1, subject)) {
      if (!(index >= 0 && index < double(vertices) && index == std::floor(index)))
        refuse_gltf(subject, fmt::format("index {} is out of range; the mesh has {} vertices", index, vertices));
      order.push_back(static_cast<uint32_t>(index));
    }
  }
  if (primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP && primitive.mode != TINYGLTF_MODE_TRIANGLE_FAN) {
    order.resize(order.size() - order.size() % 3);
    return order;
  }
  std::vector<uint32_t> corners;
  const bool fan = primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
  for (size_t i = 0; i + 2 < order.size(); ++i) {
    const uint32_t a = fan ? order[i + 1] : order[i];
    const uint32_t b = fan ? order[i + 2] : order[i + 1 + i % 2];
    const uint32_t c = fan ? order[0] : order[i + 2 - i % 2];
    corners.insert(corners.end(), {a, b, c});
  }
  return corners;
}

glm::dvec3 doubled_area(const Mesh& mesh, const uint32_t* corner) {
  const glm::dvec3 a(mesh.vertices[corner[0]].position), b(mesh.vertices[corner[1]].position),
      c(mesh.vertices[corner[2]].position);
  return glm::cross(b - a, c - a);
}

// Degenerate triangles cover no pixel and have no normal.
size_t drop_degenerate_triangles(Mesh& mesh) {
  std::vector<uint32_t> kept;
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    if (glm::length(doubled_area(mesh, &mesh.indices[i])) > 0)
      kept.insert(kept.end(), {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
  const size_t dropped = (mesh.indices.size() - kept.size()) / 3;
  mesh.indices = std::move(kept);
  return dropped;
}

// So that bounds and texture coordinates speak only of what is drawn.
void drop_unused_vertices(GltfMesh& from) {
  Mesh& mesh = from.mesh;
  std::vector<glm::vec4> colours;
  constexpr uint32_t unused = 0xffffffffu;
  std::vector<uint32_t> place(mesh.vertices.size(), unused);
  std::vector<Vertex> kept;
  for (uint32_t& index : mesh.indices) {
    if (place[index] == unused) {
      place[index] = static_cast<uint32_t>(kept.size());
      kept.push_back(mesh.vertices[index]);
      if (!from.colours.empty()) colours.push_back(from.colours[index]);
    }
    index = place[index];
  }
  mesh.vertices = std::move(kept);
  from.colours = std::move(colours);
}

// Smooth across shared vertices, each triangle weighed by its area; vertices that no two triangles share come out flat. Only
// normals that are zero are set.
void fill_in_normals(Mesh& mesh) {
  std::vector<glm::dvec3> sums(mesh.vertices.size(), glm::dvec3(0));
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::dvec3 area = doubled_area(mesh, &mesh.indices[i]);
    for (size_t corner = 0; corner < 3; ++corner) sums[mesh.indices[i + corner]] += area;
  }
  for (size_t i = 0; i < sums.size(); ++i) {
    glm::vec3& normal = mesh.vertices[i].normal;
    if (normal != glm::vec3(0)) continue;
    const double length = glm::length(sums[i]);
    normal = length > 0 ? glm::vec3(sums[i] / length) : glm::vec3(0, 1, 0);  // opposite triangles cancel: any direction will do
  }
}

glm::vec3 unit_or_zero(glm::dvec3 v) {
  const double length = glm::length(v);
  return length > 0 ? glm::vec3(v / length) : glm::vec3(0);
}

// The file's own tangents. Their bitangent points up the image, ours down it (scene.h), hence -w.
void use_tangents(Mesh& mesh, const std::vector<double>& tangents) {
  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
    Vertex& vertex = mesh.vertices[i];
    const glm::dvec3 normal(vertex.normal), tangent(tangents[i * 4], tangents[i * 4 + 1], tangents[i * 4 + 2]);
    const glm::vec3 in_plane = unit_or_zero(tangent - normal * glm::dot(normal, tangent));
    const float handedness = tangents[i * 4 + 3] < 0 ? 1.0f : -1.0f;
    vertex.tangent = glm::vec4(in_plane == glm::vec3(0) ? any_orthogonal(vertex.normal) : in_plane, handedness);
  }
}

void mirror_in_x(Mesh& mesh) {
  for (Vertex& vertex : mesh.vertices) {
    vertex.position.x = -vertex.position.x;
    vertex.normal.x = -vertex.normal.x;
    vertex.tangent.x = -vertex.tangent.x;
    vertex.tangent.w = -vertex.tangent.w;
  }
  for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
}

// The set that is read, of those that the primitive has; -1: it has none.
int uv_set_of(const tinygltf::Primitive& primitive, const PrimitiveUse& use, std::vector<std::string>& warnings) {
  const auto has = [&](int set) { return primitive.attributes.contains(fmt::format("TEXCOORD_{}", set)); };
  if (has(use.uv_set)) return use.uv_set;
  constexpr int max_sets = 8;
  for (int set = 0; set < max_sets; ++set)
    if (has(set)) {
      warnings.push_back(fmt::format("Mesh '{}' has no texture coordinates {}; set {} is used.", use.name, use.uv_set, set));
      return set;
    }
  warnings.push_back(fmt::format("Mesh '{}' has no texture coordinates: it is drawn by what needs none.", use.name));
  return -1;
}

// Morph targets in their weights (section 3.7.2.2): what they add to positions and normals.
void add_targets(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const PrimitiveUse& use,
                 std::vector<double>& positions, std::vector<double>& normals) {
  for (size_t target = 0; target < std::min(primitive.targets.size(), use.morph_weights.size()); ++target) {
    const double weight = use.morph_weights[target];
    if (weight == 0) continue;
    for (auto* to : {&positions, &normals}) {
      const auto found = primitive.targets[target].find(to == &positions ? "POSITION" : "NORMAL");
      if (found == primitive.targets[target].end() || to->empty()) continue;
      const std::string subject = fmt::format("mesh '{}', morph target {}", use.name, target);
      const std::vector<double> moved = read_accessor(model, found->second, 3, subject);
      if (moved.size() != to->size()) refuse_gltf(subject, "has another number of vertices than the mesh");
      for (size_t i = 0; i < moved.size(); ++i) {
        if (!std::isfinite(moved[i])) refuse_gltf(subject, "is not a finite number; repair the model");
        (*to)[i] += weight * moved[i];
      }
    }
  }
}

// A vertex where its joints hold it (section 3.7.3): the weighted mean of their matrices.
void pose_by_skin(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const PrimitiveUse& use,
                  std::vector<double>& positions, std::vector<double>& normals, std::vector<double>& tangents) {
  const std::vector<double> joints = read_attribute(model, primitive, "JOINTS_0", 4, use.name);
  const std::vector<double> weights = read_attribute(model, primitive, "WEIGHTS_0", 4, use.name);
  const size_t count = positions.size() / 3;
  const std::string subject = fmt::format("mesh '{}', JOINTS_0", use.name);
  if (joints.size() != 4 * count || weights.size() != 4 * count)
    refuse_gltf(fmt::format("mesh '{}'", use.name), "is used with a skin and needs JOINTS_0 and WEIGHTS_0 for each vertex");
  for (size_t i = 0; i < count; ++i) {
    glm::dmat4 matrix(0);
    double sum = 0;
    for (size_t k = 4 * i; k < 4 * i + 4; ++k) {
      if (weights[k] == 0) continue;
      if (!(joints[k] >= 0 && joints[k] < double(use.world_from_bind.size())))
        refuse_gltf(subject, fmt::format("joint {} of vertex {} is not in the skin, which has {}", joints[k], i,
                                         use.world_from_bind.size()));
      matrix += weights[k] * use.world_from_bind[size_t(joints[k])];
      sum += weights[k];
    }
    if (!(sum > 0)) continue;  // held by nothing: where it is
    matrix = matrix * (1 / sum);
    const auto put = [&](std::vector<double>& to, size_t stride, const glm::dvec3& v) {
      for (size_t axis = 0; axis < 3; ++axis) to[i * stride + axis] = v[int(axis)];
    };
    put(positions, 3, glm::dvec3(matrix * glm::dvec4(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2], 1)));
    const glm::dmat3 turned(matrix);
    if (glm::determinant(turned) == 0) continue;
    if (!normals.empty())
      put(normals, 3, glm::inverseTranspose(turned) * glm::dvec3(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]));
    if (!tangents.empty()) put(tangents, 4, turned * glm::dvec3(tangents[4 * i], tangents[4 * i + 1], tangents[4 * i + 2]));
  }
}

std::vector<glm::vec4> read_colours(const tinygltf::Model& model, const tinygltf::Primitive& primitive, size_t count,
                                    const std::string& name) {
  const auto found = primitive.attributes.find("COLOR_0");
  if (found == primitive.attributes.end()) return {};
  const bool has_alpha =
      size_t(found->second) < model.accessors.size() && model.accessors[size_t(found->second)].type == TINYGLTF_TYPE_VEC4;
  const size_t width = has_alpha ? 4 : 3;
  const std::vector<double> values = read_attribute(model, primitive, "COLOR_0", int(width), name);
  if (values.size() != width * count)
    refuse_gltf(fmt::format("mesh '{}', COLOR_0", name),
                fmt::format("has {} vertices where POSITION has {}", values.size() / width, count));
  std::vector<glm::vec4> colours(count, glm::vec4(1));
  for (size_t i = 0; i < values.size(); ++i)
    colours[i / width][int(i % width)] = static_cast<float>(std::clamp(values[i], 0.0, 1.0));
  return colours;
}

// The back of a double-sided surface, with its normals turned (section 3.9.6).
void add_back(GltfMesh& from) {
  Mesh& mesh = from.mesh;
  const size_t vertices = mesh.vertices.size(), corners = mesh.indices.size();
  for (size_t i = 0; i < vertices; ++i) {
    Vertex back = mesh.vertices[i];
    back.normal = -back.normal;
    back.tangent.w = -back.tangent.w;  // the bitangent stays: cross(normal, tangent) has turned with the normal
    mesh.vertices.push_back(back);
    if (!from.colours.empty()) from.colours.push_back(glm::vec4(from.colours[i]));
  }
  for (size_t i = 0; i + 2 < corners; i += 3)
    for (const size_t c : {i, i + 2, i + 1}) mesh.indices.push_back(mesh.indices[c] + static_cast<uint32_t>(vertices));
}

}  // namespace

std::optional<GltfMesh> mesh_from_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                            const PrimitiveUse& use, std::vector<std::string>& warnings) {
  const std::string& name = use.name;
  if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
    refuse_gltf(fmt::format("mesh '{}'", name), fmt::format("primitive mode {} is none of glTF's", primitive.mode));
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    warnings.push_back(fmt::format("Mesh '{}' has points or lines, which are not drawn.", name));
    return std::nullopt;
  }
  if (!primitive.attributes.contains("POSITION")) {
    warnings.push_back(fmt::format("Mesh '{}' has a primitive without POSITION, which is left out.", name));
    return std::nullopt;
  }

  std::vector<double> positions = read_attribute(model, primitive, "POSITION", 3, name);
  std::vector<double> normals = read_attribute(model, primitive, "NORMAL", 3, name);
  std::vector<double> tangents = read_attribute(model, primitive, "TANGENT", 4, name);
  const int uv_set = uv_set_of(primitive, use, warnings);
  const std::string uv_name = fmt::format("TEXCOORD_{}", std::max(uv_set, 0));
  const std::vector<double> uvs = uv_set < 0 ? std::vector<double>() : read_attribute(model, primitive, uv_name, 2, name);
  const size_t count = positions.size() / 3;
  if (count == 0) refuse_gltf(fmt::format("mesh '{}'", name), "has no vertices in its POSITION");
  const auto require_count = [&](const std::string& attribute, size_t has) {
    if (has != 0 && has != count)
      refuse_gltf(fmt::format("mesh '{}', {}", name, attribute),
                  fmt::format("has {} vertices where POSITION has {}", has, count));
  };
  require_count("NORMAL", normals.size() / 3);
  require_count("TANGENT", tangents.size() / 4);
  require_count(uv_name, uvs.size() / 2);
  add_targets(model, primitive, use, positions, normals);
  if (!use.world_from_bind.empty()) pose_by_skin(model, primitive, use, positions, normals, tangents);

  GltfMesh result;
  result.has_uv = !uvs.empty();
  result.colours = read_colours(model, primitive, count, name);
  Mesh& mesh = result.mesh;
  mesh.vertices.resize(count);
  for (size_t i = 0; i < count; ++i) {
    Vertex& vertex = mesh.vertices[i];
    vertex.position = glm::vec3(positions[i * 3], positions[i * 3 + 1], positions[i * 3 + 2]);
    vertex.normal =
        normals.empty() ? glm::vec3(0) : unit_or_zero(glm::dvec3(normals[i * 3], normals[i * 3 + 1], normals[i * 3 + 2]));
    vertex.uv = uvs.empty() ? glm::vec2(0) : glm::vec2(use.texture_from_uv * glm::dvec3(uvs[i * 2], uvs[i * 2 + 1], 1));
    vertex.tangent = glm::vec4(0);
  }
  mesh.indices = triangle_corners(model, primitive, count, name);
  if (const size_t dropped = drop_degenerate_triangles(mesh); dropped > 0)
    warnings.push_back(fmt::format("Mesh '{}' has {} triangles without area, which are left out.", name, dropped));
  if (mesh.indices.empty()) {
    warnings.push_back(fmt::format("Mesh '{}' has a primitive without triangles, which is left out.", name));
    return std::nullopt;
  }
  fill_in_normals(mesh);
  // Tangents mean nothing without the normals they were made for (glTF 2.0, section 3.7.2.1), nor where a transform turns the
  // texture.
  const bool has_tangents = !tangents.empty() && !normals.empty() && use.texture_from_uv == glm::dmat3(1);
  if (has_tangents) use_tangents(mesh, tangents);
  drop_unused_vertices(result);
  if (!has_tangents) compute_tangents(mesh);
  if (use.mirrored) mirror_in_x(mesh);
  if (use.double_sided && has_open_edge(mesh)) add_back(result);
  return result;
}

}  // namespace lamina
