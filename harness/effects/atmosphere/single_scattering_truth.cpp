// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/atmosphere/single_scattering_truth.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "harness/core/bytes.h"
#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/truth/pixel_of.h"
#include "harness/truth/view_rays.h"

namespace lamina {
namespace {

class SingleScatteringTruth : public Truth {
 public:
  explicit SingleScatteringTruth(const TruthSetting& setting) : setting_(setting) {}

  TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) override {
    const Image &point = told.target("seen_point", "single_scattering"),
                &light = told.target("seen_light", "single_scattering");
    TruthAnswer answer;
    for (size_t i = 0; i < point.rgba.size() / 4; ++i) answer.pixels.push_back(i);
    answer.steps = {
        {"integration", "this variant's air against single scattering integrated", seen(told.view, point, light, progress)}};
    return answer;
  }

 private:
  std::vector<glm::vec3> seen(const View& view, const Image& point, const Image& light,
                              const std::function<void(double)>& progress) const {
    const EffectValues& values = setting_.scene.effects.at("atmosphere");
    const Air air = air_of(values);
    const auto sun = [&](const char* channel) { return values.numbers.find(channel)->second; };
    const glm::dvec3 above_air(sun("sun_red"), sun("sun_green"), sun("sun_blue"));
    const std::optional<glm::dvec3> to_sun = direction_to_sun(setting_.scene);
    std::vector<glm::vec3> lit(point.rgba.size() / 4);
    const std::string key = kept_as(values, view, point, light, to_sun);
    if (const auto kept = setting_.cache.find(key); kept && kept->size() == bytes_of(lit).size()) {
      std::memcpy(lit.data(), kept->data(), kept->size());
      return lit;
    }
    const ViewRays rays(view, point.width, point.height);
    const glm::dvec3 eye = glm::dvec3(view.eye) - glm::dvec3(0, sun("sea_level"), 0);
    const auto shade = [&](size_t i) {
      const glm::dvec4 there = pixel_of(point, i);
      const glm::dvec3 from_eye = glm::dvec3(there) - glm::dvec3(view.eye);
      const bool solid = there.a > 0;
      const glm::dvec3 direction = solid ? glm::normalize(from_eye) : rays.direction(i);
      const Scattered scattered = single_scattering(air, {eye, direction}, solid ? glm::length(from_eye) : INFINITY, !solid,
                                                    to_sun.value_or(glm::dvec3(0, 1, 0)));
      const glm::dvec3 behind(pixel_of(light, i));
      // A white surface shows its irradiance, pi times its radiance.
      const glm::dvec3 by_air = to_sun ? std::numbers::pi * above_air * scattered.radiance : glm::dvec3(0);
      lit[i] = behind * scattered.transmittance + by_air;
    };
    for (int row = 0; row < point.height; ++row) {
      progress(static_cast<double>(row) / point.height);
      const size_t first = static_cast<size_t>(row) * static_cast<size_t>(point.width);
      tbb::parallel_for(first, first + static_cast<size_t>(point.width), shade);
    }
    setting_.cache.keep(key, bytes_of(lit));
    return lit;
  }

  // All that the picture follows from.
  static std::string kept_as(const EffectValues& values, const View& view, const Image& point, const Image& light,
                             const std::optional<glm::dvec3>& to_sun) {
    constexpr int version = 1;  // changes when the same input no longer gives the same light
    std::string text = fmt::format("{} {} {} {}", version, point.width, point.height, view.fov_y_degrees);
    for (const glm::vec3 v : {view.eye, view.target, view.up}) text += fmt::format(" {} {} {}", v.x, v.y, v.z);
    if (to_sun) text += fmt::format(" {} {} {}", to_sun->x, to_sun->y, to_sun->z);
    for (const auto& [name, value] : values.numbers) text += fmt::format(" {} {}", name, value);
    return "air-" + hash_hex(text + hash_hex(bytes_of(point.rgba)) + hash_hex(bytes_of(light.rgba)));
  }

  TruthSetting setting_;
};

}  // namespace

std::unique_ptr<Truth> single_scattering_truth(const TruthSetting& setting) {
  return std::make_unique<SingleScatteringTruth>(setting);
}

std::optional<glm::dvec3> direction_to_sun(const Scene& scene) {
  for (const Light& light : scene.lights)
    if (light.kind == Light::Kind::directional) return -glm::normalize(glm::dvec3(light.direction));
  return std::nullopt;
}

}  // namespace lamina
