// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/rough_refraction/slab_rays.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "harness/effects/rough_refraction/scene_behind.h"
#include "harness/truth/view_rays.h"

namespace lamina {
namespace {

constexpr double far_m = 1e5;  // where a ray that meets nothing is seen

// The picture, bilinear between pixels' middles, at what lies in the direction from the eye; its edges are held.
class SeenPicture {
 public:
  SeenPicture(const Image& image, const View& view)
      : image_(image),
        ahead_(glm::normalize(glm::dvec3(view.target) - glm::dvec3(view.eye))),
        right_(glm::normalize(glm::cross(ahead_, glm::dvec3(view.up)))),
        up_(glm::cross(right_, ahead_)),
        eye_(view.eye),
        scale_(image.height / 2.0 / std::tan(glm::radians(double(view.fov_y_degrees)) / 2)) {}

  glm::dvec3 at(glm::dvec3 world) const {
    const glm::dvec3 seen = world - eye_;
    const double depth = std::max(glm::dot(seen, ahead_), 1e-6);
    const double x = std::clamp(image_.width / 2.0 + scale_ * glm::dot(seen, right_) / depth - 0.5, 0.0, image_.width - 1.0);
    const double y = std::clamp(image_.height / 2.0 - scale_ * glm::dot(seen, up_) / depth - 0.5, 0.0, image_.height - 1.0);
    const int left = std::min(static_cast<int>(x), image_.width - 2), top = std::min(static_cast<int>(y), image_.height - 2);
    return glm::mix(glm::mix(pixel(left, top), pixel(left + 1, top), x - left),
                    glm::mix(pixel(left, top + 1), pixel(left + 1, top + 1), x - left), y - top);
  }

 private:
  glm::dvec3 pixel(int x, int y) const {
    const float* rgba = &image_.rgba[4 * (size_t(y) * size_t(image_.width) + size_t(x))];
    return {rgba[0], rgba[1], rgba[2]};
  }
  const Image& image_;
  glm::dvec3 ahead_, right_, up_, eye_;
  double scale_;
};

class SlabRays : public Truth {
 public:
  explicit SlabRays(const TruthSetting& setting) : scene_(setting.scene), rays_(setting.rays), behind_(scene_) {}

  TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) override {
    const Image& picture = told.target("seen_behind", "slab_rays");
    const ViewRays rays(told.view, picture.width, picture.height);
    const SeenPicture seen(picture, told.view);
    const glm::dvec3 eye(told.view.eye);
    TruthAnswer answer;
    std::vector<SurfaceHit> hits;
    for (size_t pixel = 0; pixel < size_t(picture.width) * size_t(picture.height); ++pixel)
      if (const auto hit = behind_.glass(eye, rays.direction(pixel))) {
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
        // Plastic numbers' sequence (Roberts 2018), shifted from pixel to pixel.
        const double n = static_cast<double>(ray) + 0.618 * static_cast<double>(i % 4096);
        const glm::dvec2 share =
            glm::fract(glm::dvec2((static_cast<double>(ray) + 0.5) / static_cast<double>(rays_), 0.5698402909980532 * n));
        const auto passing = through(slab, hit.position, hit.normal, slab_facet(slab, hit.normal, share), to_eye);
        if (!passing) continue;
        const auto met = behind_.opaque(passing->from, passing->direction);
        shown += seen.at(met ? met->position : passing->from + passing->direction * far_m);
        landed += behind_.light(met);
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
  SceneBehind behind_;
};

}  // namespace

std::unique_ptr<Truth> slab_rays(const TruthSetting& setting) { return std::make_unique<SlabRays>(setting); }

}  // namespace lamina
