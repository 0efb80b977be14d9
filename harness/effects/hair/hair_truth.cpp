// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/hair/hair_truth.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "harness/effects/hair/hair_light.h"
#include "harness/truth/for_each_on_all_cores.h"
#include "harness/truth/view_rays.h"

namespace lamina {
namespace {

struct Blended {
  glm::dvec3 light{0};  // of the hair, premultiplied
  double through = 1;   // of what is behind
  bool met = false;     // some card, however thin there
};

class SortedCards : public Truth {
 public:
  explicit SortedCards(const TruthSetting& setting)
      : scene_(setting.scene),
        side_(std::clamp(static_cast<int>(std::sqrt(static_cast<double>(setting.rays))), 1, 8)),
        cards_(scene_) {}

  TruthAnswer answer(const Told& told, const std::function<void(double)>& progress) override {
    lights_.clear();  // the scene's numbers may have changed
    for (size_t i = 0; i < scene_.objects.size(); ++i)
      if (scene_.objects[i].effects.contains("hair")) lights_.emplace(i, std::make_unique<HairLight>(scene_, i));
    const Image& behind = told.target("seen_behind", "sorted_cards");
    const int width = behind.width, height = behind.height;
    const size_t pixels = size_t(width) * size_t(height);
    std::vector<Blended> one(pixels), many(pixels);
    for_each_on_all_cores(static_cast<size_t>(height), progress, [&](size_t at) {
      const auto row = static_cast<int>(at);
      const ViewRays middles(told.view, width, height), samples(told.view, width * side_, height * side_);
      for (int column = 0; column < width; ++column) {
        const size_t pixel = size_t(row) * size_t(width) + size_t(column);
        one[pixel] = blended(told.view, middles, column, row);
        Blended& mean = many[pixel];
        mean.through = 0;
        for (int i = 0; i < side_ * side_; ++i) {
          const Blended sample = blended(told.view, samples, column * side_ + i % side_, row * side_ + i / side_);
          mean.light += sample.light / double(side_ * side_);
          mean.through += sample.through / (side_ * side_);
          mean.met = mean.met || sample.met;
        }
      }
    });
    TruthAnswer answer;
    answer.steps = {{"coverage", "this variant's coverage, order and shading against sorted cards along one ray a pixel", {}},
                    {"one_ray", "one ray a pixel against all of a pixel", {}}};
    for (size_t pixel = 0; pixel < pixels; ++pixel) {
      if (!one[pixel].met && !many[pixel].met) continue;
      answer.pixels.push_back(pixel);
      const float* seen = &behind.rgba[4 * pixel];
      const glm::dvec3 frame(seen[0], seen[1], seen[2]);
      answer.steps[0].light.emplace_back(one[pixel].light + one[pixel].through * frame);
      answer.steps[1].light.emplace_back(many[pixel].light + many[pixel].through * frame);
    }
    if (answer.pixels.empty()) return {};
    return answer;
  }

 private:
  Blended blended(const View& view, const ViewRays& rays, int column, int row) const {
    Blended sum;
    const glm::dvec3 eye(view.eye), direction = rays.direction(column, row);
    for (const CardHit& hit : cards_.hits(eye, direction, rays.direction(column + 1, row), rays.direction(column, row + 1))) {
      const HairLight& light = *lights_.at(hit.object);
      const double opacity = light.opacity(hit);
      if (opacity < 1.0 / 255) continue;  // as cards are cut: nothing is there
      sum.met = true;
      sum.light += sum.through * opacity * light.light(hit, -direction);
      sum.through *= 1 - opacity;
      if (sum.through < 1e-4) break;
    }
    return sum;
  }

  const Scene& scene_;
  int side_;  // of a pixel's rays
  CardRays cards_;
  std::map<size_t, std::unique_ptr<HairLight>> lights_;
};

}  // namespace

std::unique_ptr<Truth> hair_truth(const TruthSetting& setting) { return std::make_unique<SortedCards>(setting); }

}  // namespace lamina
