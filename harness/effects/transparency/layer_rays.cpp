// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/transparency/layer_rays.h"

#include <algorithm>

#include "harness/bake/embree_scene.h"
#include "harness/truth/plane_hit.h"

namespace lamina {
namespace {

constexpr double edge_tolerance = 1e-7;  // of barycentric coordinates: Embree's single precision may say less
constexpr double same_distance = 1e-9;   // of the distance

}  // namespace

struct LayerRays::Scenery : EmbreeScene {
  // What an object is to rays.
  struct Known {
    size_t object;
    bool transparent, opaque_everywhere;
  };
  const Scene* of = nullptr;
  std::vector<Known> objects;  // by Embree's geometry
  std::vector<glm::dmat4> world_from_object;
  std::vector<glm::dmat3> world_from_normal;
  using EmbreeScene::EmbreeScene;

  static std::optional<Known> known(const Scene& scene, size_t index) {
    const Object& object = scene.objects[index];
    if (object.mesh.indices.empty()) return std::nullopt;
    const auto effect = object.effects.find("transparency");
    if (effect == object.effects.end()) return object.solid ? std::optional(Known{index, false, false}) : std::nullopt;
    const bool whole = effect->second.numbers.at("opacity") >= 1 && fact_or_number(effect->second, "least_mask") >= 1;
    return Known{index, true, whole};
  }

  // The ray against one triangle.
  std::optional<LayerHit> hit(const TriangleId& which, glm::dvec3 origin, glm::dvec3 direction) const {
    const Known& object = objects[which.geometry];
    const Mesh& mesh = of->objects[object.object].mesh;
    const glm::dmat4& place = world_from_object[which.geometry];
    const Vertex* corners[3];
    glm::dvec3 at[3];
    for (size_t i = 0; i < 3; ++i) {
      corners[i] = &mesh.vertices[mesh.indices[3 * which.triangle + i]];
      at[i] = glm::dvec3(place * glm::dvec4(glm::dvec3(corners[i]->position), 1));
    }
    const auto [u, v, distance_m, facing] = plane_hit(at[0], at[1], at[2], origin, direction);
    if (facing == 0 || (!object.transparent && facing < 0)) return std::nullopt;
    if (u < -edge_tolerance || v < -edge_tolerance || u + v > 1 + edge_tolerance || !(distance_m > 0)) return std::nullopt;
    LayerHit found;
    found.distance_m = distance_m;
    found.object = object.object, found.transparent = object.transparent;
    found.position = origin + found.distance_m * direction;
    const double weights[] = {1 - u - v, u, v};
    glm::dvec3 normal(0);
    for (size_t i = 0; i < 3; ++i) {
      normal += weights[i] * glm::dvec3(corners[i]->normal);
      found.uv += weights[i] * glm::dvec2(corners[i]->uv);
    }
    found.normal = glm::normalize(world_from_normal[which.geometry] * normal);
    found.cosine = -glm::dot(found.normal, direction);
    if (found.cosine < 0) found.normal = -found.normal, found.cosine = -found.cosine;
    return found;
  }
};

LayerRays::LayerRays(const Scene& scene) {
  auto made = std::make_shared<Scenery>("truth", RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  made->of = &scene;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const auto object = Scenery::known(scene, i);
    if (!object) continue;
    made->attach(scene.objects[i]);
    made->objects.push_back(*object);
    made->world_from_object.emplace_back(scene.objects[i].world_from_object);
    made->world_from_normal.push_back(glm::transpose(glm::inverse(glm::dmat3(scene.objects[i].world_from_object))));
  }
  made->commit();
  scenery_ = std::move(made);
}

std::vector<LayerHit> LayerRays::hits(glm::dvec3 origin, glm::dvec3 direction) const {
  std::vector<LayerHit> found;
  for (const EmbreeScene::TriangleId& triangle : scenery_->triangles_along(origin, direction))
    if (const auto hit = scenery_->hit(triangle, origin, direction)) found.push_back(*hit);
  std::ranges::stable_sort(found, {}, &LayerHit::distance_m);
  std::vector<LayerHit> kept;
  for (const LayerHit& hit : found) {
    const bool seen = std::ranges::any_of(kept, [&](const LayerHit& before) {
      return before.object == hit.object && hit.distance_m - before.distance_m <= same_distance * hit.distance_m;
    });
    if (seen) continue;
    kept.push_back(hit);
    const auto what = std::ranges::find(scenery_->objects, hit.object, &Scenery::Known::object);
    if (hit.transparent && what->opaque_everywhere) kept.back().transparent = false;
    if (!kept.back().transparent) break;
  }
  return kept;
}

}  // namespace lamina
