// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/aperture_lighting/apertures.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace lamina {
namespace {

constexpr glm::vec3 somewhere = {0, 1, 0};  // the direction of a point without a normal

template <class Cap>
std::vector<Aperture> one_a_point(const Visibility& visibility, Cap&& cap) {
  std::vector<Aperture> apertures(visibility.points());
  tbb::parallel_for(size_t{0}, visibility.points(), [&](size_t point) { apertures[point] = cap(point); });
  return apertures;
}

// The cap of the directions whose visibility is `visible`.
Aperture cap_where(const Visibility& visibility, size_t point, bool visible) {
  glm::dvec3 sum(0);
  size_t rays = 0;
  if (visibility.point(point).normal == glm::vec3(0)) return Aperture(somewhere, 0);
  for (size_t ray = 0; ray < visibility.rays(); ++ray) {
    if (visibility.sees(point, ray) != visible) continue;
    sum += glm::dvec3(visibility.directions()[ray]);
    ++rays;
  }
  return aperture_of_rays(visibility, point, rays, sum);
}

// By how much a cap misjudges a point's rays, each by its cosine. `inside`: whether rays in the cap are to be open.
double misjudged(const Visibility& visibility, size_t point, const Aperture& cap, bool inside) {
  const glm::vec3 axis = glm::transpose(visibility.frame(point)) * glm::vec3(cap);
  const float least = std::cos(cap.w);
  double sum = 0;
  for (size_t ray = 0; ray < visibility.rays(); ++ray) {
    const glm::vec3 direction = visibility.directions()[ray];
    const bool in_cap = cap.w > 0 && glm::dot(axis, direction) >= least;
    if ((in_cap == inside) != visibility.sees(point, ray)) sum += double(direction.z);
  }
  return sum;
}

}  // namespace

double cap_radius(double area) { return 2 * std::asin(std::min(1.0, std::sqrt(std::max(area, 0.0) / (4 * std::numbers::pi)))); }

Aperture aperture_of_rays(const Visibility& visibility, size_t point, size_t rays, glm::dvec3 sum) {
  const glm::vec3 normal = visibility.point(point).normal;
  if (rays == 0) return Aperture(normal == glm::vec3(0) ? somewhere : normal, 0);
  const double length = glm::length(sum);
  // Directions all around cancel: then the normal is as good as any.
  const glm::vec3 direction = length > 1e-6 ? glm::normalize(visibility.frame(point) * glm::vec3(sum / length)) : normal;
  const double share = static_cast<double>(rays) / static_cast<double>(visibility.rays());
  return Aperture(direction, static_cast<float>(cap_radius(2 * std::numbers::pi * share)));
}

std::vector<Aperture> single_apertures(const Visibility& visibility) {
  return one_a_point(visibility, [&](size_t point) { return cap_where(visibility, point, true); });
}

std::vector<Aperture> anti_apertures(const Visibility& visibility) {
  return one_a_point(visibility, [&](size_t point) { return cap_where(visibility, point, false); });
}

double edge_angle(const Visibility& visibility, size_t rays, glm::dvec3 sum) {
  const double all = static_cast<double>(visibility.rays()), c = 1 - static_cast<double>(rays) / all,
               width_squared = 3 * (1 - c * c - 2 * glm::length(sum) / all);
  const double sine = std::sqrt(std::max(1 - c * c, 0.0));
  return sine > 1e-6 ? std::min(std::sqrt(std::max(width_squared, 0.0)) / sine, 1.0) : 0;
}

double edge_length(double edge_angle) { return 1 / (1 + edge_angle); }

std::vector<Aperture> soft_apertures(const Visibility& visibility) {
  return one_a_point(visibility, [&](size_t point) {
    Aperture cap = cap_where(visibility, point, true);
    if (cap.w <= 0) return cap;
    glm::dvec3 sum(0);
    size_t rays = 0;
    for (size_t ray = 0; ray < visibility.rays(); ++ray)
      if (visibility.sees(point, ray)) sum += glm::dvec3(visibility.directions()[ray]), ++rays;
    return Aperture(glm::vec3(cap) * static_cast<float>(edge_length(edge_angle(visibility, rays, sum))), cap.w);
  });
}

std::vector<Aperture> chosen_apertures(const Visibility& visibility) {
  std::vector<Aperture> apertures(2 * visibility.points());
  tbb::parallel_for(size_t{0}, visibility.points(), [&](size_t point) {
    const Aperture open = cap_where(visibility, point, true), blocked = cap_where(visibility, point, false);
    const bool has_normal = visibility.point(point).normal != glm::vec3(0);
    const bool is_blocked =
        has_normal && misjudged(visibility, point, blocked, false) < misjudged(visibility, point, open, true);
    apertures[2 * point] = open;
    apertures[2 * point + 1] = Aperture(glm::vec3(blocked) * static_cast<float>(is_blocked ? 1 : min_choice_length), blocked.w);
  });
  return apertures;
}

Harmonics project_visibility(const Visibility& visibility, size_t point) {
  const double y0 = 0.5 * std::sqrt(std::numbers::inv_pi), y1 = std::sqrt(3 * std::numbers::inv_pi / 4);
  Harmonics sum{};
  if (visibility.point(point).normal == glm::vec3(0)) return sum;
  const glm::mat3 world = visibility.frame(point);
  for (size_t ray = 0; ray < visibility.rays(); ++ray) {
    if (!visibility.sees(point, ray)) continue;
    const glm::vec3 d = world * visibility.directions()[ray];
    sum[0] += y0, sum[1] += y1 * d.y, sum[2] += y1 * d.z, sum[3] += y1 * d.x;
  }
  const double solid_angle = 2 * std::numbers::pi / static_cast<double>(visibility.rays());
  for (double& coefficient : sum) coefficient *= solid_angle;
  return sum;
}

Aperture aperture_of(const Harmonics& coefficients, glm::vec3 normal) {
  const glm::dvec3 along(coefficients[3], coefficients[1], coefficients[2]);
  const double length = glm::length(along);
  const glm::vec3 otherwise = normal == glm::vec3(0) ? somewhere : normal;
  const glm::vec3 direction = length > 1e-9 ? glm::vec3(along / length) : otherwise;
  return Aperture(direction, static_cast<float>(cap_radius(2 * std::sqrt(std::numbers::pi) * coefficients[0])));
}

std::vector<Aperture> harmonic_apertures(const Visibility& visibility) {
  return one_a_point(visibility, [&](size_t point) {
    return aperture_of(project_visibility(visibility, point), visibility.point(point).normal);
  });
}

}  // namespace lamina
