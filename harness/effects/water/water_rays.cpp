// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/water/water_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "harness/effects/water/water_light.h"
#include "harness/effects/water/waves.h"
#include "harness/truth/for_each_on_all_cores.h"
#include "harness/truth/pixel_of.h"
#include "harness/truth/scene_surfaces.h"
#include "harness/truth/view_rays.h"

namespace lamina {
namespace {

constexpr double endless_m = 1e4;  // of a way in the water that meets nothing
constexpr double off_surface_m = 1e-5;
constexpr double min_cosine = 0.01;  // of the surface to the eye: backs of waves are bent towards it

bool is_water(const Object& object) { return object.effects.contains("water"); }

class WaterRays : public Truth {
 public:
  explicit WaterRays(const TruthSetting& setting)
      : scene_(setting.scene),
        side_(std::clamp(static_cast<int>(std::sqrt(static_cast<double>(setting.rays))), 1, 16)),
        light_(scene_),
        waves_(scene_.effects.at("water")),
        surfaces_(scene_, is_water,
                  [](const Object& object) -> const Texture& { return object.effects.at("surface").textures.at("albedo"); }) {}

  TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) override {
    const Image& seen = told.target("seen_ground", "water_rays");
    TruthAnswer answer;
    for (size_t pixel = 0; pixel < seen.rgba.size() / 4; ++pixel)
      if (seen.rgba[4 * pixel + 3] > 0) answer.pixels.push_back(pixel);
    // From under the water there is no truth.
    if (answer.pixels.empty() || double(told.view.eye.y) < light_.number("height")) return {};
    const ViewRays rays(told.view, seen.width, seen.height);
    const glm::dvec3 eye(told.view.eye);
    const auto told_by = [&](const char* name) -> const Image& { return told.target(name, "water_rays"); };
    const Image &mirrored = told_by("seen_mirrored"), &bottom = told_by("seen_bottom"), &kept = told_by("seen_kept"),
                &scattered = told_by("seen_scattered");
    std::array<std::vector<glm::vec3>, step_count> lights;
    for (auto& light : lights) light.resize(answer.pixels.size());
    for_each_on_all_cores(answer.pixels.size(), progress, [&](size_t i) {
      const size_t pixel = answer.pixels[i];
      const glm::dvec4 ground = pixel_of(seen, pixel);
      const auto width = static_cast<size_t>(seen.width);
      const double column = static_cast<double>(pixel % width), row = static_cast<double>(pixel / width);
      const Drawn drawn{{ground.x, ground.y},
                        glm::dvec3(pixel_of(mirrored, pixel)),
                        glm::dvec3(pixel_of(bottom, pixel)),
                        glm::dvec3(pixel_of(kept, pixel)),
                        glm::dvec3(pixel_of(scattered, pixel))};
      Steps sum{};
      int count = 0;
      const auto add = [&](const Steps& light) {
        ++count;
        for (size_t step = 0; step < step_count; ++step) sum[step] += light[step];
      };
      // No two rays in a row or column: edges along the picture are met by one more ray at a time.
      for (int y = 0; y < side_; ++y)
        for (int x = 0; x < side_; ++x) {
          const glm::dvec2 in_pixel = (glm::dvec2(x, y) + (glm::dvec2(y, x) + 0.5) / double(side_)) / double(side_);
          const glm::dvec3 direction = rays.through(column + in_pixel.x, row + in_pixel.y);
          const WavePoint point = met(eye, direction, drawn.ground);
          if (is_hidden(eye, direction, point)) continue;
          add(light_of(eye, point, drawn, rays.ahead()));
        }
      // A ray that was drawn slips by where all of these are hidden.
      if (count == 0) add(light_of(eye, point_at(drawn.ground), drawn, rays.ahead()));
      for (size_t step = 0; step < step_count; ++step) lights[step][i] = sum[step] / double(count);
    });
    constexpr std::pair<const char*, const char*> named[step_count] = {
        {"normal",
         "this variant's picture against Fresnel, highlight and foam of the exact waves, of what full finds above and below"},
        {"reflection", "what full finds in the mirror's picture against what rays meet above"},
        {"refraction", "what full finds below against what rays meet below, as each is lit"},
        {"extinction", "what full's ways in the water take of that against what the rays' ways take"},
        {"scattering", "what full's ways in the water add against what the rays' ways add"}};
    for (size_t step = 0; step < step_count; ++step)
      answer.steps.push_back({named[step].first, named[step].second, std::move(lights[step])});
    return answer;
  }

 private:
  // What the device drew in a pixel: its point, what the baseline found above, the light of what it found below, the share of
  // that which comes up, and what the way in the water adds.
  struct Drawn {
    glm::dvec2 ground;
    glm::dvec3 mirrored, bottom, kept, scattered;
  };
  // Light with one assumption less at a time.
  static constexpr size_t step_count = 5;
  using Steps = std::array<glm::dvec3, step_count>;

  WavePoint point_at(glm::dvec2 ground) const {
    WavePoint point = waves_.at(ground, double(scene_.time_s));
    point.position.y += light_.number("height");
    return point;
  }

  // Where a ray meets the waves, near a point that the device drew: the ground whose point lies on the ray, by Newton's method.
  // The point itself where none is found near it.
  WavePoint met(glm::dvec3 eye, glm::dvec3 direction, glm::dvec2 drawn) const {
    const WavePoint first = point_at(drawn);
    const glm::dvec3 u = glm::normalize(
                         glm::cross(direction, std::abs(direction.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0))),
                     v = glm::cross(u, direction);
    const double far = glm::distance(first.position, eye);
    glm::dvec2 ground = drawn;
    for (int step = 0; step < 12; ++step) {
      const WavePoint point = point_at(ground);
      const glm::dvec3 from_eye = point.position - eye;
      const glm::dvec2 off(glm::dot(u, from_eye), glm::dot(v, from_eye));
      if (glm::length(off) < 1e-9 * far)
        return glm::dot(from_eye, direction) > 0 && glm::dot(point.normal(), direction) < 0 ? point : first;
      const double a = glm::dot(u, point.along_x), b = glm::dot(u, point.along_z), c = glm::dot(v, point.along_x),
                   d = glm::dot(v, point.along_z), determinant = a * d - b * c;
      if (std::abs(determinant) < 1e-9) return first;
      const glm::dvec2 change(-(d * off.x - b * off.y) / determinant, -(a * off.y - c * off.x) / determinant);
      ground += change * std::min(1.0, 0.2 * far / std::max(glm::length(change), 1e-12));
      if (glm::distance(ground, drawn) > 0.5 * far) return first;
    }
    return first;
  }

  // Whether something stands before the water there: a pixel is answered for by what it shows of the water alone.
  bool is_hidden(glm::dvec3 eye, glm::dvec3 direction, const WavePoint& point) const {
    const auto before = surfaces_.opaque(eye, direction);
    return before && before->distance_m < glm::distance(point.position, eye) - off_surface_m;
  }

  Steps light_of(glm::dvec3 eye, const WavePoint& point, const Drawn& drawn, glm::dvec3 ahead) const {
    const glm::dvec3 to_eye = glm::normalize(eye - point.position);
    glm::dvec3 normal = light_.with_ripples(point.normal(), point.ground);
    normal = glm::normalize(normal + std::max(min_cosine - glm::dot(normal, to_eye), 0.0) * to_eye);
    const double cosine = std::clamp(glm::dot(normal, to_eye), min_cosine, 1.0), index = light_.number("refraction_index");
    double share = reflected_by_water(cosine, index);

    // Down to the bottom: Snell's law.
    const glm::dvec3 across = (cosine * normal - to_eye) / index,
                     into = glm::normalize(across - normal * std::sqrt(1 - glm::dot(across, across)));
    const auto bottom = surfaces_.opaque(point.position - off_surface_m * normal, into);
    const double way_m = bottom ? bottom->distance_m : endless_m;
    const glm::dvec3 scattered = light_.in_scatter(into, way_m);
    glm::dvec3 found(0), kept(0);
    if (bottom) {
      const glm::dvec3 all = surfaces_.diffuse(bottom->position, bottom->normal);
      const glm::dvec3 by_sun =
          light_.sunlit() ? glm::dvec3(scene_.lights[0].radiance) * std::max(glm::dot(bottom->normal, light_.to_sun()), 0.0)
                          : glm::dvec3(0);
      const BottomLight light =
          light_.bottom(glm::dvec3(surfaces_.albedo(bottom->object).base(bottom->uv)), by_sun, all - by_sun, bottom->position);
      found = light.all(), kept = light_.kept(light, bottom->position, way_m);
    }

    // Up: what would meet the water again goes along its level.
    glm::dvec3 along = 2 * glm::dot(normal, to_eye) * normal - to_eye;
    const glm::dvec3 up = glm::normalize(glm::dvec3(along.x, std::max(along.y, 1e-3), along.z));
    const auto above = surfaces_.opaque(point.position + off_surface_m * normal, up);
    const glm::dvec3 mirrored = above ? surfaces_.light(above) : light_.sky(up);

    // Straight on: what fades the water's edge, and foams.
    const auto straight = surfaces_.opaque(point.position - off_surface_m * to_eye, -to_eye);
    const glm::dvec3 behind = straight ? straight->position : point.position - endless_m * to_eye;
    const double soft_m = light_.number("soft_edge");
    const double edge = soft_m > 0 ? std::clamp(glm::dot(behind - point.position, ahead) / soft_m, 0.0, 1.0) : 1;
    const glm::dvec3 highlight = edge * share * light_.glitter(along), foam = 0.85 * surfaces_.diffuse(point.position, normal);
    const double cover = edge * light_.foam(point.position, behind, way_m);
    const auto composed = [&](glm::dvec3 below, glm::dvec3 reflected) {
      return glm::mix(glm::mix(below, reflected, share * edge) + highlight, foam, cover);
    };
    const glm::dvec3 drawn_below = drawn.bottom * drawn.kept + drawn.scattered;
    return {composed(drawn_below, drawn.mirrored), composed(drawn_below, mirrored),
            composed(found * drawn.kept + drawn.scattered, mirrored), composed(found * kept + drawn.scattered, mirrored),
            composed(found * kept + scattered, mirrored)};
  }

  const Scene& scene_;
  int side_;  // rays along a pixel's side
  WaterLight light_;
  GerstnerWaves waves_;
  SceneSurfaces surfaces_;
};

}  // namespace

std::unique_ptr<Truth> water_rays(const TruthSetting& setting) { return std::make_unique<WaterRays>(setting); }

}  // namespace lamina
