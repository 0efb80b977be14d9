// SPDX-License-Identifier: Apache-2.0
// See heart_vessels.h.
#include "harness/scene/made/heart_vessels.h"

#include <algorithm>
#include <cmath>

#include "harness/scene/made/heart_shape.h"
#include "harness/scene/made/noise.h"

namespace lamina {
namespace {

constexpr float cell_size = 0.06f;  // about two pieces long: most cells hold a handful

struct Node {
  glm::vec3 at;
  int parent;  // -1 at a root; else less than the node's own number
};

void lay_course(std::vector<Node>& nodes, const std::vector<glm::vec3>& course, const VesselPlan& plan) {
  int parent = -1;
  for (size_t i = 0; i + 1 < course.size(); ++i) {
    const int pieces = std::max(1, static_cast<int>(std::ceil(glm::distance(course[i], course[i + 1]) / plan.step)));
    for (int k = i == 0 ? 0 : 1; k <= pieces; ++k) {
      const glm::vec3 straight = glm::mix(course[i], course[i + 1], static_cast<float>(k) / static_cast<float>(pieces));
      // Meanders of about 16 cm.
      const glm::vec3 q = straight * 6.0f;
      const glm::vec3 aside(gradient_noise(q, plan.seed), gradient_noise(q, plan.seed + 1), gradient_noise(q, plan.seed + 2));
      nodes.push_back({onto_heart(straight + 0.16f * plan.wander * aside, 1, 4), parent});
      parent = static_cast<int>(nodes.size()) - 1;
    }
  }
}

}  // namespace

std::vector<VesselPiece> grow_vessels(const VesselPlan& plan) {
  std::vector<Node> nodes;
  for (const std::vector<glm::vec3>& course : plan.courses) lay_course(nodes, course, plan);

  struct Hungry {
    glm::vec3 at;
    int nearest;
    float distance;
  };
  std::vector<Hungry> hungry;
  for (const glm::vec3 at : plan.supplied) hungry.push_back({at, 0, 1e9f});
  Random random(plan.seed);
  size_t seen = 0;  // nodes before this one are known to the hungry points
  // Every round brings some point nearer by about a step; no point is farther than a few metres.
  for (int round = 0; round < 400 && !hungry.empty(); ++round) {
    for (Hungry& h : hungry)
      for (size_t i = seen; i < nodes.size(); ++i) {
        const float d = glm::distance(h.at, nodes[i].at);
        if (d < h.distance) h = {h.at, static_cast<int>(i), d};
      }
    seen = nodes.size();
    std::erase_if(hungry, [&plan](const Hungry& h) { return h.distance < plan.supply; });

    std::vector<glm::vec3> pull(nodes.size(), glm::vec3(0));
    for (const Hungry& h : hungry) pull[h.nearest] += (h.at - nodes[h.nearest].at) / h.distance;
    const size_t grown = nodes.size();
    for (size_t i = 0; i < grown; ++i) {
      if (glm::dot(pull[i], pull[i]) < 1e-6f) continue;
      const glm::vec3 aside(random.next() - 0.5f, random.next() - 0.5f, random.next() - 0.5f);
      const glm::vec3 direction = glm::normalize(glm::normalize(pull[i]) + 2 * plan.wander * aside);
      const glm::vec3 at = onto_heart(nodes[i].at + plan.step * direction, 1, 2);
      nodes.push_back({at, static_cast<int>(i)});
    }
    if (nodes.size() == grown) break;
  }

  std::vector<float> cubes(nodes.size(), 0);
  for (size_t i = nodes.size(); i-- > 0;) {
    cubes[i] = std::max(cubes[i], plan.tip_radius * plan.tip_radius * plan.tip_radius);
    if (nodes[i].parent >= 0) cubes[nodes[i].parent] += cubes[i];
  }
  std::vector<VesselPiece> pieces;
  for (size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].parent >= 0) {
      const size_t parent = static_cast<size_t>(nodes[i].parent);
      // A branch starts with its own radius, not with the trunk's.
      const float own = std::cbrt(cubes[i]);
      pieces.push_back({nodes[parent].at, nodes[i].at, std::min(std::cbrt(cubes[parent]), 1.15f * own), own});
    }
  return pieces;
}

VesselMap::VesselMap(std::vector<VesselPiece> pieces, float reach) : pieces_(std::move(pieces)), reach_(reach) {
  glm::vec3 low(1e9f), high(-1e9f);
  const auto margin = [this](const VesselPiece& p) { return std::max(p.from_radius, p.to_radius) + reach_; };
  for (const VesselPiece& p : pieces_) {
    low = glm::min(low, glm::min(p.from, p.to) - margin(p));
    high = glm::max(high, glm::max(p.from, p.to) + margin(p));
  }
  low_ = low;
  cells_ = pieces_.empty() ? glm::ivec3(0) : glm::ivec3((high - low) / cell_size) + 1;
  first_.assign(static_cast<size_t>(cells_.x) * cells_.y * cells_.z + 1, 0);
  const auto each_cell = [&](const VesselPiece& p, auto&& visit) {
    const glm::ivec3 from((glm::min(p.from, p.to) - margin(p) - low_) / cell_size);
    const glm::ivec3 to((glm::max(p.from, p.to) + margin(p) - low_) / cell_size);
    for (int z = from.z; z <= to.z; ++z)
      for (int y = from.y; y <= to.y; ++y)
        for (int x = from.x; x <= to.x; ++x) visit(cell_of({x, y, z}));
  };
  // Count, sum up, then fill backwards: a counting sort.
  for (const VesselPiece& p : pieces_) each_cell(p, [&](size_t cell) { ++first_[cell]; });
  for (size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  entries_.resize(first_.back());
  for (size_t i = pieces_.size(); i-- > 0;)
    each_cell(pieces_[i], [&](size_t cell) { entries_[--first_[cell]] = static_cast<uint32_t>(i); });
}

size_t VesselMap::cell_of(glm::ivec3 at) const { return (static_cast<size_t>(at.z) * cells_.y + at.y) * cells_.x + at.x; }

VesselMap::Hit VesselMap::nearest(glm::vec3 p) const {
  Hit hit;
  const glm::vec3 q = (p - low_) / cell_size;
  const glm::ivec3 at(glm::floor(q));
  if (glm::any(glm::lessThan(at, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(at, cells_))) return hit;
  const size_t cell = cell_of(at);
  for (uint32_t e = first_[cell]; e < first_[cell + 1]; ++e) {
    const VesselPiece& piece = pieces_[entries_[e]];
    const glm::vec3 along = piece.to - piece.from, to_p = p - piece.from;
    const float t = std::clamp(glm::dot(to_p, along) / std::max(glm::dot(along, along), 1e-12f), 0.0f, 1.0f);
    const float radius = piece.from_radius + t * (piece.to_radius - piece.from_radius);
    const float gap = glm::length(to_p - t * along) - radius;
    if (gap < hit.gap && gap < reach_) hit = {gap, radius};
  }
  return hit;
}

}  // namespace lamina
