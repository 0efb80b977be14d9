// SPDX-License-Identifier: Apache-2.0
// A test on every backend that opens here, with API checking on and silent at the end; a backend that does not open is skipped
// with its reason.
#pragma once

#include <gtest/gtest.h>

#include "tests/builtin_library.h"
#include "tests/graph/drawn_frame.h"
#include "tests/open_backend.h"

namespace lamina {

class EachBackend : public testing::TestWithParam<std::string_view> {
 protected:
  void SetUp() override {
    std::string missing;
    backend_ = open_or_say(GetParam(), missing, {.device = "", .validation = true});
    if (!backend_) GTEST_SKIP() << missing;
  }
  void TearDown() override {
    if (!backend_) return;
    for (const std::string& message : backend_->take_messages()) ADD_FAILURE() << message;
  }

  const Library& library() { return builtin_library(); }
  const VariantManifest& variant(std::string_view name) {
    for (const EffectManifest& effect : library().effects)
      if (const VariantManifest* found = effect.variant(name)) return *found;
    throw std::runtime_error("no such variant");
  }
  static const VariantManifest& named_in(const EffectManifest& effect, std::string_view name) {
    if (const VariantManifest* found = effect.variant(name)) return *found;
    throw std::runtime_error("no such variant");
  }
  // The picture of view 0 by a variant.
  Image picture(const Scene& scene, std::string_view name, uint32_t size = 64, Build build = Build::timed) {
    return DrawnFrame(*backend_, library(), scene,
                      {.variant = &variant(name), .width = size, .height = size, .build = build, .aspect = 1})
        .picture();
  }
  static glm::vec3 pixel(const Image& image, int x, int y) {
    const size_t at = (size_t(y) * size_t(image.width) + size_t(x)) * 4;
    return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2]};
  }

  std::unique_ptr<Backend> backend_;
};

inline const auto backend_parameters =
    testing::ValuesIn(std::vector<std::string_view>(backend_names().begin(), backend_names().end()));
// One for each API: EGL runs the code of OSMesa on another context, which tests of backends, shaders and graphs look at.
inline const auto api_parameters = testing::Values("vulkan", "osmesa");
inline std::string backend_test_name(const testing::TestParamInfo<std::string_view>& info) { return std::string(info.param); }

}  // namespace lamina
