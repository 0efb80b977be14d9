// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/gltf/gltf_mesh.h"

#include <cmath>

#include "harness/core/error.h"
#include "harness/scene/gltf/gltf_file.h"
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
void drop_unused_vertices(Mesh& mesh) {
  constexpr uint32_t unused = 0xffffffffu;
  std::vector<uint32_t> place(mesh.vertices.size(), unused);
  std::vector<Vertex> kept;
  for (uint32_t& index : mesh.indices) {
    if (place[index] == unused) {
      place[index] = static_cast<uint32_t>(kept.size());
      kept.push_back(mesh.vertices[index]);
    }
    index = place[index];
  }
  mesh.vertices = std::move(kept);
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

}  // namespace

std::optional<Mesh> mesh_from_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                        const std::string& name, bool mirrored, std::vector<std::string>& warnings) {
  if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
    refuse_gltf(fmt::format("mesh '{}'", name), fmt::format("primitive mode {} is none of glTF's", primitive.mode));
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    warnings.push_back(fmt::format("Mesh '{}' has points or lines, which are not drawn.", name));
    return std::nullopt;
  }
  if (!primitive.targets.empty()) warnings.push_back(fmt::format("Mesh '{}' has morph targets, which are not applied.", name));

  const std::vector<double> positions = read_attribute(model, primitive, "POSITION", 3, name);
  const std::vector<double> normals = read_attribute(model, primitive, "NORMAL", 3, name);
  const std::vector<double> tangents = read_attribute(model, primitive, "TANGENT", 4, name);
  const std::vector<double> uvs = read_attribute(model, primitive, "TEXCOORD_0", 2, name);
  const size_t count = positions.size() / 3;
  if (count == 0) refuse_gltf(fmt::format("mesh '{}'", name), "has no POSITION");
  if (uvs.empty())
    refuse_gltf(fmt::format("mesh '{}'", name),
                "has no TEXCOORD_0; textures need texture coordinates, so unwrap it and export again");
  const auto require_count = [&](const char* attribute, size_t has) {
    if (has != 0 && has != count)
      refuse_gltf(fmt::format("mesh '{}', {}", name, attribute),
                  fmt::format("has {} vertices where POSITION has {}", has, count));
  };
  require_count("NORMAL", normals.size() / 3);
  require_count("TANGENT", tangents.size() / 4);
  require_count("TEXCOORD_0", uvs.size() / 2);

  Mesh mesh;
  mesh.vertices.resize(count);
  for (size_t i = 0; i < count; ++i) {
    Vertex& vertex = mesh.vertices[i];
    vertex.position = glm::vec3(positions[i * 3], positions[i * 3 + 1], positions[i * 3 + 2]);
    vertex.normal =
        normals.empty() ? glm::vec3(0) : unit_or_zero(glm::dvec3(normals[i * 3], normals[i * 3 + 1], normals[i * 3 + 2]));
    vertex.uv = glm::vec2(uvs[i * 2], uvs[i * 2 + 1]);
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
  // Tangents mean nothing without the normals they were made for (glTF 2.0, section 3.7.2.1).
  const bool has_tangents = !tangents.empty() && !normals.empty();
  if (has_tangents) use_tangents(mesh, tangents);
  drop_unused_vertices(mesh);
  if (!has_tangents) compute_tangents(mesh);
  if (mirrored) mirror_in_x(mesh);
  return mesh;
}

}  // namespace lamina
