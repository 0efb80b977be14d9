// SPDX-License-Identifier: Apache-2.0
// See hair_cards.h.
#include "harness/scene/made/hair_cards.h"

#include <algorithm>
#include <cmath>

#include "harness/scene/made/noise.h"
#include "harness/scene/made/strand_texture.h"
#include "harness/scene/mesh/tangents.h"

namespace lamina {
namespace {

constexpr uint32_t hair_layers = 5, card_segments = 12;
constexpr glm::vec3 parting{0.018f, 0, 0};

// 1 on the head's surface, more outside.
float outside_of(glm::vec3 p) { return glm::length(p / hair_head_half_m); }

// Away from the head; below its widest, straight out from the neck's axis.
glm::vec3 away_from_head(glm::vec3 p) {
  const glm::vec3 scaled = p / (hair_head_half_m * hair_head_half_m);
  return glm::normalize(glm::vec3(scaled.x, std::max(scaled.y, 0.0f), scaled.z) + glm::vec3(0, 1e-6f, 0));
}

struct CardCourse {
  glm::vec3 points[card_segments + 1];
};

// `loose`: how far strands stray, 0 to 1. From the root on: combed sideways from the parting and back, then falling, never into
// the head.
CardCourse comb(glm::vec3 root, float lift, float length_m, float loose, Random& random) {
  constexpr int substeps = 4;
  const float step = length_m / (card_segments * substeps);
  const float side = (root.x > parting.x ? 1.0f : -1.0f) * glm::smoothstep(-0.09f, -0.03f, root.z), curl = random.next(),
              wave_m = 0.0015f + 0.003f * random.next();
  const float sideways = 0.75f + 0.4f * random.next(), backwards = 0.55f + 0.5f * random.next();
  glm::vec3 p = root, along = glm::normalize(glm::vec3(side * sideways, 0.1f, -backwards));
  CardCourse course;
  for (uint32_t segment = 0; segment <= card_segments; ++segment) {
    const float t = static_cast<float>(segment) / card_segments;
    const glm::vec3 out = away_from_head(p), across = glm::normalize(glm::cross(along, out));
    course.points[segment] = p + across * (loose * wave_m * t * std::sin(2 * static_cast<float>(M_PI) * (1.6f * t + curl))) +
                             out * (0.005f * loose * t * t * curl);
    for (int i = 0; i < substeps; ++i) {
      const glm::vec3 normal = away_from_head(p);
      glm::vec3 pull = glm::vec3(0, -1, -0.12f);
      if (p.z > 0.02f && p.y < 0.06f) pull += glm::vec3(0.5f * side, 0, -1.6f);  // the face stays free
      along = glm::normalize(along + 0.16f * pull);
      if (outside_of(p) < 1.03f + lift / hair_head_half_m.x)
        along = glm::normalize(along - normal * std::min(glm::dot(along, normal), 0.0f));
      p += along * step;
      // A root lies under what grows above it; the strand rises from there.
      const float least = 1 + lift * (0.15f + 0.85f * glm::smoothstep(0.0f, 0.3f, t)) / hair_head_half_m.x;
      if (const float now = outside_of(p); now < least) p *= least / now;
      // Beneath the skull hair hangs around the neck.
      const float from_axis = std::hypot(p.x, p.z + 0.02f), neck = 0.062f + lift;
      if (p.y < -0.05f && from_axis < neck) p.x *= neck / from_axis, p.z = (p.z + 0.02f) * neck / from_axis - 0.02f;
    }
  }
  return course;
}

void add_card(Mesh& mesh, const CardCourse& course, float width_m, uint32_t clump, float tilt) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  for (uint32_t segment = 0; segment <= card_segments; ++segment) {
    const glm::vec3 *points = course.points, p = points[segment];
    const glm::vec3 along =
        glm::normalize(points[std::min(segment + 1, card_segments)] - points[segment > 0 ? segment - 1 : 0]);
    const glm::vec3 out = away_from_head(p);
    const glm::vec3 across = glm::normalize(glm::cross(along, glm::normalize(out + tilt * glm::cross(along, out))));
    const glm::vec3 normal = glm::normalize(glm::cross(across, along));
    const float t = static_cast<float>(segment) / card_segments,
                half = width_m * (0.46f + 0.16f * std::sin(3 * t) - 0.14f * t * t);
    for (const float end : {-1.0f, 1.0f}) {
      // The edge of a texture's clump is empty: cards may overlap the head a little.
      const glm::vec3 rounded = glm::normalize(normal + 0.35f * end * across);
      mesh.vertices.push_back({p + across * (half * end),
                               rounded,
                               glm::vec4(0),
                               {(static_cast<float>(clump) + 0.5f + 0.48f * end) / strand_clumps, 0.002f + 0.996f * t}});
    }
    if (segment == card_segments) break;
    const uint32_t at = first + 2 * segment;
    for (const uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) mesh.indices.push_back(at + corner);
  }
}

}  // namespace

float hairline(glm::vec3 direction) {
  const float back = std::atan2(std::abs(direction.x), direction.z) / static_cast<float>(M_PI);  // 0 in front, 1 behind
  const float to_side = glm::smoothstep(0.12f, 0.42f, back), to_back = glm::smoothstep(0.45f, 0.8f, back);
  return 0.60f - 0.42f * to_side - 0.62f * to_back;
}

Mesh hair_card_mesh(uint32_t per_layer) {
  Mesh mesh;
  for (uint32_t layer = 0; layer < hair_layers; ++layer) {
    Random random(7 + layer);
    const float lift = 0.0015f + 0.0022f * static_cast<float>(layer);
    // Evenly over the sphere by the golden angle; the directions under the hairline are left out.
    uint32_t made = 0;
    for (uint32_t i = 0; made < per_layer; ++i) {
      const float y = 1 - 2 * std::fmod((static_cast<float>(i) + 0.5f) * 0.7548777f + 0.13f * static_cast<float>(layer), 1.0f);
      const float turn = 2.3999632f * static_cast<float>(i), r = std::sqrt(1 - y * y);
      const glm::vec3 direction(r * std::cos(turn), y, r * std::sin(turn));
      if (y < hairline(direction)) continue;
      ++made;
      const glm::vec3 root = direction * hair_head_half_m * (1 + 0.15f * lift / hair_head_half_m.x);
      const float length_m = hair_card_m.y * (0.8f + 0.4f * random.next()) * (0.78f + 0.22f * glm::smoothstep(-0.4f, 0.6f, y));
      const float loose = static_cast<float>(layer) / (hair_layers - 1);
      const uint32_t clump = layer < 2 ? 0 : 1 + random.below(strand_clumps - 1);
      const float width_m = hair_card_m.x * (0.85f + 0.3f * random.next()) * (layer < 2 ? 1.25f : 1.0f);
      const float higher = lift + 0.0015f * loose * random.next(), tilt = 0.5f * loose * (random.next() - 0.5f);
      add_card(mesh, comb(root, higher, length_m, loose, random), width_m, clump, tilt);
    }
  }
  compute_tangents(mesh);
  return mesh;
}

}  // namespace lamina
