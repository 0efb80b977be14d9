// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/hair/card_rays.h"

#include <algorithm>
#include <limits>

#include "harness/bake/embree_scene.h"

namespace lamina {
namespace {

struct CardContext {
  RTCIntersectContext embree;                             // first: Embree hands back its address
  std::vector<std::pair<unsigned, unsigned>>* triangles;  // geometry, triangle
};

void keep_card(const RTCFilterFunctionNArguments* arguments) {
  if (arguments->valid[0] != -1) return;
  auto* context = reinterpret_cast<CardContext*>(arguments->context);
  context->triangles->emplace_back(RTCHitN_geomID(arguments->hit, arguments->N, 0),
                                   RTCHitN_primID(arguments->hit, arguments->N, 0));
  arguments->valid[0] = 0;
}

RTCRayHit ray_from(glm::dvec3 eye, glm::dvec3 direction) {
  RTCRayHit ray{};
  ray.ray = {float(eye.x),
             float(eye.y),
             float(eye.z),
             0,
             float(direction.x),
             float(direction.y),
             float(direction.z),
             0,
             std::numeric_limits<float>::infinity(),
             ~0u,
             0,
             0};
  ray.hit.geomID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return ray;
}

// Weights of b and c where the ray meets the triangle's plane, and the distance.
struct PlaneHit {
  double b, c, distance_m;
};
PlaneHit plane_hit(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 eye, glm::dvec3 direction) {
  const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(direction, ac), from = eye - a, q = glm::cross(from, ab);
  const double scale = 1 / glm::dot(ab, p);
  return {glm::dot(from, p) * scale, glm::dot(direction, q) * scale, glm::dot(ac, q) * scale};
}

}  // namespace

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
  std::vector<std::pair<unsigned, unsigned>> triangles;
  CardContext context;
  rtcInitIntersectContext(&context.embree);
  context.embree.filter = keep_card;
  context.triangles = &triangles;
  RTCRayHit through = ray_from(eye, direction);
  rtcIntersect1(cards_->scene, &context.embree, &through);
  if (triangles.empty()) return {};
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  RTCIntersectContext plain;
  rtcInitIntersectContext(&plain);
  RTCRayHit first = ray_from(eye, direction);
  rtcIntersect1(opaque_->scene, &plain, &first);
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
