// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/translucency/solids.h"

#include <algorithm>
#include <limits>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/scene/default_views.h"

namespace lamina {
namespace {

std::optional<Medium> medium_of(const Object& object) {
  const auto found = object.effects.find("translucency");
  if (found == object.effects.end()) return std::nullopt;
  const auto& numbers = found->second.numbers;
  return Medium{{numbers.at("extinction_red"), numbers.at("extinction_green"), numbers.at("extinction_blue")},
                numbers.at("refraction_index"),
                numbers.at("multiple_scattering"),
                numbers.at("wrap")};
}

// What a ray collects instead of stopping.
struct AllHits {
  RTCIntersectContext context;  // first: Embree hands back a pointer to it
  std::vector<RTCRayHit>* hits;
};

void collect(const RTCFilterFunctionNArguments* arguments) {
  auto* all = reinterpret_cast<AllHits*>(arguments->context);
  RTCRayHit hit;
  hit.ray = rtcGetRayFromRayN(arguments->ray, arguments->N, 0);
  hit.hit = rtcGetHitFromHitN(arguments->hit, arguments->N, 0);
  all->hits->push_back(hit);
  arguments->valid[0] = 0;  // and on it goes
}

}  // namespace

Solids::Solids(const Scene& scene) : scene_(scene), embree_("truth", RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION) {
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    media_.push_back(medium_of(object));
    if (object.mesh.indices.empty() || !object.blocks_light) continue;
    embree_.attach(object);
    object_of_.push_back(i);
  }
  embree_.commit();
  radius_m_ = bounding_sphere(scene.objects).radius;
}

SurfaceCrossing Solids::crossing(const RTCRayHit& hit) const {
  const size_t index = object_of_[hit.hit.geomID];
  const Object& object = scene_.objects[index];
  const uint32_t* corner = &object.mesh.indices[size_t{3} * hit.hit.primID];
  const auto normal = [&](int i) { return glm::dvec3(object.mesh.vertices[corner[i]].normal); };
  const double u = double(hit.hit.u), v = double(hit.hit.v);
  const glm::dmat3 linear(object.world_from_object);
  const bool mirrored = glm::determinant(linear) < 0;
  const glm::dvec3 flat = glm::normalize(glm::dvec3(hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z) * (mirrored ? -1.0 : 1.0));
  glm::dvec3 smooth = glm::transpose(glm::inverse(linear)) * ((1 - u - v) * normal(0) + u * normal(1) + v * normal(2));
  const double length = glm::length(smooth);
  smooth = length > 1e-9 ? smooth / length : flat;
  const glm::dvec3 direction(hit.ray.dir_x, hit.ray.dir_y, hit.ray.dir_z);
  return {double(hit.ray.tfar), index, glm::dot(direction, flat) < 0, smooth};
}

std::vector<SurfaceCrossing> Solids::crossings(glm::dvec3 origin, glm::dvec3 direction, double most) const {
  thread_local std::vector<RTCRayHit> hits;
  hits.clear();
  AllHits all;
  rtcInitIntersectContext(&all.context);
  all.context.filter = collect;
  all.hits = &hits;
  RTCRayHit ray = EmbreeScene::ray_from(origin, direction);
  ray.ray.tfar = static_cast<float>(std::min(most, 1e30));
  rtcIntersect1(embree_.scene, &all.context, &ray);
  std::vector<SurfaceCrossing> found;
  for (const RTCRayHit& hit : hits) found.push_back(crossing(hit));
  std::ranges::sort(found, {}, &SurfaceCrossing::distance);
  const double same = 1e-6 * radius_m_;
  const auto repeated = [&](const SurfaceCrossing& a, const SurfaceCrossing& b) {
    return a.object == b.object && a.entering == b.entering && b.distance - a.distance < same;
  };
  found.erase(std::unique(found.begin(), found.end(), repeated), found.end());
  return found;
}

std::optional<SurfaceCrossing> Solids::way_out(glm::dvec3 origin, glm::dvec3 direction, size_t object) const {
  RTCRayHit ray = EmbreeScene::ray_from(origin, direction);
  for (int tries = 0; tries < 8; ++tries) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(embree_.scene, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    const SurfaceCrossing found = crossing(ray);
    if (found.object == object && !found.entering) return found;
    // Grazing the surface that it starts from, or another object: on from there.
    const double from = found.distance;
    ray = EmbreeScene::ray_from(origin, direction);
    ray.ray.tnear = std::nextafter(static_cast<float>(from), std::numeric_limits<float>::max());
  }
  return std::nullopt;
}

}  // namespace lamina
