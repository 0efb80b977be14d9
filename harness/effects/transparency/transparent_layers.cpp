// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/transparency/transparent_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/effects/transparency/layer_shading.h"
#include "harness/truth/for_each_on_all_cores.h"
#include "harness/truth/view_rays.h"

namespace lamina {
namespace {

// What rays find at a pixel, whatever the variant.
struct TracedPixel {
  std::vector<PremultipliedLayer> middle;  // along the middle ray, the nearest first
  glm::dvec3 light{0};                     // mean over all rays, but for
  double frame = 0;                        // the share of the frame's own colour there
  bool seen = false;                       // some ray meets a transparent surface
};

class TransparentLayers : public Truth {
 public:
  explicit TransparentLayers(const TruthSetting& setting)
      : setting_(setting), rays_(setting.scene), shading_(setting.scene), background_(shading_.background()) {}

  TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) override {
    const Image& behind = told.target("seen_behind", "transparent_layers");
    if (traced_.empty()) trace(told.view, behind.width, behind.height, progress);
    const auto side = static_cast<size_t>(std::sqrt(static_cast<double>(setting_.rays)));
    TruthAnswer answer;
    answer.steps = {{"reconstruction", "this variant against the layers that it keeps, composited in order", {}},
                    {"layers", "the layers that it keeps against all", {}},
                    {"samples", fmt::format("the ray through a pixel's middle against {} rays", side * side), {}}};
    for (size_t pixel = 0; pixel < traced_.size(); ++pixel) {
      const TracedPixel& traced = traced_[pixel];
      if (!traced.seen) continue;
      answer.pixels.push_back(pixel);
      const float* told_here = &behind.rgba[4 * pixel];
      const glm::dvec3 frame(told_here[0], told_here[1], told_here[2]);
      const auto over = [&](size_t kept) {
        const LayersLight layers = composited(traced.middle, kept);
        return glm::vec3(layers.light + layers.through * frame);
      };
      answer.steps[0].light.push_back(over(static_cast<size_t>(told_here[3])));
      answer.steps[1].light.push_back(over(0));
      answer.steps[2].light.emplace_back(traced.light + traced.frame * frame);
    }
    if (answer.pixels.empty()) return {};
    return answer;
  }

  void view_changed() override { traced_.clear(); }

 private:
  struct OneRay {
    std::vector<PremultipliedLayer> layers;
    std::optional<glm::dvec3> behind;  // none: the frame's colour
  };
  OneRay follow(glm::dvec3 eye, glm::dvec3 direction) const {
    OneRay ray;
    ray.behind = background_;
    for (const LayerHit& hit : rays_.hits(eye, direction)) {
      if (!hit.transparent) {
        ray.behind = shading_.opaque(hit, eye);
        break;
      }
      const LayerShading::Layer layer = shading_.layer(hit, eye);
      if (layer.opacity > 0) ray.layers.push_back({layer.color * layer.opacity, layer.opacity});
    }
    return ray;
  }

  TracedPixel traced_pixel(const ViewRays& rays, glm::dvec3 eye, int column, int row) const {
    TracedPixel made;
    made.middle = follow(eye, rays.direction(column, row)).layers;
    made.seen = !made.middle.empty();
    const auto side = static_cast<int>(std::sqrt(static_cast<double>(setting_.rays)));
    const double share = 1.0 / (side * side);
    for (int i = 0; i < side * side; ++i) {
      const double x = (i % side + 0.5) / side, y = (std::floor(double(i) / side) + 0.5) / side;
      const OneRay ray = follow(eye, rays.through(column + x, row + y));
      made.seen = made.seen || !ray.layers.empty();
      const LayersLight layers = composited(ray.layers, 0);
      made.light += share * layers.light;
      if (ray.behind)
        made.light += share * layers.through * *ray.behind;
      else
        made.frame += share * layers.through;
    }
    return made;
  }

  void trace(const View& view, int width, int height, const std::function<void(double)>& progress) {
    const ViewRays rays(view, width, height);
    traced_.resize(size_t(width) * size_t(height));
    for_each_on_all_cores(static_cast<size_t>(height), progress, [&](size_t at) {
      const auto row = static_cast<int>(at);
      for (int column = 0; column < width; ++column)
        traced_[size_t(row) * size_t(width) + size_t(column)] = traced_pixel(rays, glm::dvec3(view.eye), column, row);
    });
  }

  TruthSetting setting_;
  LayerRays rays_;
  LayerShading shading_;
  std::optional<glm::dvec3> background_;
  std::vector<TracedPixel> traced_;  // of the view that was answered last
};

}  // namespace

LayersLight composited(const std::vector<PremultipliedLayer>& layers, size_t kept) {
  LayersLight sum;
  for (size_t i = 0; i < layers.size() && (kept == 0 || i < kept); ++i) {
    sum.light += sum.through * layers[i].light;
    sum.through *= 1 - layers[i].opacity;
  }
  return sum;
}

std::unique_ptr<Truth> transparent_layers_truth(const TruthSetting& setting) {
  return std::make_unique<TransparentLayers>(setting);
}

}  // namespace lamina
