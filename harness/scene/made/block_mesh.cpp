// SPDX-License-Identifier: Apache-2.0
// See block_mesh.h.
#include "harness/scene/made/block_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace lamina {
namespace {

// Between planes in the unwrap, and around them, as a share of the tile.
constexpr float gap = 0.006f;

// The faces of the blocks along one axis, in order, with cuts between them no further apart than the spacing.
std::vector<float> cuts_along(int axis, const std::vector<Block>& blocks, float spacing_m) {
  std::vector<float> faces;
  for (const Block& block : blocks) faces.insert(faces.end(), {block.low[axis], block.high[axis]});
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  std::vector<float> cuts = {faces.front()};
  for (size_t i = 0; i + 1 < faces.size(); ++i) {
    const int pieces = std::max(1, static_cast<int>(std::ceil((faces[i + 1] - faces[i]) / spacing_m - 1e-3f)));
    for (int piece = 1; piece < pieces; ++piece)
      cuts.push_back(glm::mix(faces[i], faces[i + 1], static_cast<float>(piece) / static_cast<float>(pieces)));
    cuts.push_back(faces[i + 1]);
  }
  return cuts;
}

// The faces that lie in one plane and look the same way.
struct Plane {
  int axis;                            // of the normal
  int sign;                            // of the normal along the axis
  int position;                        // the cut
  std::vector<glm::ivec2> faces = {};  // cells along the next two axes

  auto key() const { return std::array<int, 3>{axis, sign, position}; }
};

class Blocks {
 public:
  Blocks(const std::vector<Block>& blocks, float spacing_m) : blocks_(blocks) {
    for (int axis = 0; axis < 3; ++axis) cuts_[axis] = cuts_along(axis, blocks, spacing_m);
    for (int axis = 0; axis < 3; ++axis) size_[axis] = static_cast<int>(cuts_[axis].size()) - 1;
    solid_.resize(static_cast<size_t>(size_.x) * size_.y * size_.z);
    for (int z = 0; z < size_.z; ++z)
      for (int y = 0; y < size_.y; ++y)
        for (int x = 0; x < size_.x; ++x) solid_[index({x, y, z})] = inside({x, y, z});
  }

  std::vector<Plane> planes() const {
    std::map<std::array<int, 3>, Plane> found;
    for (int z = 0; z < size_.z; ++z)
      for (int y = 0; y < size_.y; ++y)
        for (int x = 0; x < size_.x; ++x)
          for (int axis = 0; axis < 3 && solid({x, y, z}); ++axis)
            for (const int sign : {-1, 1}) {
              glm::ivec3 cell(x, y, z), beside = cell;
              beside[axis] += sign;
              if (solid(beside)) continue;
              const Plane plane{axis, sign, cell[axis] + (sign > 0)};
              Plane& all = found.try_emplace(plane.key(), plane).first->second;
              all.faces.push_back({cell[(axis + 1) % 3], cell[(axis + 2) % 3]});
            }
    std::vector<Plane> planes;
    for (auto& [key, plane] : found) planes.push_back(std::move(plane));
    return planes;
  }

  // The corner of a plane's cell, in metres along the next two axes.
  glm::vec2 corner(const Plane& plane, glm::ivec2 at) const {
    return {cuts_[(plane.axis + 1) % 3][at.x], cuts_[(plane.axis + 2) % 3][at.y]};
  }
  float height(const Plane& plane) const { return cuts_[plane.axis][plane.position]; }

 private:
  size_t index(glm::ivec3 c) const { return (static_cast<size_t>(c.z) * size_.y + c.y) * size_.x + c.x; }
  bool solid(glm::ivec3 c) const {
    return glm::all(glm::greaterThanEqual(c, glm::ivec3(0))) && glm::all(glm::lessThan(c, size_)) && solid_[index(c)];
  }
  bool inside(glm::ivec3 c) const {
    glm::vec3 middle;
    for (int axis = 0; axis < 3; ++axis) middle[axis] = (cuts_[axis][c[axis]] + cuts_[axis][c[axis] + 1]) / 2;
    bool solid = false;
    for (const Block& block : blocks_)
      if (glm::all(glm::greaterThan(middle, block.low)) && glm::all(glm::lessThan(middle, block.high))) solid = block.solid;
    return solid;
  }

  const std::vector<Block>& blocks_;
  std::array<std::vector<float>, 3> cuts_;
  glm::ivec3 size_{0};
  std::vector<bool> solid_;
};

struct Rectangle {
  glm::vec2 low, size;  // metres
  glm::vec2 place{0};   // of its corner in the unwrap, in tiles
};

// Shelves of rectangles, the tallest first; whether they fit at this scale (tiles a metre).
bool place_on_shelves(std::vector<Rectangle>& rectangles, const std::vector<size_t>& order, float scale) {
  glm::vec2 pen(gap);
  float shelf = 0;
  for (const size_t i : order) {
    const glm::vec2 size = rectangles[i].size * scale;
    if (pen.x + size.x + gap > 1) pen = {gap, pen.y + shelf + gap}, shelf = 0;
    if (pen.x + size.x + gap > 1 || pen.y + size.y + gap > 1) return false;
    rectangles[i].place = pen;
    pen.x += size.x + gap;
    shelf = std::max(shelf, size.y);
  }
  return true;
}

// Places all rectangles in the unit tile; returns the scale, within 2% of the largest that this order allows.
float pack(std::vector<Rectangle>& rectangles) {
  std::vector<size_t> order(rectangles.size());
  float area = 0;
  for (size_t i = 0; i < order.size(); ++i) order[i] = i, area += rectangles[i].size.x * rectangles[i].size.y;
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return rectangles[a].size.y > rectangles[b].size.y; });
  float scale = 1 / std::sqrt(area);
  while (!place_on_shelves(rectangles, order, scale)) scale *= 0.98f;
  return scale;
}

}  // namespace

Mesh block_mesh(const std::vector<Block>& blocks, float spacing_m) {
  const Blocks cells(blocks, spacing_m);
  const std::vector<Plane> planes = cells.planes();
  std::vector<Rectangle> rectangles;
  for (const Plane& plane : planes) {
    glm::vec2 low(INFINITY), high(-INFINITY);
    for (const glm::ivec2 face : plane.faces)
      low = glm::min(low, cells.corner(plane, face)), high = glm::max(high, cells.corner(plane, face + 1));
    rectangles.push_back({low, high - low});
  }
  const float scale = pack(rectangles);

  Mesh mesh;
  for (size_t i = 0; i < planes.size(); ++i) {
    const Plane& plane = planes[i];
    const int along_u = (plane.axis + 1) % 3, along_v = (plane.axis + 2) % 3;
    glm::vec3 normal(0), tangent(0);
    normal[plane.axis] = static_cast<float>(plane.sign);
    tangent[along_u] = 1;
    std::map<std::array<int, 2>, uint32_t> numbers;
    const auto vertex = [&](glm::ivec2 at) {
      const auto [entry, fresh] = numbers.try_emplace({at.x, at.y}, static_cast<uint32_t>(mesh.vertices.size()));
      if (fresh) {
        const glm::vec2 p = cells.corner(plane, at);
        glm::vec3 position;
        position[plane.axis] = cells.height(plane);
        position[along_u] = p.x;
        position[along_v] = p.y;
        // Axes follow each other in a right-handed circle, so v runs along cross(normal, tangent) where the normal points up.
        mesh.vertices.push_back({position, normal, glm::vec4(tangent, static_cast<float>(plane.sign)),
                                 rectangles[i].place + scale * (p - rectangles[i].low)});
      }
      return entry->second;
    };
    for (const glm::ivec2 face : plane.faces) {
      uint32_t a = vertex(face), b = vertex(face + glm::ivec2(1, 0)), c = vertex(face + 1), d = vertex(face + glm::ivec2(0, 1));
      if (plane.sign < 0) std::swap(b, d);
      mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    }
  }
  return mesh;
}

void add_part(Mesh& mesh, const Mesh& part, const glm::mat4& place, glm::uvec2 cell, glm::uvec2 cells) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  for (Vertex vertex : part.vertices) {
    vertex.position = glm::vec3(place * glm::vec4(vertex.position, 1));
    vertex.normal = glm::normalize(glm::vec3(place * glm::vec4(vertex.normal, 0)));
    vertex.tangent = glm::vec4(glm::normalize(glm::vec3(place * glm::vec4(glm::vec3(vertex.tangent), 0))), vertex.tangent.w);
    vertex.uv = (glm::vec2(cell) + vertex.uv) / glm::vec2(cells);
    mesh.vertices.push_back(vertex);
  }
  for (const uint32_t index : part.indices) mesh.indices.push_back(first + index);
}

}  // namespace lamina
