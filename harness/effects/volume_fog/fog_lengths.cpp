// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/volume_fog/fog_lengths.h"

#include <algorithm>
#include <cmath>

#include "harness/core/error.h"
#include "harness/effects/volume_fog/fog_color.h"
#include "harness/truth/view_rays.h"

namespace lamina {
namespace {

HullRays solids_of(const Scene& scene) {
  std::vector<const Object*> solids;
  for (const Object& object : scene.objects)
    if (object.solid) solids.push_back(&object);
  return HullRays(solids);
}

class FogLengths : public Truth {
 public:
  explicit FogLengths(const TruthSetting& setting) : scene_(setting.scene) {}

  TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) override {
    const Image &behind = told.target("seen_behind", "fog_lengths"), &depths = told.target("seen_depths", "fog_lengths");
    const auto width = static_cast<uint32_t>(depths.width), height = static_cast<uint32_t>(depths.height);
    // Rays do not depend on the variant.
    if (lengths_m_.empty()) lengths_m_ = FogTracer(scene_).lengths_m(told.view, width, height, progress);
    const ViewRays rays(told.view, depths.width, depths.height);
    const FogColor color(scene_);
    TruthAnswer answer;
    answer.steps = {{"ramp", "the variant's way from thickness to colour against the scene's own", {}},
                    {"resolution", "thickness at the variant's resolution against every pixel's", {}},
                    {"encoding", "depths as the variant encodes them against floats", {}},
                    {"raster", "rasterized depths against lengths of rays", {}}};
    for (size_t pixel = 0; pixel < lengths_m_.size(); ++pixel) {
      const float* depth = &depths.rgba[4 * pixel];
      if (lengths_m_[pixel] == 0 && depth[0] == 0 && depth[1] == 0 && depth[2] == 0) continue;
      answer.pixels.push_back(pixel);
      const glm::dvec3 frame(behind.rgba[4 * pixel], behind.rgba[4 * pixel + 1], behind.rgba[4 * pixel + 2]);
      // Metres along the ray for a metre along the view's axis.
      const double stretch = 1 / glm::dot(rays.direction(pixel), rays.ahead());
      for (size_t step = 0; step < 4; ++step)
        answer.steps[step].light.emplace_back(color.over(frame, step < 3 ? depth[step] * stretch : lengths_m_[pixel]));
    }
    if (answer.pixels.empty()) return {};
    return answer;
  }

  void view_changed() override { lengths_m_.clear(); }

 private:
  const Scene& scene_;
  std::vector<double> lengths_m_;  // of the view that was answered last
};

}  // namespace

FogTracer::FogTracer(const Scene& scene) : solids_(solids_of(scene)) {
  for (const Object& object : scene.objects) {
    const auto fog = object.effects.find("volume_fog");
    if (fog == object.effects.end()) continue;
    const double share = fact_or_number(fog->second, "share");
    if (share > 0) hulls_.push_back({HullRays({&object}), fog->second.words.at("volume") == "hole" ? -share : share});
  }
}

std::vector<double> FogTracer::lengths_m(const View& view, uint32_t width_px, uint32_t height_px,
                                         const std::function<void(double)>& progress) const {
  const ViewRays rays(view, static_cast<int>(width_px), static_cast<int>(height_px));
  std::vector<int> around_eye;
  for (const Hull& hull : hulls_) around_eye.push_back(hull.rays.around(view.eye));
  std::vector<double> lengths_m(size_t(width_px) * height_px);
  for (size_t pixel = 0; pixel < lengths_m.size(); ++pixel) {
    if (pixel % width_px == 0) progress(static_cast<double>(pixel) / static_cast<double>(lengths_m.size()));
    const FogRay ray{view.eye, rays.direction(pixel)};
    const double end = solids_.first_front_m(ray);
    double sum = 0;
    for (size_t i = 0; i < hulls_.size(); ++i) sum += hulls_[i].share * hulls_[i].rays.length_m(ray, end, around_eye[i]);
    lengths_m[pixel] = std::max(sum, 0.0);
  }
  return lengths_m;
}

std::unique_ptr<Truth> fog_lengths_truth(const TruthSetting& setting) { return std::make_unique<FogLengths>(setting); }

}  // namespace lamina
