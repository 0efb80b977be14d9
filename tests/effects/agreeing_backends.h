// SPDX-License-Identifier: Apache-2.0
// Every variant of an effect on both software backends: pictures agree to 45 dB, no pixel is NaN or infinite, and no API call
// was wrong.
#pragma once

#include "harness/quality/quality.h"
#include "tests/graph/each_backend.h"

namespace lamina {

// Of the scene's first view, `size` pixels square. Skips the test where a backend does not open.
inline void expect_backends_agree(const Scene& scene, const std::string& effect, uint32_t size) {
  std::vector<std::unique_ptr<Backend>> backends;
  for (const std::string_view name : {"vulkan", "osmesa"}) {
    try {
      backends.push_back(open_backend(name, {"", true}));
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  const Library& library = builtin_library();
  const Plan plan = make_plan(library, scene);
  Bakes bakes(scene, *library.code, DiskCache(""));
  for (const VariantManifest& variant : library.effect(effect).variants) {
    std::vector<Image> pictures;
    for (const auto& backend : backends) {
      ShaderCache shaders(backend->info().api, library.shaders);
      SceneResources resources(*backend, scene, library, size, size, &bakes);
      const Graph graph = make_graph(plan, configuration_with(plan, variant), scene, shaders);
      Frame frame(resources, graph, Build::timed);
      frame.run_once(Timing::off);
      frame.run(0, Timing::off);
      pictures.push_back(frame.picture());
    }
    EXPECT_GE(psnr_db(to_display(pictures[0]), to_display(pictures[1])), 45) << variant.name;
    for (const Image& image : pictures)
      for (const float value : image.rgba) ASSERT_TRUE(std::isfinite(value)) << variant.name;
  }
  for (const auto& backend : backends)
    for (const std::string& message : backend->take_messages()) ADD_FAILURE() << message;
}

}  // namespace lamina
