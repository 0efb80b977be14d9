// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/glossy_reflection/facet_rays.h"

#include <algorithm>
#include <cmath>

#include "harness/truth/beckmann_facets.h"
#include "harness/truth/blurred_picture.h"

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
    return blurred_picture_truth(
        told.target("seen_in_mirror", "facet_rays"), told.view, surfaces_, "the mirror's picture",
        [&](const BlurredPixel& pixel) { return light(pixel); }, progress);
  }

 private:
  BlurredLight light(const BlurredPixel& pixel) const {
    const glm::dvec2 right = surfaces_.uv_beside(pixel.hit, pixel.eye, pixel.rays.direction(pixel.column + 1, pixel.row)),
                     down = surfaces_.uv_beside(pixel.hit, pixel.eye, pixel.rays.direction(pixel.column, pixel.row + 1));
    const BlurredLight mirrored = reflected(pixel.hit, pixel.eye, pixel.index, pixel.seen);
    const glm::dvec3 own = own_light(pixel.hit, pixel.eye, surfaces_.albedo(pixel.hit.object).at(pixel.hit.uv, right, down));
    return {own + mirrored.shown, own + mirrored.landed};
  }

  double number(size_t object, const char* name) const {
    return scene_.objects[object].effects.find("glossy_reflection")->second.numbers.find(name)->second;
  }

  // Fresnel's share is in both. Beside the mirror's plane it is the ambient light. In it, facets count by the area that the eye
  // sees of them, over the surface's.
  BlurredLight reflected(const SurfaceHit& hit, glm::dvec3 eye, size_t pixel, const SeenPicture& seen) const {
    const glm::dvec3 to_eye = glm::normalize(eye - hit.position), n = hit.normal;
    const double slope = std::pow(number(hit.object, "roughness"), 2), straight_back = number(hit.object, "reflectance");
    if (!in_mirror(hit, height_m_)) {
      const glm::dvec3 around = glm::dvec3(scene_.ambient) * schlick(straight_back, glm::dot(n, to_eye));
      return {around, around};
    }
    BlurredLight sum;
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
