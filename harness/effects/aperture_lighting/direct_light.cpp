// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/aperture_lighting/direct_light.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harness/effects/cap_intersection/cap_area.h"

namespace lamina {
namespace {

constexpr double min_radius = 1e-4;  // a point light, as in shaders/aperture_lighting/light.frag
constexpr size_t points_between_progress = 4096;

double angle_between(glm::dvec3 a, glm::dvec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

// Lambert's cosine at the middle of two unit directions.
double middle_cosine(glm::dvec3 normal, glm::dvec3 a, glm::dvec3 b) {
  const double length = glm::length(a + b);
  return length > 1e-6 ? std::max(glm::dot(normal, (a + b) / length), 0.0) : 0.0;
}

// How far a ray in this direction goes before it is in the light.
float distance_to(const LightCap& cap, glm::vec3 direction) {
  if (std::isinf(cap.distance_m)) return cap.distance_m;
  const float along = cap.distance_m * glm::dot(cap.direction, direction);
  const float aside2 = std::max(cap.distance_m * cap.distance_m - along * along, 0.0f);
  return std::max(along - std::sqrt(std::max(cap.sphere_radius_m * cap.sphere_radius_m - aside2, 0.0f)), 0.0f);
}

// A light's directions around +z. A point light's radius differs from point to point, so its set is made for each.
DirectionSet light_set(const LightCap& cap, size_t rays) { return uniform_cap(rays, std::cos(cap.radius)); }

// One point under one model.
class PointLight {
 public:
  PointLight(const ShadingPoints& points, size_t index, const Scene& scene, const Occluders& occluders, LightModel model,
             const DirectLightOptions& options)
      : point_(points.points[index]),
        apertures_(std::span(points.apertures).subspan(index * points.kind.count, points.kind.count)),
        anti_(points.kind.anti),
        choice_(points.kind.choice),
        occluders_(occluders),
        model_(model),
        options_(options),
        origin_(point_.position + point_.normal * options.bias_m) {
    for (const Light& light : scene.lights) lights_.push_back(light_cap(light, point_.position));
  }

  glm::dvec3 light(const glm::vec3& ambient, const std::vector<DirectionSet>& from_afar, const DirectionSet& sky) const {
    glm::dvec3 sum(0);
    for (size_t i = 0; i < lights_.size(); ++i)
      sum += glm::dvec3(lights_[i].irradiance) * (model_ == LightModel::exact_intersection ? shared_by_area(lights_[i])
                                                  : from_afar[i].size() > 0
                                                      ? sampled(lights_[i], from_afar[i], i)
                                                      : sampled(lights_[i], light_set(lights_[i], options_.light_rays), i));
    return sum + glm::dvec3(ambient) * (model_ == LightModel::exact_intersection ? unfilled_by_area() : sampled_sky(sky));
  }

 private:
  // Of a light's irradiance, the part that apertures let in, by exact areas and the cosine at the middle.
  double shared_by_area(const LightCap& cap) const {
    const double whole = smaller_cap_area(cap.radius, cap.radius);
    double sum = 0;
    for (const auto& [area, cosine] : shared_areas(cap)) sum += area / whole * cosine;
    return sum;
  }
  struct Shared {
    double area, cosine;
  };
  std::vector<Shared> shared_areas(const LightCap& cap) const {
    std::vector<Shared> shared;
    const glm::dvec3 normal = point_.normal, along = cap.direction;
    const auto of = [&](glm::dvec3 axis, double radius) {
      return radius > 0 ? cap_intersection_area(radius, cap.radius, angle_between(axis, along)) : 0.0;
    };
    if (anti_) {
      const double open = of(normal, std::numbers::pi / 2), blocked = of(glm::vec3(apertures_[0]), apertures_[0].w);
      return {{std::max(open - blocked, 0.0), middle_cosine(normal, normal, along)}};
    }
    if (choice_) {
      const double open = of(normal, std::numbers::pi / 2), blocked = of(glm::vec3(apertures_[1]), apertures_[1].w);
      return {{(1 - blocked_weight()) * of(glm::vec3(apertures_[0]), apertures_[0].w),
               middle_cosine(normal, glm::vec3(apertures_[0]), along)},
              {blocked_weight() * std::max(open - blocked, 0.0), middle_cosine(normal, normal, along)}};
    }
    for (const Aperture& a : apertures_) shared.push_back({of(glm::vec3(a), a.w), middle_cosine(normal, glm::vec3(a), along)});
    return shared;
  }
  // The share of the hemisphere that lights leave to the sky.
  double unfilled_by_area() const {
    const double hemisphere = 2 * std::numbers::pi;
    const auto of = [](const Aperture& a) { return a.w > 0 ? smaller_cap_area(a.w, a.w) : 0.0; };
    double area = anti_ ? hemisphere : 0;
    if (choice_)
      area = (1 - blocked_weight()) * of(apertures_[0]) + blocked_weight() * (hemisphere - of(apertures_[1]));
    else
      for (const Aperture& a : apertures_) area += (anti_ ? -1 : 1) * of(a);
    for (const LightCap& cap : lights_)
      for (const Shared& shared : shared_areas(cap)) area -= shared.area;
    return std::clamp(area / hemisphere, 0.0, 1.0);
  }

  // How much the cap of what is blocked counts, by its direction's length.
  double blocked_weight() const {
    const double length = double(glm::length(glm::vec3(apertures_[1])));
    return std::clamp((length - min_choice_length) / (1 - min_choice_length), 0.0, 1.0);
  }
  bool in_apertures(glm::vec3 direction) const {
    const auto in = [&](const Aperture& a) { return angle_between(glm::vec3(a), direction) <= a.w; };
    if (choice_) return blocked_weight() < 0.5 ? in(apertures_[0]) : !in(apertures_[1]);
    return anti_ ? !in(apertures_[0]) : std::any_of(apertures_.begin(), apertures_.end(), in);
  }

  // Sum over the open ones of `count` directions of their weights; those of weight 0 are not looked at. `ray(i)` gives
  // direction, distance in metres and weight.
  template <class Ray>
  double sum_open(size_t count, Ray&& ray) const {
    double sum = 0;
    Occluders::Packet packet;
    std::array<double, Occluders::packet> weights{};
    size_t waiting = 0;
    const auto cast = [&] {
      const uint32_t open = occluders_.free_rays(origin_, packet, waiting);
      for (size_t k = 0; k < waiting; ++k) sum += (open >> k) & 1 ? weights[k] : 0;
      waiting = 0;
    };
    for (size_t i = 0; i < count; ++i) {
      const auto [direction, distance_m, weight] = ray(i);
      if (weight == 0) continue;
      if (model_ == LightModel::integrated_cosine) {
        sum += in_apertures(direction) ? weight : 0;
        continue;
      }
      for (int axis = 0; axis < 3; ++axis) packet.direction[axis][waiting] = direction[axis];
      packet.distance_m[waiting] = distance_m;
      weights[waiting] = weight;
      if (++waiting == Occluders::packet) cast();
    }
    if (waiting > 0) cast();
    return sum;
  }
  struct Ray {
    glm::vec3 direction;
    float distance_m;
    double weight;
  };

  double sampled(const LightCap& cap, const DirectionSet& set, size_t which) const {
    const glm::mat3 frame = turned_frame(cap.direction, options_.seed + 1 + which, point_.pixel);
    const bool whole_cosine = model_ != LightModel::traced_share;
    const double sum = sum_open(set.size(), [&](size_t i) {
      const glm::vec3 direction = frame * set[i];
      const double cosine = std::max(glm::dot(point_.normal, direction), 0.0f);
      return Ray{direction, distance_to(cap, direction), whole_cosine || cosine == 0 ? cosine : 1};
    });
    const double mean = sum / static_cast<double>(set.size());
    if (!whole_cosine) return mean * middle_cosine(point_.normal, glm::vec3(apertures_[0]), cap.direction);
    return mean * 2 / (1 + std::cos(cap.radius));  // the solid angle over pi sin^2 r
  }

  double sampled_sky(const DirectionSet& set) const {
    const glm::mat3 frame = turned_frame(point_.normal, options_.seed, point_.pixel);
    const double open = sum_open(set.size(), [&](size_t i) {
      const glm::vec3 direction = frame * set[i];
      const bool in_light = std::any_of(lights_.begin(), lights_.end(), [&](const LightCap& cap) {
        return glm::dot(cap.direction, direction) >= std::cos(cap.radius);
      });
      return Ray{direction, std::numeric_limits<float>::infinity(), in_light ? 0.0 : 1.0};
    });
    return open / static_cast<double>(set.size());
  }

  const ShadingPoint& point_;
  std::span<const Aperture> apertures_;
  bool anti_, choice_;
  const Occluders& occluders_;
  LightModel model_;
  const DirectLightOptions& options_;
  glm::vec3 origin_;
  std::vector<LightCap> lights_;
};

}  // namespace

LightCap light_cap(const Light& light, glm::vec3 position) {
  if (light.kind == Light::Kind::directional)
    return {-light.direction, std::clamp<double>(light.angular_radius, min_radius, std::numbers::pi / 2),
            std::numeric_limits<float>::infinity(), 0, light.radiance};
  const glm::vec3 to_light = light.position - position;
  const float distance = std::max(glm::length(to_light), 1e-4f);
  const double radius = std::asin(std::min(1.0, double(light.radius_m) / distance));
  return {to_light / distance, std::clamp(radius, min_radius, std::numbers::pi / 2), distance, light.radius_m,
          light.radiance / (distance * distance)};
}

std::vector<glm::vec3> direct_light(const ShadingPoints& points, const Scene& scene, const Occluders& occluders,
                                    LightModel model, const DirectLightOptions& options, const ProgressFunction& progress) {
  // Uniform where the share of the hemisphere is asked for, as the apertures' areas take it.
  const DirectionSet sky =
      model == LightModel::traced_share ? uniform_cap(options.sky_rays, 0) : cosine_hemisphere(options.sky_rays);
  std::vector<DirectionSet> from_afar(scene.lights.size());
  for (size_t i = 0; i < scene.lights.size(); ++i)
    if (scene.lights[i].kind == Light::Kind::directional)
      from_afar[i] = light_set(light_cap(scene.lights[i], glm::vec3(0)), options.light_rays);
  std::vector<glm::vec3> lit(points.points.size());
  const auto shade = [&](size_t i) {
    const PointLight point(points, i, scene, occluders, model, options);
    lit[i] = glm::vec3(point.light(scene.ambient, from_afar, sky)) * points.points[i].albedo;
  };
  for (size_t done = 0; done < lit.size(); done += points_between_progress) {
    progress(static_cast<double>(done) / static_cast<double>(lit.size()));
    tbb::parallel_for(done, std::min(lit.size(), done + points_between_progress), shade);
  }
  return lit;
}

}  // namespace lamina
