// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/rough_refraction/slab_rays.h"

#include "harness/effects/rough_refraction/glass_slab.h"
#include "harness/truth/beckmann_facets.h"
#include "harness/truth/blurred_picture.h"

namespace lamina {
namespace {

constexpr double far_m = 1e5;  // where a ray that meets nothing is seen

class SlabRays : public Truth {
 public:
  explicit SlabRays(const TruthSetting& setting)
      : scene_(setting.scene),
        rays_(setting.rays),
        surfaces_(
            scene_, [](const Object& object) { return glass_slab(object).has_value(); },
            [](const Object& object) -> const Texture& { return object.effects.at("surface").textures.at("albedo"); }) {}

  TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) override {
    return blurred_picture_truth(
        told.target("seen_behind", "slab_rays"), told.view, surfaces_, "the picture",
        [&](const BlurredPixel& pixel) { return light(pixel); }, progress);
  }

 private:
  BlurredLight light(const BlurredPixel& pixel) const {
    const SurfaceHit& hit = pixel.hit;
    const GlassSlab slab = *glass_slab(scene_.objects[hit.object]);
    const glm::dvec3 to_eye = glm::normalize(pixel.eye - hit.position);
    BlurredLight sum;
    size_t passed = 0;
    for (size_t ray = 0; ray < rays_; ++ray) {
      const glm::dvec3 facet = beckmann_facet(slab.slope, hit.normal, facet_share(ray, rays_, pixel.index));
      const auto passing = through(slab, hit.position, hit.normal, facet, to_eye);
      if (!passing) continue;
      const auto met = surfaces_.opaque(passing->from, passing->direction);
      sum.shown += pixel.seen.at(met ? met->position : passing->from + passing->direction * far_m);
      sum.landed += surfaces_.light(met);
      ++passed;
    }
    const double share = passed > 0 ? 1.0 / static_cast<double>(passed) : 0;
    return {seen_in_glass(slab, scene_, hit.position, hit.normal, to_eye, sum.shown * share),
            seen_in_glass(slab, scene_, hit.position, hit.normal, to_eye, sum.landed * share)};
  }

  const Scene& scene_;
  size_t rays_;  // a pixel
  SceneSurfaces surfaces_;
};

}  // namespace

std::unique_ptr<Truth> slab_rays(const TruthSetting& setting) { return std::make_unique<SlabRays>(setting); }

}  // namespace lamina
