// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/translucency/scattered_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/effects/translucency/random_walk.h"

namespace lamina {
namespace {

constexpr int steps = 32;               // along the eye's ray, in equal shares of what it sees
constexpr double connect_share = 0.25;  // of the events of a walk, from the second on, that are joined to the lights

struct EyeRay {
  glm::dvec3 start, along;
  double seen;  // of the radiance inside: what the boundary lets through, spread over a wider angle outside
};

EyeRay eye_ray(const Solids& solids, const LitPoint& point) {
  const double eta = solids.medium(point.object)->refraction_index;
  const double cosine = std::max(glm::dot(point.normal, point.to_eye), 1e-3);
  return {point.position - point.normal * (1e-5 * solids.radius_m()), refracted_into(-point.to_eye, point.normal, eta),
          (1 - fresnel_reflectance(cosine, eta)) / (eta * eta)};
}

glm::dvec3 reflectances(const LitPoint& point, double eta) {
  return {diffuse_reflectance(point.albedo.r, eta), diffuse_reflectance(point.albedo.g, eta),
          diffuse_reflectance(point.albedo.b, eta)};
}

}  // namespace

double diffuse_reflectance(double albedo, double eta) {
  const double inner = -1.440 / (eta * eta) + 0.710 / eta + 0.668 + 0.0636 * eta, a = (1 + inner) / (1 - inner);
  const double root = std::sqrt(3 * (1 - albedo));
  return albedo / 2 * (1 + std::exp(-4.0 / 3.0 * a * root)) * std::exp(-root);
}

glm::dvec3 single_scattering(const Solids& solids, const Scene& scene, const LitPoint& point, Refraction refraction) {
  const EyeRay ray = eye_ray(solids, point);
  const std::optional<SurfaceCrossing> out = solids.way_out(ray.start, ray.along, point.object);
  if (!out) return glm::dvec3(0);
  const glm::dvec3 sigma = solids.medium(point.object)->extinction;
  glm::dvec3 sum(0);
  for (int channel = 0; channel < 3; ++channel) {
    if (sigma[channel] <= 0) continue;
    const double covered = -std::expm1(-sigma[channel] * out->distance);
    double light_sum = 0;
    for (int step = 0; step < steps; ++step) {
      const double t = -std::log1p(-(step + 0.5) / steps * covered) / sigma[channel];
      const glm::dvec3 place = ray.start + ray.along * t;
      for (const Light& light : scene.lights)
        if (light.casts)
          light_sum += light_here(light, place).irradiance[channel] *
                       light_path(solids, place, point.normal, point.object, light, refraction).transmitted()[channel];
    }
    sum[channel] = point.albedo[channel] * covered * light_sum / steps;
  }
  return sum * (ray.seen / 4);
}

glm::dvec3 slab_scattering(const Solids& solids, const Scene& scene, const LitPoint& point, Refraction refraction) {
  const Medium& medium = *solids.medium(point.object);
  const double eta = medium.refraction_index, wrap = medium.wrap;
  const glm::dvec3 all = reflectances(point, eta), beyond = all - 0.8;
  const double through = (1 - fresnel_reflectance(1, eta)) / eta;
  const glm::dvec3 shape = 1.9 - all + 3.5 * beyond * beyond;
  glm::dvec3 sum(0);
  const glm::dvec3 inner = point.position - point.normal * (1e-5 * solids.radius_m());
  for (const Light& light : scene.lights) {
    if (!light.casts) continue;
    const LightHere here = light_here(light, point.position);
    // Where no refracted light arrives, none that is scattered on its straight way does, as far as this model goes.
    LightPath path = light_path(solids, inner, point.normal, point.object, light, refraction);
    if (path.share <= 0) path = light_path(solids, inner, point.normal, point.object, light, Refraction::flat);
    if (path.share <= 0 && glm::dot(point.normal, here.direction) > 0) continue;  // in something opaque's shadow
    const glm::dvec3 x = path.optical_depth * shape, slab = 0.25 * glm::exp(-x) + 0.75 * glm::exp(-x / 3.0);
    const double cosine = glm::dot(point.normal, here.direction);
    const double both = std::max(cosine, 0.0) + std::max(wrap - cosine, 0.0) / ((1 + wrap) * (1 + wrap));
    sum += here.irradiance * slab * both;
  }
  const glm::dvec3 more = glm::max(all - point.albedo * (through * through / 8), glm::dvec3(0));
  return sum * more * medium.multiple_scattering;
}

glm::dvec3 multiple_scattering(const Solids& solids, const Scene& scene, const LitPoint& point, size_t walks, uint64_t seed) {
  const EyeRay ray = eye_ray(solids, point);
  WalkRandom random(seed);
  glm::dvec3 sum(0);
  const auto join = [&](glm::dvec3 position, glm::dvec3 weight, int order) {
    if (order < 2 || random.uniform() >= connect_share) return;
    for (const Light& light : scene.lights)
      if (light.casts)
        sum += weight * light_here(light, position).irradiance *
               light_path(solids, position, point.normal, point.object, light, Refraction::solved).transmitted();
  };
  for (size_t i = 0; i < walks; ++i) random_walk(solids, point.object, point.albedo, ray.start, ray.along, random, join);
  const double share = solids.medium(point.object)->multiple_scattering;
  return sum * (share * ray.seen / (4 * connect_share * static_cast<double>(walks)));
}

glm::dvec3 unshadowed_light(const Medium& medium, const Scene& scene, const LitPoint& point) {
  glm::dvec3 light(scene.ambient);
  for (const Light& lamp : scene.lights) {
    const LightHere here = light_here(lamp, point.position);
    if (!lamp.casts) light += here.irradiance * std::max(glm::dot(point.normal, here.direction), 0.0);
  }
  return light * reflectances(point, medium.refraction_index);
}

}  // namespace lamina
