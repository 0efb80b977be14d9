// SPDX-License-Identifier: Apache-2.0
// Scenes of transparent sheets whose colour can be worked out by hand, and what variants make of them.
#pragma once

#include <algorithm>

#include "harness/effects/transparency/transparent_layers.h"
#include "harness/scene/facts.h"
#include "harness/scene/made/transparent_object.h"
#include "tests/effects/fog_cases.h"

namespace lamina {

inline constexpr float half_error = 2.0f / 1024;  // of frames in 16-bit floats, which llvmpipe rounds towards 0

struct Sheet {
  double opacity;
  glm::vec3 color;
  float z;  // metres before the eye
};

// Facts too, which features ask for.
inline Scene settled_glass(Scene scene) {
  scene = settled(std::move(scene));
  for (Object& object : scene.objects)
    for (const EffectManifest& effect : builtin_library().effects) settle_facts(object, effect);
  return scene;
}

inline Object sheet_object(const std::string& name, const Sheet& sheet) {
  Object object = transparent_object(name, unit_square(), {sheet.color, sheet.opacity, 0, 1, 0});
  object.world_from_object = glm::scale(glm::translate(glm::mat4(1), glm::vec3(0, 0, -sheet.z)), glm::vec3(4 * sheet.z));
  return object;
}

// Sheets that fill the view, in this order, under even light of 1.
inline Scene glass_sheets(const std::vector<Sheet>& sheets, glm::vec3 background) {
  Scene scene;
  scene.name = scene.source = "sheets";
  for (const Sheet& sheet : sheets)
    scene.objects.push_back(sheet_object("sheet_" + std::to_string(scene.objects.size()), sheet));
  scene.ambient = glm::vec3(1);
  scene.background = background;
  scene.views = {{"view", {0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 40, 0.1f, 500}};
  return settled_glass(std::move(scene));
}

// Over black, of opacities, colours and depths that the weights of blended transparency were computed for.
inline std::vector<Sheet> four_sheets() {
  return {{0.5, {1, 0, 0}, 2}, {0.5, {0, 1, 0}, 4}, {0.25, {0, 0, 1}, 6}, {0.75, {1, 1, 1}, 8}};
}

class GlassOnEachBackend : public EachBackend {
 protected:
  std::unique_ptr<DrawnFrame> drawing(const Scene& scene, std::string_view name, uint32_t size,
                                      const Parameters& parameters = {}, const VariantManifest* told = nullptr) {
    return std::make_unique<DrawnFrame>(
        *backend_, library(), scene,
        DrawnFrame::Choice{.variant = &variant(name), .width = size, .height = size, .parameters = parameters, .told = told});
  }
  Image glass(const Scene& scene, std::string_view name, uint32_t size = 16, const Parameters& parameters = {}) {
    return drawing(scene, name, size, parameters)->frame.picture();
  }
  // The truth's steps for the picture of a variant.
  TruthAnswer truth_of(const Scene& scene, std::string_view name, uint32_t size, size_t rays) {
    const auto made = drawing(scene, name, size, {}, &variant(name));
    const auto targets = made->frame.targets_of(variant(name));
    DiskCache cache{""};
    return transparent_layers_truth({scene, made->bakes.occluders(), cache, rays})
        ->answer({targets, scene.views[0], {}}, [](double) {});
  }
};

inline Image with_answer(Image around, const TruthAnswer& answer, size_t step) {
  for (size_t i = 0; i < answer.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) around.rgba[4 * answer.pixels[i] + c] = answer.steps[step].light[i][c];
  return around;
}

inline size_t count_nonfinite(const Image& image) {
  return static_cast<size_t>(std::ranges::count_if(image.rgba, [](float value) { return !std::isfinite(value); }));
}

}  // namespace lamina
