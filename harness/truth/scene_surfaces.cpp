// SPDX-License-Identifier: Apache-2.0
#include "harness/truth/scene_surfaces.h"

#include <algorithm>
#include <limits>

#include "harness/bake/embree_scene.h"
#include "harness/truth/plane_hit.h"

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

struct SceneSurfaces::Faces : EmbreeScene {
  std::vector<size_t> objects;  // by Embree's geometry
  Faces() : EmbreeScene("truth", RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION) {}
};

SceneSurfaces::SceneSurfaces(const Scene& scene, const std::function<bool(const Object&)>& chosen,
                             const std::function<const Texture&(const Object&)>& albedo)
    : scene_(scene), chosen_(std::make_unique<Faces>()), opaque_(std::make_unique<Faces>()), albedos_(scene.objects.size()) {
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const bool is_chosen = chosen(object);
    if (!is_chosen && !object.solid) continue;
    Faces& into = is_chosen ? *chosen_ : *opaque_;
    into.attach(object);
    into.objects.push_back(i);
    albedos_[i] = std::make_unique<FilteredTexture>(*albedo(object));
  }
  chosen_->commit();
  opaque_->commit();
}

SceneSurfaces::~SceneSurfaces() = default;

std::optional<SurfaceHit> SceneSurfaces::nearest(const Faces& faces, glm::dvec3 from, glm::dvec3 direction) const {
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
  return SurfaceHit{index,
                    size_t(ray.hit.primID),
                    double(ray.ray.tfar),
                    from + direction * double(ray.ray.tfar),
                    glm::normalize(normals * mixed([](const Vertex& v) { return glm::dvec3(v.normal); })),
                    mixed([](const Vertex& v) { return glm::dvec2(v.uv); })};
}

std::optional<SurfaceHit> SceneSurfaces::chosen(glm::dvec3 from, glm::dvec3 direction) const {
  const auto hit = nearest(*chosen_, from, direction);
  if (!hit) return std::nullopt;
  const auto before = nearest(*opaque_, from, direction);
  return before && before->distance_m < hit->distance_m ? std::nullopt : hit;
}

std::optional<SurfaceHit> SceneSurfaces::opaque(glm::dvec3 from, glm::dvec3 direction) const {
  return nearest(*opaque_, from, direction);
}

glm::dvec3 SceneSurfaces::diffuse(glm::dvec3 position, glm::dvec3 normal) const {
  glm::dvec3 sum(scene_.ambient);
  for (const Light& light : scene_.lights) {
    const bool point = light.kind == Light::Kind::point;
    const glm::dvec3 towards = point ? glm::dvec3(light.position) - position : -glm::dvec3(light.direction);
    const double squared = glm::dot(towards, towards), cosine = glm::dot(normal, towards) / std::sqrt(squared);
    sum += glm::dvec3(light.radiance) * (std::max(cosine, 0.0) / (point ? squared : 1));
  }
  return sum;
}

glm::dvec3 SceneSurfaces::light(const std::optional<SurfaceHit>& hit) const {
  if (!hit) return glm::dvec3(scene_.background);
  return glm::dvec3(albedos_[hit->object]->base(hit->uv)) * diffuse(hit->position, hit->normal);
}

glm::dvec2 SceneSurfaces::uv_beside(const SurfaceHit& hit, glm::dvec3 from, glm::dvec3 direction) const {
  const Object& object = scene_.objects[hit.object];
  const uint32_t* corner = &object.mesh.indices[3 * hit.triangle];
  const auto place = [&](int k) {
    return glm::dvec3(glm::dmat4(object.world_from_object) * glm::dvec4(object.mesh.vertices[corner[k]].position, 1));
  };
  const PlaneHit at = plane_hit(place(0), place(1), place(2), from, direction);
  const auto uv = [&](int k) { return glm::dvec2(object.mesh.vertices[corner[k]].uv); };
  return (1 - at.b - at.c) * uv(0) + at.b * uv(1) + at.c * uv(2);
}

}  // namespace lamina
