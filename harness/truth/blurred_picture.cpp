// SPDX-License-Identifier: Apache-2.0
#include "harness/truth/blurred_picture.h"

#include <fmt/format.h>

#include "harness/truth/for_each_on_all_cores.h"

namespace lamina {

TruthAnswer blurred_picture_truth(const Image& picture, const View& view, const SceneSurfaces& surfaces,
                                  const std::string& named, const std::function<BlurredLight(const BlurredPixel&)>& light,
                                  const std::function<void(double)>& progress) {
  const ViewRays rays(view, picture.width, picture.height);
  const SeenPicture seen(picture, view);
  const glm::dvec3 eye(view.eye);
  TruthAnswer answer;
  std::vector<SurfaceHit> hits;
  for (size_t pixel = 0; pixel < size_t(picture.width) * size_t(picture.height); ++pixel)
    if (const auto hit = surfaces.chosen(eye, rays.direction(pixel))) {
      answer.pixels.push_back(pixel);
      hits.push_back(*hit);
    }
  if (hits.empty()) return {};
  std::vector<glm::vec3> shown(hits.size()), landed(hits.size());
  for_each_on_all_cores(hits.size(), progress, [&](size_t i) {
    const auto pixel = static_cast<int>(answer.pixels[i]);
    const BlurredLight found = light({hits[i], i, pixel % picture.width, pixel / picture.width, eye, rays, seen});
    shown[i] = found.shown, landed[i] = found.landed;
  });
  answer.steps = {
      {"blur", fmt::format("this variant's blur against rays that show what {} shows where they land", named),
       std::move(shown)},
      {"picture", fmt::format("{} where rays land against what they land on, hidden or not", named), std::move(landed)}};
  return answer;
}

}  // namespace lamina
