// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/rough_refraction/scene_behind.h"

#include <algorithm>
#include <limits>

#include "harness/bake/embree_scene.h"

namespace lamina {
namespace {

// Lets a ray through faces that look away from where it comes from, as devices leave them out.
void keep_fronts(const RTCFilterFunctionNArguments* arguments) {
  if (arguments->valid[0] != -1) return;
  const auto at = [&](auto get) { return double(get(arguments->hit, arguments->N, 0)); };
  const glm::dvec3 normal(at([](auto... p) { return RTCHitN_Ng_x(p...); }), at([](auto... p) { return RTCHitN_Ng_y(p...); }),
                          at([](auto... p) { return RTCHitN_Ng_z(p...); }));
  const glm::dvec3 direction(RTCRayN_dir_x(arguments->ray, arguments->N, 0), RTCRayN_dir_y(arguments->ray, arguments->N, 0),
                             RTCRayN_dir_z(arguments->ray, arguments->N, 0));
  if (glm::dot(normal, direction) >= 0) arguments->valid[0] = 0;
}

}  // namespace

struct SceneBehind::Faces : EmbreeScene {
  std::vector<size_t> objects;  // by Embree's geometry
  Faces() : EmbreeScene("truth", RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION) {}
};

SceneBehind::SceneBehind(const Scene& scene)
    : scene_(scene), glass_(std::make_unique<Faces>()), opaque_(std::make_unique<Faces>()), albedos_(scene.objects.size()) {
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const bool of_glass = glass_slab(object).has_value();
    if (!of_glass && !object.solid) continue;
    Faces& into = of_glass ? *glass_ : *opaque_;
    into.attach(object);
    into.objects.push_back(i);
    if (!of_glass) albedos_[i] = std::make_unique<FilteredTexture>(*object.effects.at("surface").textures.at("albedo"));
  }
  glass_->commit();
  opaque_->commit();
}

SceneBehind::~SceneBehind() = default;

std::optional<SurfaceHit> SceneBehind::nearest(const Faces& faces, glm::dvec3 from, glm::dvec3 direction) const {
  const RTCRayHit ray = faces.first_hit(from, direction, keep_fronts);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const size_t index = faces.objects[ray.hit.geomID];
  const Object& object = scene_.objects[index];
  const uint32_t* corner = &object.mesh.indices[3 * size_t(ray.hit.primID)];
  const double b = double(ray.hit.u), c = double(ray.hit.v), a = 1 - b - c;
  const auto mixed = [&](auto of) {
    return a * of(object.mesh.vertices[corner[0]]) + b * of(object.mesh.vertices[corner[1]]) +
           c * of(object.mesh.vertices[corner[2]]);
  };
  const glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(object.world_from_object)));
  return SurfaceHit{index, double(ray.ray.tfar), from + direction * double(ray.ray.tfar),
                    glm::normalize(normals * mixed([](const Vertex& v) { return glm::dvec3(v.normal); })),
                    mixed([](const Vertex& v) { return glm::dvec2(v.uv); })};
}

std::optional<SurfaceHit> SceneBehind::glass(glm::dvec3 from, glm::dvec3 direction) const {
  const auto hit = nearest(*glass_, from, direction);
  if (!hit) return std::nullopt;
  const auto before = nearest(*opaque_, from, direction);
  return before && before->distance_m < hit->distance_m ? std::nullopt : hit;
}

std::optional<SurfaceHit> SceneBehind::opaque(glm::dvec3 from, glm::dvec3 direction) const {
  return nearest(*opaque_, from, direction);
}

glm::dvec3 SceneBehind::light(const std::optional<SurfaceHit>& hit) const {
  if (!hit) return glm::dvec3(scene_.background);
  glm::dvec3 sum(scene_.ambient);
  for (const Light& light : scene_.lights) {
    const bool point = light.kind == Light::Kind::point;
    const glm::dvec3 towards = point ? glm::dvec3(light.position) - hit->position : -glm::dvec3(light.direction);
    const double squared = glm::dot(towards, towards), cosine = glm::dot(hit->normal, towards) / std::sqrt(squared);
    sum += glm::dvec3(light.radiance) * (std::max(cosine, 0.0) / (point ? squared : 1));
  }
  return glm::dvec3(albedos_[hit->object]->at(hit->uv, hit->uv, hit->uv)) * sum;
}

}  // namespace lamina
