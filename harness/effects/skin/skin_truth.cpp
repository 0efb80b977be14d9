// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/skin/skin_truth.h"

#include <cmath>
#include <map>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "harness/effects/skin/diffusion.h"
#include "harness/truth/for_each_on_all_cores.h"
#include "harness/truth/pixel_of.h"

namespace lamina {
namespace {

constexpr int shadow_rays = 16;  // of a highlight

struct SeenSkin {
  size_t object;
  glm::dvec3 position, normal, albedo;
  double specular, roughness;  // of the specular map
};

double smooth_ramp(double x) {
  const double t = std::clamp(x / 0.5, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

class SkinTruth : public Truth {
 public:
  explicit SkinTruth(const TruthSetting& setting) : setting_(setting) {}

  TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) override {
    surfaces_.clear();  // the scene's numbers may have changed
    for (size_t i = 0; i < setting_.scene.objects.size(); ++i)
      if (setting_.scene.objects[i].effects.contains("skin"))
        surfaces_.emplace(i, std::make_unique<SkinSurface>(setting_.scene, setting_.occluders, i));
    TruthAnswer answer;
    const std::vector<SeenSkin> points = seen(told, answer.pixels);
    if (points.empty()) return {};
    std::vector<glm::vec3> same_side(points.size()), all(points.size());
    const glm::dvec3 eye(told.view.eye);
    for_each_on_all_cores(points.size(), progress, [&](size_t i) {
      const SeenSkin& point = points[i];
      const SkinSurface& surface = *surfaces_.at(point.object);
      const glm::dvec3 to_eye = glm::normalize(eye - point.position);
      const DiffusedLight light =
          diffused_light(surface, point.position, point.normal, std::max<size_t>(setting_.rays, 12), 1 + i);
      const double lost =
          surface.number("specular") * point.specular *
          surface.reflection().share(glm::dot(point.normal, to_eye), surface.number("roughness") * point.roughness);
      const glm::dvec3 out = glm::sqrt(point.albedo) * (1 - lost), shine = highlights(surface, point, to_eye);
      same_side[i] = glm::vec3(out * light.same_side + shine);
      all[i] = glm::vec3(out * light.all + shine);
    });
    answer.steps = {
        {"diffusion", "this variant's light, shadows and highlights against the profile over this side of the surface",
         std::move(same_side)},
        {"transmission", "this side of the surface against all of it, by chords through thin parts", std::move(all)}};
    return answer;
  }

 private:
  std::vector<SeenSkin> seen(const Told& told, std::vector<size_t>& pixels) const {
    const Image &point = told.target("seen_point", "skin"), &normal = told.target("seen_normal", "skin"),
                &albedo = told.target("seen_albedo", "skin");
    std::vector<SeenSkin> points;
    for (size_t i = 0; i < size_t(point.width) * size_t(point.height); ++i) {
      const glm::dvec4 at = pixel_of(point, i), facing = pixel_of(normal, i), colour = pixel_of(albedo, i);
      const auto place = static_cast<long>(std::lround(at.a)) - 1;
      if (place < 0 || !surfaces_.contains(size_t(place))) continue;
      pixels.push_back(i);
      points.push_back(
          {size_t(place), glm::dvec3(at), glm::normalize(glm::dvec3(facing)), glm::dvec3(colour), facing.a, colour.a});
    }
    return points;
  }

  // Highlights of all lights, as far as light reaches the point.
  glm::dvec3 highlights(const SkinSurface& surface, const SeenSkin& point, glm::dvec3 to_eye) const {
    glm::dvec3 sum(0);
    const double specular = surface.number("specular") * point.specular, oil = surface.number("oil"),
                 rim = surface.number("rim"), f0 = surface.number("reflectance");
    if (specular <= 0 && oil <= 0 && rim <= 0) return sum;
    for (const Light& light : setting_.scene.lights) {
      const SkinLight arriving = skin_light(light, point.position);
      const double nl = glm::dot(point.normal, arriving.to_light);
      if (nl <= 0) continue;
      int lit = 0;
      for (int k = 0; k < shadow_rays; ++k) {
        const double r = std::sqrt((k + 0.5) / shadow_rays), turn = 2.399963229728653 * k;
        lit += surface.lit(light, arriving, point.position, point.normal, {r * std::cos(turn), r * std::sin(turn)});
      }
      double shine = specular * kelemen_reflection(point.normal, arriving.to_light, to_eye,
                                                   surface.number("roughness") * point.roughness, f0) +
                     oil * kelemen_reflection(point.normal, arriving.to_light, to_eye, surface.number("oil_roughness"), f0);
      if (rim > 0) {
        const double nv = std::clamp(glm::dot(point.normal, to_eye), 0.0, 1.0),
                     nh = std::max(glm::dot(point.normal, glm::normalize(arriving.to_light + to_eye)), 0.0);
        shine += rim * smooth_ramp(schlick_reflectance(nv, f0)) * std::pow(nh, surface.number("rim_power")) * nl;
      }
      sum += arriving.irradiance * (shine * lit / shadow_rays);
    }
    return sum;
  }

  TruthSetting setting_;
  std::map<size_t, std::unique_ptr<SkinSurface>> surfaces_;
};

}  // namespace

std::unique_ptr<Truth> skin_truth(const TruthSetting& setting) { return std::make_unique<SkinTruth>(setting); }

}  // namespace lamina
