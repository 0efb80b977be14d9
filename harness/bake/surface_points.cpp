// SPDX-License-Identifier: Apache-2.0
#include "harness/bake/surface_points.h"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "harness/core/error.h"
#include "harness/scene/mesh/uv_raster.h"

namespace lamina {
namespace {

constexpr uint32_t none = ~0u;

glm::vec3 unit_or_zero(glm::vec3 v) {
  const float squared = glm::dot(v, v);
  return squared > 1e-20f && squared < 1e20f ? v / glm::sqrt(squared) : glm::vec3(0);
}

// World-space normals of the vertices; where one has no length, of the triangles around it, by area.
std::vector<glm::vec3> world_normals(const Object& object) {
  const glm::mat3 linear(object.world_from_object), turned = glm::transpose(glm::inverse(linear));
  const std::vector<Vertex>& vertices = object.mesh.vertices;
  const std::vector<uint32_t>& indices = object.mesh.indices;
  std::vector<glm::vec3> normals(vertices.size()), of_triangles(vertices.size(), glm::vec3(0));
  for (size_t t = 0; t + 2 < indices.size(); t += 3) {
    const std::array<glm::vec3, 3> p = {linear * vertices[indices[t]].position, linear * vertices[indices[t + 1]].position,
                                        linear * vertices[indices[t + 2]].position};
    for (size_t c = 0; c < 3; ++c) of_triangles[indices[t + c]] += glm::cross(p[1] - p[0], p[2] - p[0]);
  }
  for (size_t i = 0; i < vertices.size(); ++i) {
    normals[i] = unit_or_zero(turned * vertices[i].normal);
    if (normals[i] == glm::vec3(0)) normals[i] = unit_or_zero(of_triangles[i]);
  }
  return normals;
}

glm::vec3 world_position(const Object& object, uint32_t vertex) {
  return object.world_from_object * glm::vec4(object.mesh.vertices[vertex].position, 1);
}

// Every texel without a point takes that of the nearest one that has, by steps to the four sides (breadth first).
void spread_to_all(std::vector<uint32_t>& point_of_texel, uint32_t side) {
  std::vector<uint32_t> front;
  for (uint32_t texel = 0; texel < point_of_texel.size(); ++texel)
    if (point_of_texel[texel] != none) front.push_back(texel);
  for (size_t next = 0; next < front.size(); ++next) {
    const uint32_t texel = front[next], x = texel % side, y = texel / side;
    const auto take = [&](bool inside, uint32_t other) {
      if (!inside || point_of_texel[other] != none) return;
      point_of_texel[other] = point_of_texel[texel];
      front.push_back(other);
    };
    take(x > 0, texel - 1);
    take(x + 1 < side, texel + 1);
    take(y > 0, texel - side);
    take(y + 1 < side, texel + side);
  }
}

}  // namespace

SurfacePoints vertex_points(const Object& object) {
  SurfacePoints made;
  const std::vector<glm::vec3> normals = world_normals(object);
  const auto count = static_cast<uint32_t>(object.mesh.vertices.size());
  made.neighbours.resize(count);
  std::map<std::tuple<float, float, float>, uint32_t> last_there;
  for (uint32_t i = 0; i < count; ++i) {
    made.points.push_back({world_position(object, i), normals[i]});
    const glm::vec3 p = object.mesh.vertices[i].position;
    const auto [other, is_new] = last_there.try_emplace({p.x, p.y, p.z}, i);
    if (is_new) continue;
    made.neighbours[i].push_back(other->second);
    made.neighbours[other->second].push_back(i);
    other->second = i;
  }
  const std::vector<uint32_t>& indices = object.mesh.indices;
  for (size_t t = 0; t + 2 < indices.size(); t += 3)
    for (size_t c = 0; c < 3; ++c) {
      made.neighbours[indices[t + c]].push_back(indices[t + (c + 1) % 3]);
      made.neighbours[indices[t + (c + 1) % 3]].push_back(indices[t + c]);
    }
  return made;
}

SurfacePoints map_points(const Object& object, uint32_t map_side) {
  const auto refuse = [&](const std::string& why) {
    return Error(ErrorKind::failed, "bake", fmt::format("object '{}'", object.name),
                 fmt::format("a baked map needs an unwrap of its own: {}; bake a point a vertex instead", why));
  };
  if (!object.unwrap_problem.empty()) throw refuse(object.unwrap_problem);
  SurfacePoints made;
  made.map_side = map_side;
  made.point_of_texel.assign(size_t{map_side} * map_side, none);
  const std::vector<glm::vec3> normals = world_normals(object);
  for (size_t triangle = 0; triangle < object.mesh.indices.size() / 3; ++triangle) {
    std::array<uint32_t, 3> corner;
    std::array<glm::dvec2, 3> uv;
    for (size_t c = 0; c < 3; ++c) {
      corner[c] = object.mesh.indices[3 * triangle + c];
      uv[c] = glm::dvec2(object.mesh.vertices[corner[c]].uv) * double(map_side);
    }
    const auto twice_area = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
      return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const double whole = twice_area(uv[0], uv[1], uv[2]);
    if (whole == 0) continue;
    for (const uint32_t texel : covered_texels(object.mesh, triangle, map_side)) {
      if (made.point_of_texel[texel] != none) continue;
      const glm::dvec2 centre(texel % map_side + 0.5, texel / map_side + 0.5);
      const auto w0 = static_cast<float>(twice_area(centre, uv[1], uv[2]) / whole);
      const auto w1 = static_cast<float>(twice_area(uv[0], centre, uv[2]) / whole), w2 = 1 - w0 - w1;
      made.point_of_texel[texel] = static_cast<uint32_t>(made.points.size());
      made.points.push_back({world_position(object, corner[0]) * w0 + world_position(object, corner[1]) * w1 +
                                 world_position(object, corner[2]) * w2,
                             unit_or_zero(normals[corner[0]] * w0 + normals[corner[1]] * w1 + normals[corner[2]] * w2)});
    }
  }
  if (made.points.empty()) throw refuse("no triangle covers the middle of a texel");
  made.neighbours.resize(made.points.size());
  const auto join = [&](uint32_t a, uint32_t b) {
    if (made.point_of_texel[a] == none || made.point_of_texel[b] == none) return;
    made.neighbours[made.point_of_texel[a]].push_back(made.point_of_texel[b]);
    made.neighbours[made.point_of_texel[b]].push_back(made.point_of_texel[a]);
  };
  for (uint32_t texel = 0; texel < made.point_of_texel.size(); ++texel) {
    if (texel % map_side + 1 < map_side) join(texel, texel + 1);
    if (texel + map_side < made.point_of_texel.size()) join(texel, texel + map_side);
  }
  spread_to_all(made.point_of_texel, map_side);
  return made;
}

}  // namespace lamina
