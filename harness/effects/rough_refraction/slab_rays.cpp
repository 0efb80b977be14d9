// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/rough_refraction/slab_rays.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <mutex>

#include "harness/effects/rough_refraction/glass_slab.h"
#include "harness/truth/beckmann_facets.h"
#include "harness/truth/scene_surfaces.h"
#include "harness/truth/seen_picture.h"
#include "harness/truth/view_rays.h"

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
    const Image& picture = told.target("seen_behind", "slab_rays");
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
    answer.steps = {{"blur", "this variant's blur against rays that show what the picture shows where they land",
                     std::vector<glm::vec3>(hits.size())},
                    {"picture", "the picture where rays land against what they land on, hidden or not",
                     std::vector<glm::vec3>(hits.size())}};
    std::mutex telling;
    std::atomic<size_t> done = 0;
    tbb::parallel_for(size_t{0}, hits.size(), [&](size_t i) {
      const SurfaceHit& hit = hits[i];
      const GlassSlab slab = *glass_slab(scene_.objects[hit.object]);
      const glm::dvec3 to_eye = glm::normalize(eye - hit.position);
      glm::dvec3 shown(0), landed(0);
      size_t passed = 0;
      for (size_t ray = 0; ray < rays_; ++ray) {
        const auto passing =
            through(slab, hit.position, hit.normal, beckmann_facet(slab.slope, hit.normal, facet_share(ray, rays_, i)), to_eye);
        if (!passing) continue;
        const auto met = surfaces_.opaque(passing->from, passing->direction);
        shown += seen.at(met ? met->position : passing->from + passing->direction * far_m);
        landed += surfaces_.light(met);
        ++passed;
      }
      const double share = passed > 0 ? 1.0 / static_cast<double>(passed) : 0;
      answer.steps[0].light[i] = seen_in_glass(slab, scene_, hit.position, hit.normal, to_eye, shown * share);
      answer.steps[1].light[i] = seen_in_glass(slab, scene_, hit.position, hit.normal, to_eye, landed * share);
      if (const size_t now = ++done; now % 1024 == 0) {
        const std::lock_guard lock(telling);
        progress(static_cast<double>(now) / static_cast<double>(hits.size()));
      }
    });
    progress(1);
    return answer;
  }

 private:
  const Scene& scene_;
  size_t rays_;  // a pixel
  SceneSurfaces surfaces_;
};

}  // namespace

std::unique_ptr<Truth> slab_rays(const TruthSetting& setting) { return std::make_unique<SlabRays>(setting); }

}  // namespace lamina
