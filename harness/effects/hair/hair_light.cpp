// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/hair/hair_light.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina {
namespace {

struct ArrivingLight {
  glm::dvec3 to_light, irradiance;
};

ArrivingLight arriving_at(const Light& light, glm::dvec3 position) {
  if (light.kind == Light::Kind::directional) return {-glm::dvec3(light.direction), glm::dvec3(light.radiance)};
  const glm::dvec3 towards = glm::dvec3(light.position) - position;
  const double squared = glm::dot(towards, towards);
  return {towards / std::sqrt(squared), glm::dvec3(light.radiance) / squared};
}

}  // namespace

std::vector<size_t> influential_lights(const Scene& scene, const Object& object) {
  glm::vec3 low(std::numeric_limits<float>::infinity()), high = -low;
  for (const Vertex& vertex : object.mesh.vertices)
    low = glm::min(low, vertex.position), high = glm::max(high, vertex.position);
  const glm::dvec3 middle(object.world_from_object * glm::vec4((low + high) * 0.5f, 1));
  std::vector<std::pair<double, size_t>> by_luminance;
  for (size_t i = 0; i < scene.lights.size(); ++i) {
    const double luminance = glm::dot(arriving_at(scene.lights[i], middle).irradiance, glm::dvec3(0.2126, 0.7152, 0.0722));
    if (luminance > 0) by_luminance.emplace_back(-luminance, i);
  }
  std::sort(by_luminance.begin(), by_luminance.end());
  std::vector<size_t> chosen;
  for (size_t i = 0; i < std::min<size_t>(2, by_luminance.size()); ++i) chosen.push_back(by_luminance[i].second);
  return chosen;
}

// The exponent by unit h: (1 - (h.n)^2) over (h.n)^2 is tan^2 of the microfacet's angle.
double ward_reflected(glm::dvec3 l, glm::dvec3 v, double along, double across) {
  if (l.z <= 0 || v.z <= 0) return 0;
  const glm::dvec3 h = glm::normalize(l + v);
  const double tan_squared = (h.x * h.x / (along * along) + h.y * h.y / (across * across)) / (h.z * h.z);
  return std::exp(-tan_squared) / (4 * along * across * std::sqrt(l.z * v.z)) * l.z;
}

HairLight::HairLight(const Scene& scene, size_t object)
    : scene_(scene),
      values_(scene.objects[object].effects.at("hair")),
      albedo_(*values_.textures.at("hair_albedo")),
      direction_(*values_.textures.at("hair_direction")),
      influential_(influential_lights(scene, scene.objects[object])) {}

glm::dvec3 HairLight::light(const CardHit& hit, glm::dvec3 to_eye) const {
  const auto number = [&](const char* name) { return values_.numbers.find(name)->second; };
  const glm::dvec3 albedo(albedo_.at(hit.uv, hit.uv_right, hit.uv_down)), normal = glm::normalize(hit.normal);
  const double power = number("gloss"), gloss = number("gloss_strength");
  glm::dvec3 sum = albedo * glm::dvec3(scene_.ambient);
  for (const Light& light : scene_.lights) {
    const ArrivingLight from = arriving_at(light, hit.position);
    const double cosine = std::max(glm::dot(normal, from.to_light), 0.0);
    const double highlight = std::pow(std::max(glm::dot(normal, glm::normalize(from.to_light + to_eye)), 0.0), power);
    sum += from.irradiance * cosine * (albedo + gloss * (power + 2) * highlight);
  }
  const glm::dvec3 tangent = glm::normalize(glm::dvec3(hit.tangent) - normal * glm::dot(normal, glm::dvec3(hit.tangent)));
  const glm::dvec3 bitangent = glm::cross(normal, tangent) * (hit.tangent.w < 0 ? -1.0 : 1.0);
  const glm::dvec4 twice = direction_.at(hit.uv, hit.uv_right, hit.uv_down) * 2.0 - 1.0;
  const double angle = 0.5 * std::atan2(twice.y, twice.x), shift = number("shift");
  const glm::dvec3 strand = tangent * std::cos(angle) + bitangent * std::sin(angle);
  const glm::dvec3 x = glm::normalize(strand + shift * normal), z = glm::normalize(normal - shift * strand),
                   y = glm::cross(z, x);
  const auto turned = [&](glm::dvec3 d) { return glm::dvec3(glm::dot(d, x), glm::dot(d, y), glm::dot(d, z)); };
  const double along = number("roughness_along"), across = number("roughness_across");
  const glm::dvec3 eye = turned(to_eye);
  glm::dvec3 highlight(number("camera_light") * ward_reflected(eye, eye, along, across));
  for (const size_t i : influential_) {
    const ArrivingLight from = arriving_at(scene_.lights[i], hit.position);
    highlight += from.irradiance * ward_reflected(turned(from.to_light), eye, along, across);
  }
  return sum + number("strength") * highlight;
}

}  // namespace lamina
