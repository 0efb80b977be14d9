// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/skin/skin_surface.h"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double start_m = 1e-4;  // rays of shadows start so far from the surface

struct LineHits {
  RTCIntersectContext context;  // first: Embree hands back a pointer to it
  std::vector<std::array<float, 2>>* weights;
  std::vector<uint32_t>* triangles;
};

void keep_hit(const RTCFilterFunctionNArguments* arguments) {
  auto* all = reinterpret_cast<LineHits*>(arguments->context);
  const uint32_t triangle = RTCHitN_primID(arguments->hit, arguments->N, 0);
  const bool known = std::find(all->triangles->begin(), all->triangles->end(), triangle) != all->triangles->end();
  if (!known) {
    all->triangles->push_back(triangle);
    all->weights->push_back({RTCHitN_u(arguments->hit, arguments->N, 0), RTCHitN_v(arguments->hit, arguments->N, 0)});
  }
  arguments->valid[0] = 0;  // and on it goes
}

}  // namespace

SkinLight skin_light(const Light& light, glm::dvec3 position) {
  if (light.kind == Light::Kind::directional) return {-glm::dvec3(light.direction), glm::dvec3(light.radiance)};
  const glm::dvec3 towards = glm::dvec3(light.position) - position;
  const double squared = glm::dot(towards, towards);
  return {towards / std::sqrt(squared), glm::dvec3(light.radiance) / squared};
}

SkinSurface::SkinSurface(const Scene& scene, const Occluders& occluders, size_t object)
    : scene_(scene),
      occluders_(occluders),
      object_(scene.objects[object]),
      values_(object_.effects.at("skin")),
      embree_("truth", RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION),
      profile_(profile_of(values_)),
      reflection_(number("reflectance")),
      albedo_(*values_.textures.at("skin_albedo")),
      normal_(*values_.textures.at("skin_normal")),
      specular_(*values_.textures.at("skin_specular")),
      linear_(object_.world_from_object),
      normal_matrix_(glm::transpose(glm::inverse(linear_))) {
  embree_.attach(object_);
  embree_.commit();
}

SkinHit SkinSurface::hit_of(uint32_t triangle, double u, double v) const {
  const uint32_t* corner = &object_.mesh.indices[size_t{3} * triangle];
  const Vertex *a = &object_.mesh.vertices[corner[0]], *b = &object_.mesh.vertices[corner[1]],
               *c = &object_.mesh.vertices[corner[2]];
  const auto mixed = [&](const auto& of) { return (1 - u - v) * of(*a) + u * of(*b) + v * of(*c); };
  const glm::dvec3 position = mixed([](const Vertex&x) { return glm::dvec3(x.position); }),
                   normal = mixed([](const Vertex&x) { return glm::dvec3(x.normal); }),
                   tangent = mixed([](const Vertex&x) { return glm::dvec3(x.tangent); });
  SkinHit hit{
      glm::dvec3(object_.world_from_object * glm::vec4(glm::vec3(position), 1)),
      glm::normalize(normal_matrix_ * glm::cross(glm::dvec3(b->position - a->position), glm::dvec3(c->position - a->position))),
      glm::normalize(normal_matrix_ * normal), glm::dvec3(0), mixed([](const Vertex& x) { return glm::dvec2(x.uv); })};
  hit.normal = hit.smooth_normal;
  const glm::dvec3 mapped = glm::dvec3(normal_.base(hit.uv)) * 2.0 - 1.0;
  if (std::abs(mapped.x) < 0.6 / 127 && std::abs(mapped.y) < 0.6 / 127) return hit;
  const double handedness = double(a->tangent.w) * (glm::determinant(linear_) < 0 ? -1 : 1);
  glm::dvec3 along = linear_ * tangent;
  along = glm::normalize(along - hit.smooth_normal * glm::dot(hit.smooth_normal, along));
  const glm::dvec3 across = glm::cross(hit.smooth_normal, along) * (handedness < 0 ? -1.0 : 1.0);
  hit.normal = glm::normalize(along * mapped.x + across * mapped.y + hit.smooth_normal * mapped.z);
  return hit;
}

void SkinSurface::hits_along(glm::dvec3 middle, glm::dvec3 direction, double reach_m, std::vector<SkinHit>& hits) const {
  thread_local std::vector<std::array<float, 2>> weights;
  thread_local std::vector<uint32_t> triangles;
  weights.clear(), triangles.clear(), hits.clear();
  LineHits all;
  rtcInitIntersectContext(&all.context);
  all.context.filter = keep_hit;
  all.weights = &weights, all.triangles = &triangles;
  RTCRayHit ray = EmbreeScene::ray_from(middle - direction * reach_m, direction);
  ray.ray.tfar = static_cast<float>(2 * reach_m);
  rtcIntersect1(embree_.scene, &all.context, &ray);
  // A line through an edge meets both triangles there, which are one place.
  const auto same = [&](const SkinHit& one, const SkinHit& other) {
    return glm::dot(one.flat_normal, direction) * glm::dot(other.flat_normal, direction) > 0 &&
           glm::distance(one.position, other.position) < 2e-5;
  };
  for (size_t i = 0; i < triangles.size(); ++i) {
    const SkinHit hit = hit_of(triangles[i], double(weights[i][0]), double(weights[i][1]));
    if (std::none_of(hits.begin(), hits.end(), [&](const SkinHit& known) { return same(known, hit); })) hits.push_back(hit);
  }
}

bool SkinSurface::lit(const Light& light, const SkinLight& arriving, glm::dvec3 position, glm::dvec3 smooth_normal,
                      glm::dvec2 disc) const {
  if (!light.casts) return true;
  const glm::dvec3 l = arriving.to_light;
  const glm::dvec3 right = glm::normalize(glm::cross(l, std::abs(l.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0))),
                   up = glm::cross(right, l);
  const glm::dvec3 across = (right * disc.x + up * disc.y) * (0.0005 * number("penumbra"));
  const double cosine = std::max(glm::dot(smooth_normal, l), 0.15);
  const glm::dvec3 from = position + across - l * (glm::dot(smooth_normal, across) / cosine) + l * (start_m / cosine);
  Occluders::Packet rays;
  for (int i = 0; i < 3; ++i) rays.direction[static_cast<size_t>(i)][0] = static_cast<float>(l[i]);
  rays.distance_m[0] =
      light.kind == Light::Kind::point ? static_cast<float>(glm::distance(glm::dvec3(light.position), from)) : 1e30f;
  return occluders_.free_rays(glm::vec3(from), rays, 1) != 0;
}

glm::dvec3 SkinSurface::entering(const SkinHit& hit, glm::dvec2 disc) const {
  glm::dvec3 sum(scene_.ambient);
  const glm::dvec4 map = specular_.base(hit.uv);
  for (const Light& light : scene_.lights) {
    const SkinLight arriving = skin_light(light, hit.position);
    const double cosine = glm::dot(hit.normal, arriving.to_light);
    if (cosine <= 0 || !lit(light, arriving, hit.position, hit.smooth_normal, disc)) continue;
    const double lost = number("specular") * map.r * reflection_.share(cosine, number("roughness") * map.g);
    sum += arriving.irradiance * (cosine * (1 - lost));
  }
  return sum * glm::sqrt(albedo(glm::dvec3(albedo_.base(hit.uv))));
}

glm::dvec3 SkinSurface::albedo(glm::dvec3 plain) const {
  const double luminance = glm::dot(plain, glm::dvec3(0.30, 0.59, 0.11)), amount = number("melanin");
  return plain * (1 - amount + amount * luminance * plain);
}

}  // namespace lamina
