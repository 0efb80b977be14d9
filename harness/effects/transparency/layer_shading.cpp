// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/transparency/layer_shading.h"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double greatest_way = 20;  // of a sheet's thickness, where it is seen along its surface

const char* const own_effect = "transparency";
const char* const plain_effect = "surface";

}  // namespace

LayerShading::LayerShading(const Scene& scene) : scene_(scene) {
  for (size_t i = 0; i < scene.objects.size(); ++i)
    for (const auto& [effect, texture] : {std::pair(own_effect, "transparent_color"), std::pair(plain_effect, "albedo")}) {
      const auto values = scene.objects[i].effects.find(effect);
      if (values == scene.objects[i].effects.end()) continue;
      if (const auto found = values->second.textures.find(texture); found != values->second.textures.end())
        textures_.emplace(std::pair(i, effect), *found->second);
    }
}

LayerShading::Layer LayerShading::layer(const LayerHit& hit, glm::dvec3 eye) const {
  const auto& numbers = scene_.objects[hit.object].effects.at(own_effect).numbers;
  const glm::dvec4 texel = textures_.at({hit.object, own_effect}).base(hit.uv);
  const double straight = std::clamp(numbers.at("opacity") * texel.a, 0.0, 1.0), slant = numbers.at("slant");
  const double longer = 1 + slant * (std::min(1 / hit.cosine, greatest_way) - 1);
  const MetLight met = met_light(hit.position, hit.normal, eye, numbers.at("gloss"));
  return {glm::dvec3(texel) * met.diffuse + numbers.at("specular") * met.specular, 1 - std::pow(1 - straight, longer)};
}

std::optional<glm::dvec3> LayerShading::opaque(const LayerHit& hit, glm::dvec3 eye) const {
  const auto& effects = scene_.objects[hit.object].effects;
  if (effects.contains(own_effect)) return layer(hit, eye).color;
  if (effects.size() != 1 || !effects.contains(plain_effect)) return std::nullopt;
  return glm::dvec3(textures_.at({hit.object, plain_effect}).base(hit.uv)) *
         met_light(hit.position, hit.normal, eye, 1).diffuse;
}

std::optional<glm::dvec3> LayerShading::background() const {
  const bool alone = std::ranges::all_of(scene_.effects, [](const auto& entry) { return entry.first == own_effect; });
  return alone ? std::optional(glm::dvec3(scene_.background)) : std::nullopt;
}

LayerShading::MetLight LayerShading::met_light(glm::dvec3 position, glm::dvec3 normal, glm::dvec3 eye, double gloss) const {
  MetLight sum{glm::dvec3(scene_.ambient), glm::dvec3(0)};
  const glm::dvec3 to_eye = glm::normalize(eye - position);
  for (const Light& lamp : scene_.lights) {
    const bool point = lamp.kind == Light::Kind::point;
    const glm::dvec3 way = point ? glm::dvec3(lamp.position) - position : -glm::dvec3(lamp.direction);
    const double squared = std::max(glm::dot(way, way), 1e-8);
    const glm::dvec3 to_light = way / std::sqrt(squared);
    const double cosine = std::max(glm::dot(normal, to_light), 0.0);
    const glm::dvec3 irradiance = glm::dvec3(lamp.radiance) * (point ? cosine / squared : cosine);
    const glm::dvec3 halfway = to_light + to_eye;
    const double across = std::max(glm::dot(normal, halfway) / std::max(glm::length(halfway), 1e-4), 0.0);
    sum.diffuse += irradiance;
    sum.specular += irradiance * ((gloss + 8) / 8 * std::pow(across, gloss));
  }
  return sum;
}

}  // namespace lamina
