// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/glossy_reflection/facet_rays.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "harness/truth/beckmann_facets.h"
#include "harness/truth/scene_surfaces.h"
#include "harness/truth/seen_picture.h"
#include "harness/truth/view_rays.h"

namespace lamina {
namespace {

constexpr double mirrored_far_m = 1e5;  // where a ray that meets nothing is seen

bool is_glossy(const Object& object) { return object.effects.contains("glossy_reflection"); }

// Within a millimetre and a degree of the plane.
bool in_mirror(const SurfaceHit& hit, double height_m) {
  return std::abs(hit.position.y - height_m) < 1e-3 && hit.normal.y > 0.9998;
}

// Schlick, Eurographics 1994.
double schlick(double reflectance, double cosine) {
  return reflectance + (1 - reflectance) * std::pow(1 - std::clamp(cosine, 0.0, 1.0), 5);
}

class FacetRays : public Truth {
 public:
  explicit FacetRays(const TruthSetting& setting)
      : scene_(setting.scene),
        rays_(setting.rays),
        height_m_(scene_.effects.at("glossy_reflection").numbers.find("height")->second),
        surfaces_(scene_, is_glossy,
                  [](const Object& object) -> const Texture& { return object.effects.at("surface").textures.at("albedo"); }) {}

  TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) override {
    const Image& picture = told.target("seen_in_mirror", "facet_rays");
    const ViewRays rays(told.view, picture.width, picture.height);
    const SeenPicture seen(picture, told.view);
    const glm::dvec3 eye(told.view.eye);
    TruthAnswer answer;
    std::vector<SurfaceHit> hits;
    for (size_t pixel = 0; pixel < size_t(picture.width) * size_t(picture.height); ++pixel)
      if (const auto hit = surfaces_.chosen(eye, rays.direction(pixel))) {
        answer.pixels.push_back(pixel);
        hits.push_back(*hit);
      }
    if (hits.empty()) return {};
    answer.steps = {{"blur", "this variant's blur against rays that show what the mirror's picture shows where they land",
                     std::vector<glm::vec3>(hits.size())},
                    {"picture", "the mirror's picture where rays land against what they land on, hidden or not",
                     std::vector<glm::vec3>(hits.size())}};
    std::mutex telling;
    std::atomic<size_t> done = 0;
    tbb::parallel_for(size_t{0}, hits.size(), [&](size_t i) {
      const SurfaceHit& hit = hits[i];
      const auto column = static_cast<int>(answer.pixels[i]) % picture.width,
                 row = static_cast<int>(answer.pixels[i]) / picture.width;
      const glm::dvec2 right = surfaces_.uv_beside(hit, eye, rays.direction(column + 1, row)),
                       down = surfaces_.uv_beside(hit, eye, rays.direction(column, row + 1));
      const Reflected light = reflected(hit, eye, i, seen);
      const glm::dvec3 own = own_light(hit, eye, surfaces_.albedo(hit.object).at(hit.uv, right, down));
      answer.steps[0].light[i] = own + light.shown;
      answer.steps[1].light[i] = own + light.landed;
      if (const size_t now = ++done; now % 1024 == 0) {
        const std::lock_guard lock(telling);
        progress(static_cast<double>(now) / static_cast<double>(hits.size()));
      }
    });
    progress(1);
    return answer;
  }

 private:
  double number(size_t object, const char* name) const {
    return scene_.objects[object].effects.find("glossy_reflection")->second.numbers.find(name)->second;
  }

  struct Reflected {
    glm::dvec3 shown{0}, landed{0};  // Fresnel's share is in both
  };
  // Beside the mirror's plane it is the ambient light. In it, facets count by the area that the eye sees of them, over the
  // surface's.
  Reflected reflected(const SurfaceHit& hit, glm::dvec3 eye, size_t pixel, const SeenPicture& seen) const {
    const glm::dvec3 to_eye = glm::normalize(eye - hit.position), n = hit.normal;
    const double slope = std::pow(number(hit.object, "roughness"), 2), straight_back = number(hit.object, "reflectance");
    if (!in_mirror(hit, height_m_)) {
      const glm::dvec3 around = glm::dvec3(scene_.ambient) * schlick(straight_back, glm::dot(n, to_eye));
      return {around, around};
    }
    Reflected sum;
    double weights = 0;
    for (size_t ray = 0; ray < rays_; ++ray) {
      const glm::dvec3 facet = beckmann_facet(slope, n, facet_share(ray, rays_, pixel));
      const double cosine = glm::dot(facet, to_eye);
      const glm::dvec3 along = 2 * cosine * facet - to_eye;
      if (cosine <= 0 || glm::dot(along, n) <= 0) continue;
      const double weight = cosine / glm::dot(facet, n), share = weight * schlick(straight_back, cosine);
      const auto met = surfaces_.opaque(hit.position + 1e-6 * n, along);
      const glm::dvec3 place = met ? met->position : hit.position + along * mirrored_far_m;
      sum.shown += share * seen.at(place - 2 * glm::dot(place - hit.position, n) * n);
      sum.landed += share * surfaces_.light(met);
      weights += weight;
    }
    if (weights > 0) sum.shown /= weights, sum.landed /= weights;
    return sum;
  }

  // Diffuse light of what is not reflected, and highlights.
  glm::dvec3 own_light(const SurfaceHit& hit, glm::dvec3 eye, glm::dvec3 albedo) const {
    const glm::dvec3 to_eye = glm::normalize(eye - hit.position);
    const double slope = std::pow(number(hit.object, "roughness"), 2), straight_back = number(hit.object, "reflectance");
    return albedo * surfaces_.diffuse(hit.position, hit.normal) * (1 - schlick(straight_back, glm::dot(to_eye, hit.normal))) +
           facet_highlights(scene_, std::max(slope, 0.02), hit.position, hit.normal, to_eye,
                            [&](double cosine) { return schlick(straight_back, cosine); });
  }

  const Scene& scene_;
  size_t rays_;  // a pixel
  double height_m_;
  SceneSurfaces surfaces_;
};

}  // namespace

std::unique_ptr<Truth> facet_rays(const TruthSetting& setting) { return std::make_unique<FacetRays>(setting); }

}  // namespace lamina
