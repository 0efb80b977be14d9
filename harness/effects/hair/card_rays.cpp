// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/hair/card_rays.h"

#include <algorithm>
#include <limits>

#include "harness/bake/embree_scene.h"
#include "harness/truth/plane_hit.h"

namespace lamina {

struct CardRays::Cards : EmbreeScene {
  std::vector<size_t> objects;  // by Embree's geometry
  explicit Cards(RTCSceneFlags flags) : EmbreeScene("truth", flags) {}
};

CardRays::CardRays(const Scene& scene)
    : scene_(scene),
      cards_(std::make_unique<Cards>(RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION)),
      opaque_(std::make_unique<Cards>(RTC_SCENE_FLAG_NONE)) {
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    Cards* into = scene.objects[i].effects.contains("hair") ? cards_.get() : scene.objects[i].solid ? opaque_.get() : nullptr;
    if (!into) continue;
    into->attach(scene.objects[i]);
    into->objects.push_back(i);
  }
  cards_->commit();
  opaque_->commit();
}

CardRays::~CardRays() = default;

std::vector<CardHit> CardRays::hits(glm::dvec3 eye, glm::dvec3 direction, glm::dvec3 right, glm::dvec3 down) const {
  const std::vector<EmbreeScene::TriangleId> triangles = cards_->triangles_along(eye, direction);
  if (triangles.empty()) return {};
  const RTCRayHit first = opaque_->first_hit(eye, direction);
  const double end = first.hit.geomID == RTC_INVALID_GEOMETRY_ID ? std::numeric_limits<double>::infinity() : first.ray.tfar;
  std::vector<CardHit> found;
  for (const auto& [geometry, triangle] : triangles) {
    const size_t index = cards_->objects[geometry];
    const Object& object = scene_.objects[index];
    const Vertex* vertex[3];
    glm::dvec3 world[3];
    for (size_t k = 0; k < 3; ++k) {
      vertex[k] = &object.mesh.vertices[object.mesh.indices[3 * triangle + k]];
      world[k] = glm::dvec3(object.world_from_object * glm::vec4(vertex[k]->position, 1));
    }
    const PlaneHit at = plane_hit(world[0], world[1], world[2], eye, direction);
    constexpr double edge = 1e-9;  // Embree's triangles may be those beside an edge too
    if (!(at.distance_m > 0) || at.distance_m >= end || at.b < -edge || at.c < -edge || at.b + at.c > 1 + edge) continue;
    const auto mixed = [&](const PlaneHit& weights, auto of) {
      return of(*vertex[0]) * (1 - weights.b - weights.c) + of(*vertex[1]) * weights.b + of(*vertex[2]) * weights.c;
    };
    const auto uv = [](const Vertex& v) { return glm::dvec2(v.uv); };
    const glm::dmat3 linear(object.world_from_object), normals = glm::transpose(glm::inverse(linear));
    const double mirrored = glm::determinant(linear) < 0 ? -1 : 1;
    const glm::dvec4 tangent = mixed(at, [](const Vertex& v) { return glm::dvec4(v.tangent); });
    found.push_back({index, at.distance_m, eye + direction * at.distance_m,
                     normals * mixed(at, [](const Vertex& v) { return glm::dvec3(v.normal); }),
                     glm::dvec4(linear * glm::dvec3(tangent), tangent.w * mirrored), mixed(at, uv),
                     mixed(plane_hit(world[0], world[1], world[2], eye, right), uv),
                     mixed(plane_hit(world[0], world[1], world[2], eye, down), uv)});
  }
  std::ranges::sort(found, {}, &CardHit::distance_m);
  // Through an edge that two triangles of a card share there is one hit.
  const auto same = [](const CardHit& a, const CardHit& b) {
    return a.object == b.object && b.distance_m - a.distance_m < 1e-9 * a.distance_m && glm::length(a.uv - b.uv) < 1e-7;
  };
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
  return found;
}

}  // namespace lamina
