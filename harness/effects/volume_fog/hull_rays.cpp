// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/volume_fog/hull_rays.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "harness/bake/embree_scene.h"

namespace lamina {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Crossing {
  double distance_m;
  int side;  // +1 where the ray leaves the hull, -1 where it enters
};

int side_sum(const std::vector<Crossing>& crossings) {
  int sum = 0;
  for (const Crossing& crossing : crossings) sum += crossing.side;
  return sum;
}

// How far to the left of the edge the ray passes, in metres; edges are not far from square to it.
double left_m(const FogRay& ray, glm::dvec3 from, glm::dvec3 to) {
  return glm::dot(ray.direction, glm::cross(from - ray.origin, to - ray.origin)) / glm::length(to - from);
}

// A direction next to this one, by `angle` radians; `turn` chooses which.
glm::dvec3 nudged(glm::dvec3 direction, double angle, int turn) {
  const glm::dvec3 other = std::abs(direction.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(direction, other)), up = glm::cross(right, direction);
  const double at = 2 * std::numbers::pi * turn / 7;
  return glm::normalize(direction + angle * (std::cos(at) * right + std::sin(at) * up));
}

}  // namespace

struct HullRays::Scenery : EmbreeScene {
  std::vector<glm::dvec3> corners;  // three a triangle, as Embree has them
  using EmbreeScene::EmbreeScene;

  // All crossings of the ray from its origin on. Embree finds the triangles; where they are crossed is computed anew in
  // doubles. `at_edge` becomes true where the ray runs through an edge, and crossings are not to be trusted.
  std::vector<Crossing> crossings(const FogRay& ray, bool& at_edge) const {
    std::vector<Crossing> found;
    for (const auto& [geometry, triangle] : triangles_along(ray.origin, ray.direction)) {
      const glm::dvec3 a = corners[3 * triangle], b = corners[3 * triangle + 1], c = corners[3 * triangle + 2];
      // Embree's triangles may be those beside an edge too.
      const double beside[] = {left_m(ray, a, b), left_m(ray, b, c), left_m(ray, c, a)};
      const auto [least, most] = std::minmax({beside[0], beside[1], beside[2]});
      const double near_m = 1e-7 * glm::length(a - ray.origin);
      if (least < -near_m && most > near_m) continue;  // well outside
      for (const double metres : beside) at_edge = at_edge || std::abs(metres) < near_m;
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      const double towards = glm::dot(ray.direction, normal);
      if (towards != 0) found.push_back({glm::dot(a - ray.origin, normal) / towards, towards > 0 ? 1 : -1});
    }
    return found;
  }
};

HullRays::HullRays(const std::vector<const Object*>& objects) {
  auto made = std::make_shared<Scenery>("truth", RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  for (const Object* object : objects)
    for (const uint32_t index : object->mesh.indices) {
      const glm::vec3 world = object->world_from_object * glm::vec4(object->mesh.vertices[index].position, 1);
      made->corners.emplace_back(world);
    }
  const size_t triangles = made->corners.size() / 3;
  if (triangles > 0)
    made->attach(3 * triangles, triangles, "hulls", [&](const EmbreeScene::Triangles& held) {
      for (size_t i = 0; i < 3 * triangles; ++i) {
        for (int axis = 0; axis < 3; ++axis) held.positions[3 * i + axis] = static_cast<float>(made->corners[i][axis]);
        held.indices[i] = static_cast<uint32_t>(i);
      }
    });
  made->commit();
  scenery_ = std::move(made);
}

int HullRays::around(glm::dvec3 point) const {
  // What most of a few rays say.
  std::map<int, int> votes;
  for (int i = 0; i < 15; ++i) {
    const double z = 1 - (2 * i + 1) / 15.0, turn = 2.4 * i, r = std::sqrt(1 - z * z);
    bool at_edge = false;
    const std::vector<Crossing> crossings = scenery_->crossings({point, {r * std::cos(turn), r * std::sin(turn), z}}, at_edge);
    if (!at_edge || i == 0) ++votes[side_sum(crossings)];
  }
  return std::ranges::max_element(votes, {}, [](const auto& vote) { return vote.second; })->first;
}

double HullRays::length_m(const FogRay& ray, double end_m, int around_origin) const {
  bool at_edge = false;
  std::vector<Crossing> crossings = scenery_->crossings(ray, at_edge);
  for (int turn = 0; turn < 7 && (at_edge || side_sum(crossings) != around_origin); ++turn) {
    at_edge = false;
    crossings = scenery_->crossings({ray.origin, nudged(ray.direction, 1e-6, turn)}, at_edge);
  }
  double sum = 0;
  for (const Crossing& crossing : crossings) sum += crossing.side * std::min(crossing.distance_m, end_m);
  return sum;
}

double HullRays::first_front_m(const FogRay& ray) const {
  double first = infinity;
  bool at_edge = false;  // of two triangles, either will do
  for (const Crossing& crossing : scenery_->crossings(ray, at_edge))
    if (crossing.side < 0 && crossing.distance_m > 0) first = std::min(first, crossing.distance_m);
  return first;
}

}  // namespace lamina
