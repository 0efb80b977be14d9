// SPDX-License-Identifier: Apache-2.0
// Pictures of every variant of an effect on Vulkan against those on OpenGL.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "harness/graph/frame.h"
#include "harness/quality/quality.h"
#include "tests/builtin_library.h"

namespace lamina {

inline constexpr double min_agreement_db = 45;

// Small pictures of each scene's first view: 45 dB at least, no value that is not finite, no message of an API's checker. Skips
// the test where one of the two is not here. `said` are values of parameters by name, for the variants that have them.
// `baseline_alone`: no other variant is drawn.
inline void expect_backends_agree(std::string_view effect, const std::vector<Scene>& scenes, uint32_t size = 48,
                                  const std::map<std::string, double>& said = {}, bool baseline_alone = false) {
  std::vector<std::unique_ptr<Backend>> backends;
  for (const std::string_view name : {"vulkan", "osmesa"}) {
    try {
      backends.push_back(open_backend(name, {"", true}));
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
  }
  const Library& library = builtin_library();
  for (const Scene& scene : scenes) {
    const Plan plan = make_plan(library, scene, 1);
    Bakes bakes(scene, *library.code, DiskCache(""));
    std::vector<std::unique_ptr<SceneResources>> resources;
    std::vector<std::unique_ptr<ShaderCache>> shaders;
    for (const auto& backend : backends) {
      resources.push_back(std::make_unique<SceneResources>(*backend, scene, library, size, size, &bakes));
      shaders.push_back(std::make_unique<ShaderCache>(backend->info().api, library.shaders));
    }
    for (const VariantManifest& variant : library.effect(effect).variants) {
      if (baseline_alone && !variant.baseline) continue;
      SCOPED_TRACE(scene.name + " " + variant.name);
      Parameters parameters;
      for (const auto& [name, value] : said)
        if (variant.parameter(name)) parameters[variant.name + "." + name] = value;
      std::vector<Image> pictures;
      for (size_t i = 0; i < backends.size(); ++i) {
        const Graph graph = make_graph(plan, configuration_with(plan, variant), scene, *shaders[i], nullptr, parameters);
        Frame frame(*resources[i], graph, Build::timed);
        frame.run_once(Timing::off);
        frame.run(0, Timing::off);
        pictures.push_back(frame.picture());
        EXPECT_EQ(nonfinite_pixels(pictures.back()), 0u);
      }
      EXPECT_GE(psnr_db(to_display(pictures[0]), to_display(pictures[1])), min_agreement_db);
    }
  }
  for (const auto& backend : backends)
    for (const std::string& message : backend->take_messages()) ADD_FAILURE() << message;
}

}  // namespace lamina
