// SPDX-License-Identifier: Apache-2.0
#include "harness/truth/beckmann_facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lamina {
namespace {

// Times pi and the light's cosine.
double rough_reflection(double slope, glm::dvec3 normal, glm::dvec3 to_light, glm::dvec3 to_eye) {
  const double light_cosine = glm::dot(normal, to_light), eye_cosine = glm::dot(normal, to_eye);
  if (light_cosine <= 0 || eye_cosine <= 0) return 0;
  const glm::dvec3 h = glm::normalize(to_light + to_eye);
  const double nh = glm::dot(normal, h), vh = glm::dot(to_eye, h), squared = slope * slope;
  const double density = std::exp(-(1 - nh * nh) / (nh * nh * squared)) / (squared * std::pow(nh, 4));
  return density / (4 * vh * vh) * light_cosine;
}

}  // namespace

glm::dvec3 beckmann_facet(double slope, glm::dvec3 normal, glm::dvec2 share) {
  const glm::dvec3 x = glm::normalize(glm::cross(normal, std::abs(normal.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
  const double radius = slope * std::sqrt(-std::log(1 - share.x)), turn = 2 * std::numbers::pi * share.y;
  return glm::normalize(normal - radius * (std::cos(turn) * x + std::sin(turn) * glm::cross(normal, x)));
}

glm::dvec2 facet_share(size_t ray, size_t rays, size_t pixel) {
  const double n = static_cast<double>(ray) + 0.618 * static_cast<double>(pixel % 4096);
  return glm::fract(glm::dvec2((static_cast<double>(ray) + 0.5) / static_cast<double>(rays), 0.5698402909980532 * n));
}

glm::dvec3 facet_highlights(const Scene& scene, double slope, glm::dvec3 position, glm::dvec3 normal, glm::dvec3 to_eye,
                            const std::function<double(double)>& fresnel) {
  glm::dvec3 sum(0);
  for (const Light& light : scene.lights) {
    const bool point = light.kind == Light::Kind::point;
    const glm::dvec3 towards = point ? glm::dvec3(light.position) - position : -glm::dvec3(light.direction);
    const double distance = glm::length(towards);
    const glm::dvec3 to_light = towards / distance;
    const double facet_cosine = std::sqrt(std::max(0.5 + 0.5 * glm::dot(to_light, to_eye), 0.0));
    sum += glm::dvec3(light.radiance) *
           (fresnel(facet_cosine) / (point ? distance * distance : 1) * rough_reflection(slope, normal, to_light, to_eye));
  }
  return sum;
}

}  // namespace lamina
