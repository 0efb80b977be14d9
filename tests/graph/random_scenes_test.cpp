// SPDX-License-Identifier: Apache-2.0
// On random scenes the frame in which only what is called for runs has the picture of the frame in which everything runs, bit
// for bit, and takes the bytes that the plan says. A few here; LAMINA_RANDOM_SCENES=500 takes more, from LAMINA_RANDOM_SEED on.
#include <algorithm>
#include <cstdlib>

#include "harness/graph/everything_graph.h"
#include "harness/graph/target_uses.h"
#include "harness/quality/same_bits.h"
#include "tests/folder.h"
#include "tests/graph/each_backend.h"
#include "tests/graph/made_effects.h"
#include "tests/graph/random_scene.h"

namespace lamina {
namespace {

constexpr uint32_t size_px = 32;
constexpr size_t usual_scenes = 12;

uint64_t number_from(const char* name, uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text && *text ? std::strtoull(text, nullptr, 10) : otherwise;
}

// Maps of a few texels in place of hundreds: what is asked here does not hang on their size.
Parameters small_parameters(const Library& library) {
  Parameters small;
  for (const EffectManifest& effect : library.effects)
    for (const VariantManifest& variant : effect.variants)
      for (const ParameterManifest& parameter : variant.parameters)
        if (parameter.whole && parameter.words.empty() && parameter.value >= 64)
          small[variant.name + "." + parameter.name] = std::max(parameter.min, 32.0);
  return small;
}

class RandomScenes : public InFolder<EachBackend> {
 protected:
  void SetUp() override {
    EachBackend::SetUp();
    if (!backend_) return;
    shaders_.emplace(backend_->info().api, library().shaders);
    parameters_ = small_parameters(library());
  }
  struct Drawn {
    std::vector<Image> pictures;
    uint64_t bytes = 0, told_bytes = 0;
  };
  Drawn drawn(const Scene& scene, const Graph& graph) {
    Bakes bakes(scene, *library().code, DiskCache(""));
    SceneResources resources(*backend_, scene, library(), size_px, size_px, &bakes);
    Frame frame(resources, graph, Build::timed);
    frame.run_once(Timing::off);
    Drawn drawn;
    for (size_t view = 0; view < scene.views.size(); ++view) {
      frame.run(view, Timing::off);
      drawn.pictures.push_back(frame.picture());
    }
    drawn.bytes = frame.target_bytes();
    for (const TargetUse& use : target_uses(graph, scene, size_px, size_px)) drawn.told_bytes += use.bytes;
    return drawn;
  }

  // What is wrong with the scene; "" for nothing. Throws Error where it cannot be loaded or drawn.
  std::string wrong(const RandomScene& random) {
    const Scene scene = load_random(random, folder_, library());
    const Plan plan = make_plan(library(), scene, 1);
    const Graph graph = make_graph(plan, configuration_of(plan, {}), scene, *shaders_, nullptr, parameters_);
    const Scene everything = scene_of_everything(scene, library());
    EverythingPlan all = plan_of_everything(plan, everything);
    const Graph whole = make_graph_of_everything(all, plan, everything, *shaders_, parameters_);
    ran_ += all.plan.effects.size() - all.cannot.size();
    left_out_ += whole.passes.size() - graph.passes.size();
    const Drawn culled = drawn(scene, graph), full = drawn(everything, whole);
    for (size_t view = 0; view < scene.views.size(); ++view)
      if (const BitDifference difference = bit_difference(culled.pictures[view], full.pictures[view]); difference.pixels > 0)
        return fmt::format("view {}: {} pixels differ, by {} at {}, {}", scene.views[view].name, difference.pixels,
                           difference.largest, difference.x, difference.y);
    for (const Drawn* side : {&culled, &full})
      if (side->bytes != side->told_bytes)
        return fmt::format("{} bytes of targets, and the plan says {}", side->bytes, side->told_bytes);
    return "";
  }

  std::optional<ShaderCache> shaders_;
  Parameters parameters_;
  size_t ran_ = 0, left_out_ = 0;
};
INSTANTIATE_TEST_SUITE_P(Backends, RandomScenes, backend_parameters, backend_test_name);

TEST_P(RandomScenes, WhatIsLeftOutChangesNoPixel) {
  const uint64_t first = number_from("LAMINA_RANDOM_SEED", 1), count = number_from("LAMINA_RANDOM_SCENES", usual_scenes);
  size_t drawn_scenes = 0;
  std::map<std::string, size_t> refused;  // by the first words of the reason
  for (uint64_t seed = first; drawn_scenes < count && seed < first + 4 * count; ++seed) {
    const RandomScene random = random_scene(seed, library());
    const auto fails = [&](const RandomScene& scene) {
      try {
        return !wrong(scene).empty();
      } catch (const Error&) {
        return false;
      }
    };
    try {
      const std::string what = wrong(random);
      ++drawn_scenes;
      if (what.empty()) continue;
      const RandomScene least = shrunk(random, fails);
      ADD_FAILURE() << "seed " << seed << ": " << what << "\nshrunk: " << wrong(least) << "\n" << least.text("model.gltf");
      if (testing::Test::HasFailure() && count <= usual_scenes) break;
    } catch (const Error& error) {
      ++refused[std::string(error.what()).substr(0, 160)];
    }
  }
  EXPECT_EQ(drawn_scenes, count) << "too many scenes cannot be drawn";
  if (count < usual_scenes) return;
  EXPECT_GT(ran_, 6 * count) << "the frame of everything holds more than half of the effects";
  EXPECT_GT(left_out_, 4 * count) << "passes that the plan leaves out";
  if (count <= usual_scenes) return;
  for (const auto& [why, times] : refused) fmt::print("not drawn, {} times: {}\n", times, why);
  fmt::print("{} scenes, {} passes left out in them\n", drawn_scenes, left_out_);
}

// Nothing shrinks below what fails.
TEST(ShrunkScenes, KeepOnlyWhatFails) {
  const RandomScene whole = random_scene(3, builtin_library());
  const auto has = [](const RandomScene& scene, RandomScene::Kind kind) {
    return static_cast<size_t>(std::ranges::count(scene.pieces, kind, &RandomScene::Piece::kind));
  };
  ASSERT_GT(has(whole, RandomScene::Kind::light), 0u);
  ASSERT_GT(whole.pieces.size(), 3u);
  const RandomScene least = shrunk(whole, [&](const RandomScene& scene) { return has(scene, RandomScene::Kind::light) > 0; });
  EXPECT_EQ(least.pieces.size(), 2u) << "a light, and an object that every scene needs";
  for (const RandomScene::Piece& piece : least.pieces) EXPECT_TRUE(piece.lines.empty()) << piece.head;
  EXPECT_EQ(random_scene(3, builtin_library()).text(""), whole.text("")) << "a seed gives one scene";
}

}  // namespace
}  // namespace lamina
