// SPDX-License-Identifier: Apache-2.0
// Patches after C. Yuksel, J. Keyser, D. H. House, "Mesh Colors", ACM Transactions on Graphics 29(2), 2010, section 3: a
// triangle's colours in texels of its own, so that no unwrap is needed.
#include "harness/scene/mesh/vertex_colours.h"

#include <algorithm>
#include <cmath>

#include "harness/core/error.h"
#include "harness/scene/mesh/tangents.h"
#include "harness/scene/mesh/unwrap_check.h"
#include "harness/scene/mesh/uv_raster.h"

namespace lamina {
namespace {

constexpr uint32_t min_side = 512, max_side = 2048;  // of a texture that colours are drawn into
constexpr uint32_t atlas_side = 4096;
// A patch of at least 2 texels between corners and one around, so that a linear filter stays inside it.
constexpr uint32_t min_patch = 4, max_patch = 16;

bool all_equal(std::span<const glm::vec4> colours) {
  return std::ranges::all_of(colours, [&](const glm::vec4& colour) { return colour == colours.front(); });
}

// Twice the signed area of a triangle in the plane of texture coordinates.
double doubled_uv_area(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Texels that no triangle covers take the mean of covered neighbours, ring by ring, so that filters find nothing strange at the
// borders of charts.
void grow_charts(Texels& texels, std::vector<uint8_t>& known) {
  constexpr int rings = 8;
  const int width = int(texels.width), height = int(texels.height);
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<uint8_t> before = known;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        if (before[size_t(y * width + x)]) continue;
        glm::vec4 sum(0);
        float count = 0;
        for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
          const int nx = x + dx, ny = y + dy;
          if (nx < 0 || ny < 0 || nx >= width || ny >= height || !before[size_t(ny * width + nx)]) continue;
          sum += texels.rgba[size_t(ny * width + nx)];
          ++count;
        }
        if (count == 0) continue;
        texels.rgba[size_t(y * width + x)] = sum / count;
        known[size_t(y * width + x)] = 1;
      }
  }
}

// The colours over the mesh's own texture coordinates, white where nothing is near.
Texels over_unwrap(const Mesh& mesh, std::span<const glm::vec4> colours, uint32_t side) {
  Texels texels{side, side, std::vector<glm::vec4>(size_t{side} * side, glm::vec4(1))};
  std::vector<uint8_t> known(texels.rgba.size(), 0);
  for (size_t triangle = 0; triangle < mesh.indices.size() / 3; ++triangle) {
    const uint32_t* corner = &mesh.indices[3 * triangle];
    const glm::dvec2 a(mesh.vertices[corner[0]].uv), b(mesh.vertices[corner[1]].uv), c(mesh.vertices[corner[2]].uv);
    const double area = doubled_uv_area(a, b, c);
    if (area == 0) continue;
    for (const uint32_t texel : covered_texels(mesh, triangle, side)) {
      const glm::dvec2 at((texel % side + 0.5) / side, (texel / side + 0.5) / side);
      const auto wb = static_cast<float>(doubled_uv_area(a, at, c) / area),
                 wc = static_cast<float>(doubled_uv_area(a, b, at) / area);
      texels.rgba[texel] = (1 - wb - wc) * colours[corner[0]] + wb * colours[corner[1]] + wc * colours[corner[2]];
      known[texel] = 1;
    }
  }
  grow_charts(texels, known);
  return texels;
}

// Every triangle in a patch of its own, in rows. Replaces the mesh's vertices and texture coordinates.
Texels in_patches(Mesh& mesh, std::span<const glm::vec4> colours, uint32_t columns, uint32_t patch) {
  const uint32_t side = columns * patch;
  Texels texels{side, side, std::vector<glm::vec4>(size_t{side} * side, glm::vec4(1))};
  std::vector<Vertex> vertices;
  for (size_t triangle = 0; triangle < mesh.indices.size() / 3; ++triangle) {
    const uint32_t* corner = &mesh.indices[3 * triangle];
    const glm::vec4 a = colours[corner[0]], b = colours[corner[1]] - a, c = colours[corner[2]] - a;
    const auto left = static_cast<uint32_t>(triangle % columns) * patch,
               top = static_cast<uint32_t>(triangle / columns) * patch;
    const auto between = static_cast<float>(patch - 3);  // texels from corner to corner, whose colours lie at texels' centres
    for (uint32_t y = 0; y < patch; ++y)
      for (uint32_t x = 0; x < patch; ++x)
        texels.rgba[size_t{top + y} * side + left + x] =
            glm::clamp(a + (float(x) - 1) / between * b + (float(y) - 1) / between * c, 0.0f, 1.0f);
    const glm::vec2 places[3] = {{1.5f, 1.5f}, {1.5f + between, 1.5f}, {1.5f, 1.5f + between}};
    for (size_t k = 0; k < 3; ++k) {
      Vertex vertex = mesh.vertices[corner[k]];
      vertex.uv = (glm::vec2(left, top) + places[k]) / float(side);
      vertices.push_back(vertex);
    }
  }
  mesh.vertices = std::move(vertices);
  for (size_t i = 0; i < mesh.indices.size(); ++i) mesh.indices[i] = static_cast<uint32_t>(i);
  compute_tangents(mesh);
  return texels;
}

}  // namespace

std::string apply_vertex_colours(Mesh& mesh, std::span<const glm::vec4> colours, bool textured, bool alpha, ModelLook& look) {
  if (colours.size() != mesh.vertices.size() || colours.empty())
    throw Error(ErrorKind::failed, "scene", "vertex colours",
                fmt::format("{} colours for {} vertices", colours.size(), mesh.vertices.size()));
  const auto multiply = [&](glm::vec4& texel, const glm::vec4& by) {
    texel = glm::vec4(glm::vec3(texel) * glm::vec3(by), alpha ? texel.a * by.a : texel.a);
  };
  if (all_equal(colours)) {
    for (glm::vec4& texel : look.base_colour.rgba) multiply(texel, colours.front());
    return "";
  }
  Mesh moved = mesh;
  if (!look.base_colour.wraps) move_to_unit_tile(moved);
  Texels drawn;
  if (unwrap_problem(moved).empty() && overlap_fraction(moved) <= worrying_overlap) {
    const uint32_t side = std::clamp(std::max(look.base_colour.width, look.base_colour.height), min_side, max_side);
    drawn = over_unwrap(moved, colours, side);
  } else if (textured) {
    return "its textures use texels for several places, which colours of vertices would tell apart";
  } else {
    const size_t triangles = mesh.indices.size() / 3;
    const auto columns = static_cast<uint32_t>(std::ceil(std::sqrt(double(triangles))));
    const uint32_t patch = std::min(max_patch, atlas_side / std::max(columns, 1u));
    if (patch < min_patch)
      return fmt::format("{} triangles are too many for a texture of {} texels a side", triangles, atlas_side);
    drawn = in_patches(mesh, colours, columns, patch);
  }
  Texels base = resized(look.base_colour, drawn.width, drawn.height);
  for (size_t i = 0; i < base.rgba.size(); ++i) multiply(base.rgba[i], drawn.rgba[i]);
  look.base_colour = std::move(base);
  return "";
}

}  // namespace lamina
