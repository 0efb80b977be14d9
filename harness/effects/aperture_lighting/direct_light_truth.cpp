// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/aperture_lighting/direct_light_truth.h"

#include <cstring>

#include "harness/core/bytes.h"
#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/effects/aperture_lighting/aperture_baker.h"
#include "harness/effects/aperture_lighting/direct_light.h"

namespace lamina {
namespace {

// All that light at the points follows from.
std::string light_key(const ShadingPoints& points, const Scene& scene, const Occluders& occluders, LightModel model,
                      const DirectLightOptions& options) {
  constexpr int version = 1;  // changes when the same input no longer gives the same light
  std::string text =
      fmt::format("{} {} {} {} {} {} {} {}", version, static_cast<int>(model), occluders.hash(), points.kind.count,
                  points.kind.anti + 2 * points.kind.choice, options.light_rays, options.seed, options.bias_m);
  std::string seen;  // member by member: bytes that pad a point differ from one run to the next
  for (const ShadingPoint& point : points.points) {
    seen += bytes_of(point.pixel);
    for (const glm::vec3& v : {point.position, point.normal, point.albedo}) seen += bytes_of(v);
  }
  text += hash_hex(seen) + hash_hex(bytes_of(points.apertures));
  const auto add = [&](glm::vec3 v) { text += fmt::format(" {} {} {}", v.x, v.y, v.z); };
  add(scene.ambient);
  for (const Light& light : scene.lights) {
    text += fmt::format(" {} {} {}", static_cast<int>(light.kind), light.angular_radius, light.radius_m);
    add(light.direction), add(light.position), add(light.radiance);
  }
  return "light-" + hash_hex(text);
}

ShadingPoints told_points(const Told& told) {
  const ApertureKind kind = aperture_kind(told.bake);
  std::vector<Image> apertures;
  for (uint32_t i = 0; i < kind.count; ++i)
    apertures.push_back(told.target(fmt::format("seen_aperture_{}", i), "direct_light"));
  return shading_points(told.target("seen_point", "direct_light"), told.target("seen_normal", "direct_light"),
                        told.target("seen_albedo", "direct_light"), apertures, kind);
}

class DirectLightTruth : public Truth {
 public:
  explicit DirectLightTruth(const TruthSetting& setting) : setting_(setting) {
    options_.light_rays = options_.sky_rays = setting.rays;
    options_.bias_m = setting.occluders.default_bias_m();
  }

  TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) override {
    ShadingPoints points = told_points(told);
    if (points.points.empty()) return {};
    TruthAnswer answer;
    for (const ShadingPoint& point : points.points) answer.pixels.push_back(point.pixel);
    answer.steps = {{"intersection", "this intersection against the exact one",
                     light(points, LightModel::exact_intersection, [](double) {})},
                    {"cosine", "the cosine at the middle against the cosine integrated",
                     light(points, LightModel::integrated_cosine, [](double) {})},
                    {"aperture", "circular apertures against traced visibility", traced(std::move(points), progress)}};
    return answer;
  }

  void view_changed() override {
    traced_key_.clear();
    traced_.clear();
  }

 private:
  std::string key(const ShadingPoints& points, LightModel model) const {
    return light_key(points, setting_.scene, setting_.occluders, model, options_);
  }

  // From the disk, or made.
  std::vector<glm::vec3> light(const ShadingPoints& points, LightModel model,
                               const std::function<void(double)>& progress) const {
    const std::string kept_as = key(points, model);
    std::vector<glm::vec3> light(points.points.size());
    if (const auto kept = setting_.cache.find(kept_as); kept && kept->size() == bytes_of(light).size()) {
      std::memcpy(light.data(), kept->data(), kept->size());
      return light;
    }
    light = direct_light(points, setting_.scene, setting_.occluders, model, options_, progress);
    setting_.cache.keep(kept_as, bytes_of(light));
    return light;
  }

  // Rays do not depend on apertures, so variants that show the same points share their light.
  const std::vector<glm::vec3>& traced(ShadingPoints points, const std::function<void(double)>& progress) {
    points.apertures.clear();
    points.kind = {.count = 0};
    if (const std::string now = key(points, LightModel::traced); now != traced_key_) {
      traced_ = light(points, LightModel::traced, progress);
      traced_key_ = now;
    }
    return traced_;
  }

  TruthSetting setting_;
  DirectLightOptions options_;
  std::string traced_key_;
  std::vector<glm::vec3> traced_;
};

}  // namespace

std::unique_ptr<Truth> direct_light_truth(const TruthSetting& setting) { return std::make_unique<DirectLightTruth>(setting); }

}  // namespace lamina
