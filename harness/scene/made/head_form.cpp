// SPDX-License-Identifier: Apache-2.0
// See head_form.h. Sizes are by eye on the finished picture.
#include "harness/scene/made/head_form.h"

#include <array>
#include <cmath>

#include "harness/scene/made/height_field.h"
#include "harness/scene/mesh/tangents.h"

namespace lamina {
namespace {

constexpr float head_pi = static_cast<float>(M_PI);
constexpr float chart_margin = 0.012f;  // around a chart, of its own side

struct HeadChart {
  enum class Part { head, left_ear, right_ear, neck } part;
  glm::vec2 from, to;  // of the unwrap
};
constexpr std::array<HeadChart, 4> head_charts = {{{HeadChart::Part::head, {0, 0}, {1, 0.75f}},
                                                   {HeadChart::Part::left_ear, {0, 0.75f}, {0.25f, 1}},
                                                   {HeadChart::Part::right_ear, {0.25f, 0.75f}, {0.5f, 1}},
                                                   {HeadChart::Part::neck, {0.5f, 0.75f}, {1, 1}}}};

float round_square(float x) { return x * x; }
float round_hill(float x, float y) { return std::exp(-x * x - y * y); }

// Longitudes lie closer in front (t = 0.5), where the face is.
glm::vec3 out_of(glm::vec2 t, float closer) {
  const float longitude = 2 * head_pi * t.x + closer * std::sin(2 * head_pi * t.x), polar = 0.02f + (head_pi - 0.04f) * t.y;
  return {-std::sin(longitude) * std::sin(polar), std::cos(polar), -std::cos(longitude) * std::sin(polar)};
}

glm::vec3 face_point(glm::vec3 direction) {
  glm::vec3 p = direction * glm::vec3(0.078f, direction.y > 0 ? 0.106f : 0.116f, 0.098f);
  const float low = glm::smoothstep(0.03f, -0.105f, p.y);
  p.x *= 1 - 0.30f * low;
  p.z *= p.z < 0 ? 1 - 0.34f * low : 1 - 0.05f * low;
  if (p.z <= 0) return p;
  const float x = p.x, y = p.y, side = std::abs(x), front = glm::smoothstep(0.0f, 0.045f, p.z);
  float z = 0;
  z += 0.0045f * round_hill((side - 0.024f) / 0.020f, (y - 0.027f) / 0.008f);  // brows
  z -= 0.0135f * round_hill((side - 0.031f) / 0.017f, (y - 0.006f) / 0.012f);  // sockets
  const float ball = 1 - round_square((side - 0.031f) / 0.0165f) - round_square((y - 0.006f) / 0.0125f);
  z += 0.0105f * glm::smoothstep(0.0f, 1.0f, ball);
  const float lid = y - 0.0008f + 30 * (side - 0.031f) * (side - 0.031f);  // where closed lids meet
  z -= 0.0016f * std::exp(-lid * lid / 1.0e-6f) * round_hill((side - 0.031f) / 0.0115f, 0);
  const float fold = y - 0.0135f + 18 * (side - 0.031f) * (side - 0.031f);
  z -= 0.0010f * std::exp(-fold * fold / 2.0e-6f) * round_hill((side - 0.031f) / 0.013f, 0);
  const float along = glm::smoothstep(0.022f, -0.028f, y);  // the nose, from its bridge down
  z += (0.004f + 0.017f * along) * std::exp(-x * x / (6e-5f + 8e-5f * along)) * glm::smoothstep(0.030f, 0.016f, y) *
       glm::smoothstep(-0.0395f, -0.0305f, y);
  z += 0.0055f * round_hill(x / 0.0085f, (y + 0.027f) / 0.0085f);                  // tip
  z += 0.0100f * round_hill((side - 0.0135f) / 0.0055f, (y + 0.0305f) / 0.0070f);  // wings
  z -= 0.0060f * round_hill((side - 0.0062f) / 0.0032f, (y + 0.0375f) / 0.0026f);  // nostrils
  z -= 0.0012f * round_hill(x / 0.0030f, (y + 0.046f) / 0.006f);                   // philtrum
  z += 0.0060f * round_hill(x / 0.027f, (y + 0.058f) / 0.017f);                    // mouth
  z += 0.0036f * round_hill((side - 0.006f) / 0.014f, (y + 0.0545f) / 0.0042f);    // lips
  z += 0.0042f * round_hill(x / 0.016f, (y + 0.0660f) / 0.0050f);
  const float line = y + 0.0600f - 6 * x * x;
  z -= 0.0038f * std::exp(-line * line / 2.2e-6f) * round_hill(x / 0.0225f, 0);
  z -= 0.0022f * round_hill((side - 0.0255f) / 0.0035f, (y + 0.0588f) / 0.004f);  // corners
  z -= 0.0030f * round_hill(x / 0.020f, (y + 0.0765f) / 0.0055f);
  z += 0.0090f * round_hill(x / 0.022f, (y + 0.093f) / 0.015f);                // chin
  z += 0.0060f * round_hill((side - 0.046f) / 0.018f, (y + 0.012f) / 0.016f);  // cheekbones
  z += 0.0030f * round_hill((side - 0.030f) / 0.016f, (y + 0.036f) / 0.018f);
  z -= 0.0045f * round_hill((side - 0.052f) / 0.016f, (y + 0.050f) / 0.022f);
  p.z += front * z;
  return p;
}

// A thin bowl with a rolled rim and a lobe; z is outwards from the head, x forward.
glm::vec3 ear_point(glm::vec3 direction, float side) {
  glm::vec3 p = direction * glm::vec3(0.0175f, 0.030f, 0.0026f);
  p.x *= 1 - 0.32f * glm::smoothstep(0.004f, -0.028f, p.y);
  const float r = glm::length(glm::vec2(p.x / (0.0175f * (1 - 0.32f * glm::smoothstep(0.004f, -0.028f, p.y))), p.y / 0.030f));
  p.z += 0.0062f * r * r -
         0.0040f * round_hill((p.x - 0.003f) / 0.006f, (p.y + 0.003f) / 0.009f) * (direction.z > 0 ? 1.0f : 0.2f);
  p.z += 0.0016f * round_hill((r - 0.62f) / 0.10f, 0) * (p.y > -0.012f ? 1.0f : 0.0f) * glm::smoothstep(-0.012f, -0.004f, p.y);
  p.z -= 0.0018f * round_hill((r - 0.80f) / 0.08f, 0) * glm::smoothstep(-0.012f, -0.002f, p.y);
  // Out from the head, its back edge furthest, and leaning back.
  const float turn = 0.62f, lean = 0.16f, c = std::cos(turn), s = std::sin(turn);
  const glm::vec3 q(p.z * c - (p.x - 0.0175f) * s * 0.75f, p.y, p.x * c + p.z * s);
  const glm::vec3 leaned(q.x, q.y * std::cos(lean) + q.z * std::sin(lean) * 0.6f, q.z - q.y * std::sin(lean));
  return {side * (0.0705f + leaned.x), leaned.y - 0.003f, leaned.z - 0.016f};
}

glm::vec3 neck_point(glm::vec3 direction) {
  glm::vec3 p = direction * glm::vec3(0.053f, 0.105f, 0.055f) + glm::vec3(0, -0.135f, -0.024f);
  const float wide = glm::smoothstep(-0.15f, -0.24f, p.y);
  return {p.x * (1 + 0.9f * wide), p.y, p.z * (1 + 0.15f * wide)};
}

glm::vec3 place_on(HeadChart::Part part, glm::vec2 t) {
  switch (part) {
    case HeadChart::Part::head:
      return face_point(out_of(t, 0.45f));
    case HeadChart::Part::left_ear:
      return ear_point(out_of(t, 0), 1);
    case HeadChart::Part::right_ear:
      return ear_point(out_of(t, 0), -1);
    case HeadChart::Part::neck:
      return neck_point(out_of(t, 0));
  }
  return {};
}

HeadRegions regions_of(HeadChart::Part part, glm::vec3 p) {
  HeadRegions regions;
  if (part == HeadChart::Part::left_ear || part == HeadChart::Part::right_ear) regions.ears = 1;
  if (part != HeadChart::Part::head || p.z < 0) return regions;
  const float side = std::abs(p.x), y = p.y;
  const float upper = glm::smoothstep(-0.0515f, -0.0535f, y - 0.0016f * round_hill((side - 0.005f) / 0.005f, 0)),
              lower = glm::smoothstep(-0.0722f, -0.0690f, y),
              wide = glm::smoothstep(0.0265f, 0.0215f, side + 4 * std::abs(y + 0.060f) * side);
  regions.lips = upper * lower * wide;
  regions.nose =
      std::max(round_hill(p.x / 0.014f, (y + 0.028f) / 0.012f), 0.6f * round_hill(p.x / 0.009f, (y + 0.005f) / 0.02f));
  regions.cheeks = round_hill((side - 0.042f) / 0.020f, (y + 0.028f) / 0.018f);
  const float arch = y - 0.0285f - 0.05f * (side - 0.012f) + 9 * (side - 0.03f) * (side - 0.03f);
  regions.brows =
      std::exp(-arch * arch / 9e-6f) * glm::smoothstep(0.009f, 0.014f, side) * glm::smoothstep(0.052f, 0.044f, side);
  regions.lids = round_hill((side - 0.031f) / 0.013f, (y - 0.006f) / 0.010f);
  regions.forehead = round_hill(p.x / 0.045f, (y - 0.058f) / 0.022f);
  return regions;
}

glm::vec2 within_chart(const HeadChart& chart, glm::vec2 uv) {
  return ((uv - chart.from) / (chart.to - chart.from) - chart_margin) / (1 - 2 * chart_margin);
}

// Where a fold is tighter than triangles are, the form's own normal may look away from them: there the normal is the mean of
// the triangles around, by their areas.
void turn_to_faces(Mesh& mesh) {
  const auto face = [&](size_t first) {
    const glm::vec3 &a = mesh.vertices[mesh.indices[first]].position, &b = mesh.vertices[mesh.indices[first + 1]].position,
                    &c = mesh.vertices[mesh.indices[first + 2]].position;
    return glm::cross(b - a, c - a);
  };
  std::vector<glm::vec3> around(mesh.vertices.size());
  for (size_t i = 0; i < mesh.indices.size(); i += 3)
    for (size_t k = 0; k < 3; ++k) around[mesh.indices[i + k]] += face(i);
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    glm::vec3 normals(0);
    for (size_t k = 0; k < 3; ++k) normals += mesh.vertices[mesh.indices[i + k]].normal;
    if (glm::dot(face(i), normals) > 0) continue;
    for (size_t k = 0; k < 3; ++k) mesh.vertices[mesh.indices[i + k]].normal = glm::normalize(around[mesh.indices[i + k]]);
  }
}

}  // namespace

HeadPlace head_place(glm::vec2 uv) {
  size_t chart = 0;
  if (uv.y >= head_charts[1].from.y) chart = uv.x < 0.25f ? 1 : uv.x < 0.5f ? 2 : 3;
  const glm::vec3 position = place_on(head_charts[chart].part, within_chart(head_charts[chart], uv));
  return {position, regions_of(head_charts[chart].part, position)};
}

Mesh head_mesh(uint32_t detail) {
  Mesh mesh;
  for (const HeadChart& chart : head_charts) {
    const bool ear = chart.part == HeadChart::Part::left_ear || chart.part == HeadChart::Part::right_ear;
    const uint32_t columns = chart.part == HeadChart::Part::head ? detail + 1 : (ear ? detail / 3 : detail / 4) + 1;
    const uint32_t rows = chart.part == HeadChart::Part::head ? detail * 3 / 4 + 1 : columns * 3 / 4;
    const bool mirrored = chart.part == HeadChart::Part::left_ear;  // its x runs forward
    const auto first = static_cast<uint32_t>(mesh.indices.size());
    add_grid(mesh, columns, rows, [&](uint32_t column, uint32_t row) -> Vertex {
      const glm::vec2 t = glm::vec2(column, row) / glm::vec2(columns - 1, rows - 1);
      const glm::vec2 closed(column + 1 == columns ? 0 : t.x, t.y);  // both ends of a row are one place
      constexpr float turn = 1e-3f;
      const glm::vec3 position = place_on(chart.part, closed);
      const glm::vec3 right =
          place_on(chart.part, closed + glm::vec2(turn, 0)) - place_on(chart.part, closed - glm::vec2(turn, 0));
      const glm::vec3 down =
          place_on(chart.part, closed + glm::vec2(0, turn)) - place_on(chart.part, closed - glm::vec2(0, turn));
      const glm::vec3 normal = glm::normalize(glm::cross(down, right)) * (mirrored ? -1.0f : 1.0f);
      return {position, normal, glm::vec4(0),
              chart.from + (chart.to - chart.from) * (chart_margin + (1 - 2 * chart_margin) * t)};
    });
    if (mirrored)
      for (size_t i = first; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  }
  turn_to_faces(mesh);
  compute_tangents(mesh);
  return mesh;
}

}  // namespace lamina
