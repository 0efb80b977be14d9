// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/translucency/light_path.h"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double min_cosine_inside = 1e-3, max_gathering = 50;
constexpr int max_steps = 12;

double across(glm::dvec3 normal, glm::dvec3 direction) { return std::clamp(std::abs(glm::dot(normal, direction)), 0.0, 1.0); }

// How much longer a path is, and how much more light a surface gets, as if it were flat.
double flat_spread(double cosine, double eta) { return cosine / std::max(cosine_inside(cosine, eta), min_cosine_inside); }

// From a point outside towards the light: what other stretches of medium leave of it. False where something opaque stands
// there.
bool add_outer(const Solids& solids, glm::dvec3 from, const LightHere& here, LightPath& path) {
  constexpr size_t nothing = ~size_t{0};
  double entered = 0;
  size_t inside = nothing;
  for (const SurfaceCrossing& crossing : solids.crossings(from, here.direction, here.distance_m)) {
    const std::optional<Medium>& medium = solids.medium(crossing.object);
    if (!medium) return false;
    const double cosine = across(crossing.normal, here.direction), eta = medium->refraction_index;
    if (crossing.entering) {
      inside = crossing.object;
      entered = crossing.distance;
      path.share *= 1 - fresnel_reflectance(cosine, eta);
    } else if (inside == crossing.object) {
      path.optical_depth += medium->extinction * ((crossing.distance - entered) * flat_spread(cosine, eta));
      path.share *= 1 - fresnel_reflectance(cosine, eta);
      inside = nothing;
    }
  }
  return true;
}

LightPath flat_path(const Solids& solids, glm::dvec3 point, glm::dvec3 normal, size_t object, const LightHere& here) {
  const Medium& medium = *solids.medium(object);
  const double eta = medium.refraction_index;
  LightPath path;
  const std::vector<SurfaceCrossing> all = solids.crossings(point, here.direction, here.distance_m);
  const bool within = !all.empty() && all.front().object == object && !all.front().entering;
  const double length = within ? all.front().distance : 0;
  const double cosine = within ? across(all.front().normal, here.direction) : glm::dot(normal, here.direction);
  if (cosine <= 0) return path;
  const double spread = flat_spread(cosine, eta);
  path.optical_depth = medium.extinction * (length * spread);
  path.share = (1 - fresnel_reflectance(cosine, eta)) * spread;
  const glm::dvec3 outside = point + here.direction * (length + 1e-5 * solids.radius_m());
  return add_outer(solids, outside, here, path) ? path : LightPath{};
}

// A ray of the light's that is to pass the point at an offset, refracted where it goes in.
struct Beam {
  glm::dvec3 entry, normal, towards_light, direction;
  glm::dvec3 beside(glm::dvec3 point) const { return point - entry - direction * glm::dot(point - entry, direction); }
};

std::optional<Beam> beam_past(const Solids& solids, glm::dvec3 target, glm::dvec3 expected, size_t object, const Light& light) {
  const LightHere here = light_here(light, target);
  const double back = here.distance_m < 1e29 ? here.distance_m : 4 * solids.radius_m() + 1e-9;
  const glm::dvec3 origin = target + here.direction * back;
  std::optional<SurfaceCrossing> best;
  double nearest = 1e30;
  for (const SurfaceCrossing& crossing : solids.crossings(origin, -here.direction))
    if (crossing.object == object && crossing.entering) {
      const double off = glm::distance(origin - here.direction * crossing.distance, expected);
      if (off < nearest) nearest = off, best = crossing;
    }
  if (!best || glm::dot(best->normal, here.direction) <= 1e-4) return std::nullopt;
  const double eta = solids.medium(object)->refraction_index;
  return Beam{origin - here.direction * best->distance, best->normal, here.direction,
              refracted_into(-here.direction, best->normal, eta)};
}

LightPath solved_path(const Solids& solids, glm::dvec3 point, size_t object, const Light& light, const LightHere& straight) {
  const Medium& medium = *solids.medium(object);
  const std::optional<SurfaceCrossing> out = solids.way_out(point, straight.direction, object);
  if (!out) return {};
  const glm::dvec3 u =
      glm::normalize(std::abs(straight.direction.x) < 0.9 ? glm::cross(straight.direction, glm::dvec3(1, 0, 0))
                                                          : glm::cross(straight.direction, glm::dvec3(0, 1, 0)));
  const glm::dvec3 v = glm::cross(straight.direction, u);
  glm::dvec3 expected = point + straight.direction * out->distance, target = point;
  const double close = 1e-4 * solids.radius_m(), step = 1e-3 * solids.radius_m();
  for (int i = 0; i < max_steps; ++i) {
    const std::optional<Beam> beam = beam_past(solids, target, expected, object, light);
    if (!beam) return {};
    expected = beam->entry;
    const std::optional<Beam> beam_u = beam_past(solids, target + step * u, expected, object, light);
    const std::optional<Beam> beam_v = beam_past(solids, target + step * v, expected, object, light);
    if (!beam_u || !beam_v) return {};
    const glm::dvec3 miss = beam->beside(point);
    const glm::dvec3 by_u = (beam_u->beside(point) - miss) / step, by_v = (beam_v->beside(point) - miss) / step;
    if (glm::length(miss) < close) {
      const double wider = std::abs(glm::dot(glm::cross(by_u, by_v), beam->direction));
      const double cosine = across(beam->normal, beam->towards_light);
      LightPath path;
      path.optical_depth = medium.extinction * glm::distance(point, beam->entry);
      path.share = (1 - fresnel_reflectance(cosine, medium.refraction_index)) / std::max(wider, 1 / max_gathering);
      const glm::dvec3 outside = beam->entry + beam->towards_light * (1e-5 * solids.radius_m());
      return add_outer(solids, outside, light_here(light, outside), path) ? path : LightPath{};
    }
    // miss + a by_u + b by_v = 0, in the plane across the beam.
    const double uu = glm::dot(by_u, by_u), uv = glm::dot(by_u, by_v), vv = glm::dot(by_v, by_v), area = uu * vv - uv * uv;
    if (area < 1e-12) return {};
    const double mu = glm::dot(miss, by_u), mv = glm::dot(miss, by_v);
    glm::dvec3 move = ((uv * mv - vv * mu) * u + (uv * mu - uu * mv) * v) / area;
    const double most = 0.25 * solids.radius_m(), length = glm::length(move);
    if (length > most) move *= most / length;
    target += move;
  }
  return {};
}

}  // namespace

double cosine_inside(double cosine, double eta) {
  return std::sqrt(std::max(1 - (1 - cosine) * (1 + cosine) / (eta * eta), 0.0));
}

double fresnel_reflectance(double cosine, double eta) {
  const double inside = cosine_inside(cosine, eta);
  const double parallel_sum = eta * cosine + inside, across_sum = cosine + eta * inside;
  if (across_sum <= 0 || parallel_sum <= 0) return eta > 1 ? 1 : 0;
  const double across_part = (cosine - eta * inside) / across_sum, parallel = (eta * cosine - inside) / parallel_sum;
  return (across_part * across_part + parallel * parallel) / 2;
}

glm::dvec3 refracted_into(glm::dvec3 direction, glm::dvec3 normal, double eta) {
  const double cosine = std::max(-glm::dot(direction, normal), 0.0);
  return glm::normalize(direction / eta + normal * (cosine / eta - cosine_inside(cosine, eta)));
}

LightHere light_here(const Light& light, glm::dvec3 position) {
  if (light.kind == Light::Kind::directional)
    return {-glm::normalize(glm::dvec3(light.direction)), 1e30, glm::dvec3(light.radiance)};
  const glm::dvec3 to = glm::dvec3(light.position) - position;
  const double distance = std::max(glm::length(to), 1e-4);
  return {to / distance, distance, glm::dvec3(light.radiance) / (distance * distance)};
}

LightPath light_path(const Solids& solids, glm::dvec3 point, glm::dvec3 normal, size_t object, const Light& light,
                     Refraction refraction) {
  const LightHere here = light_here(light, point);
  if (refraction == Refraction::flat || solids.medium(object)->refraction_index <= 1)
    return flat_path(solids, point, normal, object, here);
  return solved_path(solids, point, object, light, here);
}

}  // namespace lamina
